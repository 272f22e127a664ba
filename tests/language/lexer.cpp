#include "language/lexer.h"

#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace lamella::language {
namespace {

std::vector<Token> tokens_of(const std::string& content, LexerMode mode) {
  Lexer lexer(text::make_source("test", content), mode);
  std::vector<Token> result;
  for (Token token = lexer.next(); !token.is(TokenKind::end); token = lexer.next()) result.push_back(token);
  return result;
}

// Kind and text of each token, e.g. "w:vertex n:3 s:+ nl".
std::string shape(const std::string& content, LexerMode mode = LexerMode::command) {
  std::string result;
  for (const Token& token : tokens_of(content, mode)) {
    if (!result.empty()) result += ' ';
    switch (token.kind) {
      case TokenKind::newline:
        result += "nl";
        break;
      case TokenKind::number:
        result += "n:" + std::string(token.text);
        break;
      case TokenKind::word:
        result += "w:" + std::string(token.text);
        break;
      case TokenKind::string:
        result += "t:" + token.content;
        break;
      default:
        result += "s:" + std::string(token.text);
    }
  }
  return result;
}

double number(const std::string& content) {
  return tokens_of(content, LexerMode::datafile).at(0).number;
}

struct Fault {
  std::string message;
  int line = 0;
  int column = 0;
};

Fault fault(const std::string& content, LexerMode mode = LexerMode::datafile) {
  try {
    tokens_of(content, mode);
  } catch (const text::Error& error) {
    const text::Diagnostic& diagnostic = error.diagnostics().at(0);
    const text::LineColumn position = text::line_and_column(diagnostic.place);
    return {diagnostic.message + " / " + diagnostic.hint, position.line, position.column};
  }
  return {};
}

TEST(Lexer, NumbersInAllForms) {
  EXPECT_EQ(number("2"), 2);
  EXPECT_EQ(number(".5"), 0.5);
  EXPECT_EQ(number("23."), 23);
  EXPECT_EQ(number("5e-10"), 5e-10);
  EXPECT_EQ(number("0.7D2"), 70);
  EXPECT_EQ(number("1d+1"), 10);
  EXPECT_EQ(number("0x12Af"), 4783);
  EXPECT_EQ(number("11001b"), 25);
  EXPECT_EQ(number("1e-999"), 0);
  EXPECT_EQ(number("007"), 7);
}

TEST(Lexer, MalformedNumbersAreOneFaultEach) {
  for (const char* written : {"1.2.3", "12abc", "5x", "1e3.5", "0x", "0xg", "12b", "1..2", "5e", "2.x"}) {
    const Fault found = fault(std::string("7 ") + written + " 8");
    EXPECT_NE(found.message.find(written), std::string::npos) << written << ": " << found.message;
    EXPECT_EQ(found.column, 3) << written;
  }
  EXPECT_NE(fault("1e999").message.find("too large"), std::string::npos);
}

TEST(Lexer, DatafileWhiteSpace) {
  EXPECT_EQ(shape("1,2:3;4\t5\x1a"
                  "6",
                  LexerMode::datafile),
            "n:1 n:2 n:3 n:4 n:5 n:6");
  const auto tokens = tokens_of("1, -2 - 3 -4", LexerMode::datafile);
  EXPECT_EQ(tokens.at(1).separator, ',');
  EXPECT_TRUE(tokens.at(1).space_before);
  EXPECT_FALSE(tokens.at(2).space_before);
  EXPECT_TRUE(tokens.at(4).space_before);
  EXPECT_EQ(tokens.at(4).separator, 0);
  EXPECT_EQ(shape("#define a 3", LexerMode::datafile), "s:# w:define w:a n:3");
}

TEST(Lexer, CommandSymbols) {
  EXPECT_EQ(shape("a:=b+c;d+=1;e++ >> \"f\" >>> x ** 2"),
            "w:a s::= w:b s:+ w:c s:; w:d s:+= n:1 s:; w:e s:++ s:>> t:f s:>>> w:x s:** n:2");
  EXPECT_EQ(shape("vertex[1].x"), "w:vertex s:[ n:1 s:] s:. w:x");
  EXPECT_EQ(shape("2--3", LexerMode::datafile), "n:2 s:- s:- n:3");
}

TEST(Lexer, LineEndsAndContinuation) {
  EXPECT_EQ(shape("a\nb\r\nc\rd"), "w:a nl w:b nl w:c nl w:d");
  EXPECT_EQ(shape("a \\\nb \\\r\nc"), "w:a w:b w:c");
  EXPECT_EQ(shape("a // b \\\nc"), "w:a nl w:c");
  EXPECT_EQ(shape("a /* b\n c */ d"), "w:a w:d");
  EXPECT_EQ(shape("\xEF\xBB\xBFvertices"), "w:vertices");
}

TEST(Lexer, Strings) {
  EXPECT_EQ(tokens_of(R"("a\n\tb\q\"\\\z")", LexerMode::datafile).at(0).content, "a\n\tb\"\"\\z");
  EXPECT_EQ(tokens_of("\"two\nlines\"", LexerMode::command).at(0).content, "twolines");
  EXPECT_EQ(fault("version \"2.10\nvertices").column, 9);
}

TEST(Lexer, OpenCommentIsShownWhereItOpens) {
  const Fault found = fault("a\n  /* b\nc\n");
  EXPECT_EQ(found.line, 2);
  EXPECT_EQ(found.column, 3);
  EXPECT_THROW(tokens_of("/*", LexerMode::command), Incomplete);
}

TEST(Lexer, StrangeCharacters) {
  EXPECT_NE(fault("1 2 $").message.find("\"$\""), std::string::npos);
  EXPECT_EQ(fault("1 2 $").column, 5);
  EXPECT_NE(fault("0 \xC3\xA9tat").message.find("\xC3\xA9"), std::string::npos);
  EXPECT_NE(fault(std::string("vertices 0 0 1 \0 1", 18)).message.find("0x00"), std::string::npos);
  EXPECT_NE(fault("1 \xE2\x88\x92 2").message.find("minus"), std::string::npos);
  const Fault utf16 = fault(std::string("\xFF\xFEv\0e\0", 6));
  EXPECT_NE(utf16.message.find("UTF-16"), std::string::npos);
  const Fault binary = fault("\x89\x01\x02\x03 text \xFF\xFE\x80");
  EXPECT_NE(binary.message.find("not a text file"), std::string::npos);
  EXPECT_EQ(binary.line, 1);
}

TEST(Lexer, GoesOnAfterAFault) {
  Lexer lexer(text::make_source("test", "1 2x 3"), LexerMode::datafile);
  EXPECT_EQ(lexer.next().number, 1);
  EXPECT_THROW(lexer.next(), text::Error);
  EXPECT_EQ(lexer.next().number, 3);
  EXPECT_TRUE(lexer.next().is(TokenKind::end));
  EXPECT_TRUE(lexer.next().is(TokenKind::end));
}

TEST(Lexer, PartOfASource) {
  const text::SourcePointer source = text::make_source("test", "one two three");
  Lexer lexer(text::Place{source, 4, 3}, LexerMode::command);
  const Token token = lexer.next();
  EXPECT_EQ(token.text, "two");
  EXPECT_EQ(token.place.offset, 4U);
  EXPECT_TRUE(lexer.next().is(TokenKind::end));
}

TEST(LexerStream, PeeksTakesAndPassesOverLineEndsInBrackets) {
  LexerStream stream(Lexer(text::make_source("test", "( a\nb\n) c\nd"), LexerMode::command));
  EXPECT_EQ(stream.take().text, "(");
  {
    const Brackets brackets(stream);
    EXPECT_EQ(stream.peek(1).text, "b");
    EXPECT_EQ(stream.peek(3).text, "c");
    EXPECT_EQ(stream.take().text, "a");
    EXPECT_EQ(stream.take().text, "b");
    EXPECT_EQ(stream.take().text, ")");
  }
  EXPECT_EQ(stream.take().text, "c");
  EXPECT_TRUE(stream.take().is(TokenKind::newline));
  EXPECT_EQ(stream.take().text, "d");
  EXPECT_TRUE(stream.take().is(TokenKind::end));
}

TEST(LexerStream, BareWordsAreFileNames) {
  LexerStream stream(Lexer(text::make_source("test", "show ../a/b-c.2.png; next"), LexerMode::command));
  EXPECT_EQ(stream.take().text, "show");
  EXPECT_EQ(stream.take_bare_word().content, "../a/b-c.2.png");
  EXPECT_TRUE(stream.take().is_symbol(";"));
  EXPECT_EQ(stream.take().text, "next");
}

}  // namespace
}  // namespace lamella::language
