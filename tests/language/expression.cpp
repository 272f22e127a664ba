#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "language/evaluate.h"
#include "language/expression_parser.h"
#include "language/functions.h"

namespace lamella::language {
namespace {

Variables some_variables() {
  Variables variables;
  variables.set(variables.id("width"), 3.0);
  variables.set(variables.id("h"), 0.5);
  variables.set(variables.id("name"), std::string("foam"));
  return variables;
}

// The values of the expressions that stand one after the other on a line.
std::vector<Value> values(const std::string& content, ExpressionStyle style) {
  const Variables variables = some_variables();
  ConstantScope scope(variables);
  const LexerMode mode = style == ExpressionStyle::command ? LexerMode::command : LexerMode::datafile;
  LexerStream tokens(Lexer(text::make_source("test", content), mode));
  std::vector<Value> result;
  while (!tokens.peek().ends_line()) {
    ExpressionParser parser(tokens, scope, style);
    result.push_back(evaluate_constant_value(*parser.expression(), variables));
  }
  return result;
}

double value(const std::string& content, ExpressionStyle style = ExpressionStyle::command) {
  const std::vector<Value> all = values(content, style);
  EXPECT_EQ(all.size(), 1U) << content;
  return std::get<double>(all.at(0));
}

std::vector<double> numbers_on_line(const std::string& content) {
  std::vector<double> result;
  for (const Value& each : values(content, ExpressionStyle::values)) result.push_back(std::get<double>(each));
  return result;
}

struct Fault {
  std::string message;
  int line = 0;
  int column = 0;
};

Fault fault(const std::string& content, ExpressionStyle style = ExpressionStyle::values) {
  try {
    values(content, style);
  } catch (const text::Error& error) {
    const text::Diagnostic& diagnostic = error.diagnostics().at(0);
    const text::LineColumn position = text::line_and_column(diagnostic.place);
    return {diagnostic.message + " / " + diagnostic.hint, position.line, position.column};
  }
  return {};
}

struct Case {
  const char* text;
  double value;
};

TEST(Expression, OperatorsBindAndGroupAsTheTableSays) {
  const Case cases[] = {{"2^3^2", 64},      {"2**3", 8},          {"-2^2", -4},
                        {"2^-1", 0.5},      {"2^-1^2", 0.5},      {"2^-1*4", 2},
                        {"2*-3", -6},       {"- -2", 2},          {"+2", 2},
                        {"2+3*4", 14},      {"10-4-3", 3},        {"24/4/2", 3},
                        {"7%3", 1},         {"-3 % 2", 1},        {"7 mod 4", 3},
                        {"-3.5 imod 2", 0}, {"7 idiv 2", 3},      {"-3.5 idiv 2.1", -1},
                        {"-3 idiv 2", -1},  {"3 > 2 > 0", 1},     {"3 > 2 > 1", 1},
                        {"3 < 2", 0},       {"2 <= 2", 1},        {"2 >= 3", 0},
                        {"2 == 2", 1},      {"2 != 2", 0},        {"!0*3", 1},
                        {"!1+1", 0},        {"not 1 == 2", 1},    {"!!5", 1},
                        {"1+!0", 2},        {"1 || 0 && 0", 1},   {"0 or 1 and 1", 1},
                        {"1 ? 5 : 6", 5},   {"0 ? 5 : 6", 6},     {"1?2:0?3:4", 2},
                        {"0?2:0?3:4", 4},   {"1>0?5:6", 5},       {"3=1", 2},
                        {"5=3=1", 1},       {"1 = 2 + 3", -4},    {"(1+2)*3", 9},
                        {"sqr(3)", 9},      {"max(1,2)*3", 6},    {"pow(2,10)", 1024},
                        {"red", 4},         {"clear", -1},        {"width^2", 9},
                        {"WIDTH", 3},       {"3 -2", 1},          {"h*2", 1},
                        {"2 + 1 == 3", 1},  {"1 < 2 && 2 < 3", 1}};
  for (const Case& each : cases) {
    EXPECT_EQ(value(each.text), each.value) << each.text;
  }
  EXPECT_EQ(value("pi"), std::numbers::pi);
  EXPECT_EQ(value("e"), std::numbers::e);
}

TEST(Expression, LogicStopsWhereItIsDecided) {
  EXPECT_EQ(value("0 && 1/0"), 0);
  EXPECT_EQ(value("1 || 1/0"), 1);
  EXPECT_EQ(value("1 ? 2 : 1/0"), 2);
}

TEST(Expression, ASpacedMinusStartsANewValueOnALineOfValues) {
  using V = std::vector<double>;
  EXPECT_EQ(numbers_on_line("3 - 5"), (V{-2}));
  EXPECT_EQ(numbers_on_line("3-5"), (V{-2}));
  EXPECT_EQ(numbers_on_line("3 -5"), (V{3, -5}));
  EXPECT_EQ(numbers_on_line("3 -width*2"), (V{3, -6}));
  EXPECT_EQ(numbers_on_line("3 -(2)"), (V{3, -2}));
  EXPECT_EQ(numbers_on_line("(3 -2) 1"), (V{1, 1}));
  EXPECT_EQ(numbers_on_line("sqr(3 -2) 1"), (V{1, 1}));
  EXPECT_EQ(numbers_on_line("3 +2"), (V{5}));
  EXPECT_EQ(numbers_on_line("3, -5"), (V{3, -5}));
  EXPECT_EQ(numbers_on_line("3, - 5"), (V{3, -5}));
  EXPECT_EQ(numbers_on_line("1 2 1?5:6"), (V{1, 2, 5}));
  EXPECT_EQ(numbers_on_line("maximum(1,2) 3"), (V{2, 3}));
  EXPECT_EQ(numbers_on_line("1 + \\\n 2"), (V{3}));
  EXPECT_EQ(value("3 -2", ExpressionStyle::formula), 1);
}

TEST(Expression, ACommandGoesOnWhereItCannotEnd) {
  EXPECT_EQ(value("1 +\n\n 2"), 3);
  EXPECT_EQ(value("(1\n+ 2\n)"), 3);
  EXPECT_THROW(value("1 +"), Incomplete);
  EXPECT_THROW(value("(1"), Incomplete);
  EXPECT_THROW(value("1 ? 2"), Incomplete);
}

TEST(Expression, Functions) {
  EXPECT_NEAR(value("sin(pi/6)"), 0.5, 1e-15);
  EXPECT_NEAR(value("cosh(1)^2 - sinh(1)^2"), 1, 1e-14);
  EXPECT_NEAR(value("atan2(-1,-1)"), -3 * std::numbers::pi / 4, 1e-15);
  EXPECT_NEAR(value("asinh(1)"), 0.881373587019543, 1e-15);
  EXPECT_EQ(value("ceil(1.2) + floor(-1.2)"), 0);
  EXPECT_NEAR(value("log(exp(2))"), 2, 1e-15);
  EXPECT_EQ(value("acos(1 + 1e-15)"), 0);
  EXPECT_NEAR(value("ellipticK(0.5)"), 1.85407467730137, 1e-13);
  EXPECT_NEAR(value("ellipticE(0.5)"), 1.35064388104768, 1e-13);
  EXPECT_EQ(value("sizeof(\"abc\")"), 3);
  EXPECT_EQ(std::get<std::string>(values("sprintf(\"%s %03d\", name, 7)", ExpressionStyle::command).at(0)),
            "foam 007");
  EXPECT_EQ(std::get<std::string>(values("\"a\" \"b\"", ExpressionStyle::command).at(0)), "ab");
  EXPECT_EQ(value("name == \"foam\""), 1);
  EXPECT_EQ(value("is_defined(\"width\") + is_defined(\"depth\")"), 1);
}

TEST(Expression, EveryFunctionTakesItsArguments) {
  for (const Function& function : functions()) {
    std::string call = std::string(function.name) + "(";
    for (std::size_t i = 0; i < function.arguments; ++i) call += i > 0 ? ",0.5" : "0.5";
    if (function.name != "acosh") {
      EXPECT_TRUE(std::isfinite(value(call + ")"))) << call;
    }
    EXPECT_NE(fault(std::string(function.name) + "(0.5,0.5,0.5)").message.find("argument"), std::string::npos)
        << function.name;
    EXPECT_FALSE(function.summary.empty());
  }
}

struct Broken {
  const char* text;
  int column;
  const char* says;
};

TEST(Expression, FaultsAreShownWhereTheyStand) {
  const Broken cases[] = {
      {"1 +* 2", 4, "*"},
      {"3+", 3, "+"},
      {"2*(1+3", 3, ")"},
      {"(1 2)", 4, "\")\""},
      {"wdith", 1, "did you mean \"width\"?"},
      {"sqroot(2)", 1, "did you mean \"sqrt\"?"},
      {"cos 0", 1, "cos(...)"},
      {"atan2(1)", 1, "2 arguments"},
      {"1/(2-2)", 2, "division by zero"},
      {"5 % 0", 3, "division by zero"},
      {"sqrt(-1)", 1, "negative"},
      {"log(0)", 1, "positive"},
      {"(-2)^0.5", 5, "whole exponents"},
      {"exp(1000)", 1, "too large"},
      {"asin(2)", 1, "between -1 and 1"},
      {"name*2", 1, "number is needed"},
      {"1 ? 2", 6, "\":\""},
      {"vertex", 1, "not defined"},
  };
  for (const Broken& each : cases) {
    const Fault found = fault(each.text);
    EXPECT_EQ(found.column, each.column) << each.text << ": " << found.message;
    EXPECT_NE(found.message.find(each.says), std::string::npos) << each.text << ": " << found.message;
  }
}

TEST(Expression, DepthIsBoundedAndLengthIsNot) {
  EXPECT_NE(fault(std::string(100000, '(') + "1" + std::string(100000, ')')).message.find("deep"),
            std::string::npos);
  EXPECT_NE(fault(std::string(100000, '-') + "1").message.find("deep"), std::string::npos);
  EXPECT_NE(fault(std::string(100000, '!') + "1").message.find("deep"), std::string::npos);
  std::string comparisons = "1";
  std::string conditionals = "1";
  std::string sum = "1";
  for (int i = 0; i < 100000; ++i) {
    comparisons += "<1";
    conditionals += "?1:1";
    sum += "+1";
  }
  EXPECT_NE(fault(comparisons).message.find("deep"), std::string::npos);
  EXPECT_NE(fault(conditionals).message.find("deep"), std::string::npos);
  EXPECT_EQ(value(sum), 100001);
}

}  // namespace
}  // namespace lamella::language
