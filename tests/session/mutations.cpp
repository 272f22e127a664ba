// Text that nobody would type: it may be refused, it must not crash.
#include <random>

#include "support/trial.h"

namespace lamella::trial {
namespace {

constexpr const char* statements[] = {
    "foreach vertex vv where vv.id < 4 do { print vv.x; if vv.z > 0 then break else continue }",
    "for (i := 0; i < 10; i++) { x := i^2 + sin(i); printf \"%d %g\\n\", i, x }",
    "gogo := { refine; relax 10; { g 5; u } 3 } // comment\nprocedure pp(real a, integer b) { local c; c := "
    "a*b; print c }",
    "set edge ee color red where ee.length > 0.5 and not ee.fixed; list facet[3].edge[1].vertex > \"out\"",
    "define vertex attribute heat real[3][2]; vertex[1].heat[2][1] := 3; print vertex[1].heat",
    "if max(edge, length) >= 0.1 && count(facet where color == clear, 1) != 3 then evolve 10 dt=0.1 else vc "
    "1 2.5 over 3",
    "show \"a.png\" from (1, -2, 0.5) width 640; load datafiles/cube.fe; save; help refine; undo 2",
    "function real ff(real a) { if a <= 1 then return 1; return a*ff(a - 1) } /* open",
};

constexpr const char* expressions[] = {
    "-2^-1*(3 + 4)/5 % 2 == 1 || !0 && not 1",
    "sum(facet ff where ff.color == red, ff.area*sqr(ff.x)) - max(edge, length)",
    "vertex[facet[2].edge[1].vertex[2].id].__x[3] = body[1].volume",
    "1 ? 2 : 3 ? atan2(1, 2) : sprintf(\"%5.2f %s\", 0x1f, \"a\\qb\")",
    "is_defined(\"x\") + sizeof(\"abc\") + valid_element(edge[99]) idiv 2 imod 3 mod 4",
    "1e10 + .5 - 23. + 5e-10*0.7D2 + 11001b",
};

// Bytes replaced, left out, doubled, and pieces moved.
std::string mutated(std::string text, std::mt19937& random) {
  constexpr std::string_view bytes = "(){}[];,.:=<>!?|&+-*/%^\"\\\n\t #$_09aez\x80\xff";
  const auto below = [&](std::size_t n) {
    return std::uniform_int_distribution<std::size_t>(0, n - 1)(random);
  };
  const std::size_t changes = 1 + below(4);
  for (std::size_t i = 0; i < changes && !text.empty(); ++i) {
    const std::size_t at = below(text.size());
    switch (below(5)) {
      case 0:
        text[at] = bytes[below(bytes.size())];
        break;
      case 1:
        text.erase(at, 1 + below(4));
        break;
      case 2:
        text.insert(at, 1, bytes[below(bytes.size())]);
        break;
      case 3:
        text.insert(at, text.substr(below(text.size()), 1 + below(20)));
        break;
      default:
        text.resize(at);
        break;
    }
  }
  return text;
}

TEST(Mutations, OfStatementsAreParsedOrRefused) {
  Trial trial("cube.fe");
  std::mt19937 random(1);
  for (int round = 0; round < 3000; ++round) {
    for (const char* const statement : statements) {
      const text::SourcePointer source = text::make_source("test", mutated(statement, random));
      trial.session().is_complete({source, 0, static_cast<std::uint32_t>(source->content.size())});
    }
  }
}

TEST(Mutations, OfExpressionsHaveAValueOrAnError) {
  Trial trial("cube.fe");
  std::mt19937 random(2);
  ::testing::internal::CaptureStdout();
  ::testing::internal::CaptureStderr();
  for (int round = 0; round < 2000; ++round) {
    for (const char* const expression : expressions) {
      const std::string text = mutated(expression, random);
      // Nothing but values: no files, no other programs, no other commands.
      if (text.find_first_of(";{}|>\n") != std::string::npos) continue;
      trial.session().run(text::make_source("test", "print " + text));
    }
  }
  trial.session().output().flush();
  ::testing::internal::GetCapturedStdout();
  ::testing::internal::GetCapturedStderr();
  EXPECT_EQ(trial.number("vertex_count"), 14);
}

}  // namespace
}  // namespace lamella::trial
