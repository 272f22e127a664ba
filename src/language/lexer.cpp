#include "language/lexer.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdlib>
#include <limits>
#include <optional>

#include <fmt/format.h>

namespace lamella::language {

namespace {

constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
constexpr char control_z = 26;

bool is_digit(char c) {
  return c >= '0' && c <= '9';
}
bool is_letter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
}
bool is_binary_digit(char c) {
  return c == '0' || c == '1';
}
bool is_hexadecimal_digit(char c) {
  return is_digit(c) || (c >= 'a' && c <= 'f') || (c >= 'A' && c <= 'F');
}

// Longest first, so that the first match is the right one.
constexpr std::array<std::string_view, 18> long_command_symbols = {
    ":::=", "::=", ">>>", ":=", "+=", "-=", "*=", "/=", "++",
    "--",   ">>",  "==",  "!=", "<=", ">=", "&&", "||", "**"};
constexpr std::array<std::string_view, 7> long_datafile_symbols = {"==", "!=", "<=", ">=", "&&", "||", "**"};
constexpr std::string_view command_symbols = "+-*/%^()[]{}<>=!?.|&,:;";
constexpr std::string_view datafile_symbols = "+-*/%^()[]{}<>=!?.|&#";

// The length of a well-formed UTF-8 sequence at the start of `bytes`, or 0.
std::size_t utf8_length(std::string_view bytes) {
  const auto lead = static_cast<unsigned char>(bytes.front());
  const std::size_t length = lead < 0x80U        ? 1
                             : lead >> 5U == 6U  ? 2
                             : lead >> 4U == 14U ? 3
                             : lead >> 3U == 30U ? 4
                                                 : 0;
  if (length == 0 || bytes.size() < length) return 0;
  for (std::size_t i = 1; i < length; ++i) {
    if ((static_cast<unsigned char>(bytes[i]) & 0xC0U) != 0x80U) return 0;
  }
  return length;
}

bool is_control(char c) {
  const auto byte = static_cast<unsigned char>(c);
  return (byte < 32U && c != '\t' && c != '\n' && c != '\r' && c != '\f' && c != control_z) || byte == 127U;
}

// Whether the first bytes look like something no text editor wrote.
bool looks_binary(std::string_view content) {
  const std::string_view head = content.substr(0, 512);
  std::size_t odd = 0;
  for (std::size_t i = 0; i < head.size();) {
    const std::size_t length = utf8_length(content.substr(i, 4));
    if (length == 0 || is_control(head[i])) ++odd;
    i += std::max<std::size_t>(1, length);
  }
  return odd * 10 > head.size();
}

std::optional<double> whole_number(std::string_view digits, int base) {
  double value = 0;
  if (digits.empty()) return std::nullopt;
  for (const char c : digits) {
    if (base == 2 ? !is_binary_digit(c) : !is_hexadecimal_digit(c)) return std::nullopt;
    const int digit = is_digit(c) ? c - '0' : (c | 0x20) - 'a' + 10;
    value = value * base + digit;
  }
  return value;
}

// A decimal number with its exponent marked by e, E, d or D; nothing if malformed, infinite if too large.
std::optional<double> decimal_number(std::string_view written) {
  std::string plain(written);
  for (char& c : plain) {
    if (c == 'd' || c == 'D') c = 'e';
  }
  double value = 0;
  const char* const last = plain.data() + plain.size();
  const auto [end, code] = std::from_chars(plain.data(), last, value);
  if (code == std::errc::invalid_argument || end != last) return std::nullopt;
  // Too large or too small to hold: infinity or zero.
  return code == std::errc::result_out_of_range ? std::strtod(plain.c_str(), nullptr) : value;
}

bool starts_with_base(std::string_view written) {
  return written.size() >= 2 && written[0] == '0' && (written[1] == 'x' || written[1] == 'X');
}

std::optional<double> number_value(std::string_view written) {
  if (starts_with_base(written)) return whole_number(written.substr(2), 16);
  if (written.back() == 'b' || written.back() == 'B')
    return whole_number(written.substr(0, written.size() - 1), 2);
  return decimal_number(written);
}

// Characters that a word processor puts in place of plain ones.
std::string_view plain_character(std::string_view character) {
  if (character == "\xE2\x80\x9C" || character == "\xE2\x80\x9D") return "a straight quote \"";
  if (character == "\xE2\x88\x92" || character == "\xE2\x80\x93") return "a minus sign -";
  if (character == "\xC2\xA0" || character == "\xE2\x80\xAF") return "an ordinary space";
  return {};
}

}  // namespace

Lexer::Lexer(text::SourcePointer source, LexerMode mode)
    : source_(std::move(source)), content_(source_->content), mode_(mode) {
  if (content_.size() > std::numeric_limits<std::uint32_t>::max()) {
    throw text::Error(fmt::format("{} is too large: more than 4 GB", source_->name));
  }
  end_ = static_cast<std::uint32_t>(content_.size());
  if (content_.starts_with("\xFF\xFE") || content_.starts_with("\xFE\xFF")) {
    throw text::Error(place(0, 1), "this text is in UTF-16", "save it as UTF-8 or plain ASCII");
  }
  if (content_.starts_with(byte_order_mark)) at_ = static_cast<std::uint32_t>(byte_order_mark.size());
}

Lexer::Lexer(const text::Place& part, LexerMode mode) : Lexer(part.source, mode) {
  at_ = std::min(std::max(at_, part.offset), end_);
  end_ = std::min(end_, part.offset + part.length);
}

// 1 for LF or CR, 2 for CR LF, 0 if no line ends here.
std::uint32_t Lexer::line_end_length(std::uint32_t offset) const {
  if (offset >= end_) return 0;
  if (content_[offset] == '\n') return 1;
  if (content_[offset] == '\r') return byte(offset + 1) == '\n' ? 2 : 1;
  return 0;
}

// Passes over a comment if one begins here.
bool Lexer::skip_comment() {
  if (byte(at_) != '/') return false;
  if (byte(at_ + 1) == '/') {
    while (at_ < end_ && line_end_length(at_) == 0) ++at_;
    return true;
  }
  if (byte(at_ + 1) != '*') return false;
  const std::uint32_t opened = at_;
  const std::size_t close = content_.substr(0, end_).find("*/", at_ + 2);
  if (close == std::string_view::npos) {
    at_ = end_;
    throw Incomplete(place(opened, 2), "this comment is never closed", "close it with */");
  }
  at_ = static_cast<std::uint32_t>(close) + 2;
  return true;
}

Lexer::Space Lexer::skip_space() {
  Space space;
  while (at_ < end_) {
    const char c = content_[at_];
    const bool separator = mode_ == LexerMode::datafile && (c == ',' || c == ':' || c == ';');
    if (c == ' ' || c == '\t' || c == '\f' || c == control_z || separator) {
      if (separator) space.separator = c;
      ++at_;
    } else if (c == '\\' && line_end_length(at_ + 1) > 0) {
      at_ += 1 + line_end_length(at_ + 1);
    } else if (!skip_comment()) {
      break;
    }
    space.any = true;
  }
  return space;
}

Token Lexer::token(TokenKind kind, std::uint32_t begin) const {
  Token result;
  result.kind = kind;
  result.text = content_.substr(begin, at_ - begin);
  result.place = place(begin, at_ - begin);
  return result;
}

Token Lexer::next() {
  const Space space = skip_space();
  const std::uint32_t begin = at_;
  Token result;
  const char c = byte(at_);
  if (at_ >= end_) {
    result = token(TokenKind::end, begin);
  } else if (line_end_length(at_) > 0) {
    at_ += line_end_length(at_);
    result = token(TokenKind::newline, begin);
    result.place.length = 1;
  } else if (is_digit(c) || (c == '.' && is_digit(byte(at_ + 1)))) {
    result = number();
  } else if (is_letter(c)) {
    while (is_letter(byte(at_)) || is_digit(byte(at_))) ++at_;
    result = token(TokenKind::word, begin);
  } else if (c == '"') {
    result = string();
  } else if (mode_ == LexerMode::command && c == '\'' && is_letter(byte(at_ + 1)) && byte(at_ + 2) == '\'') {
    result = quoted_letter();
  } else {
    result = symbol();
  }
  result.space_before = space.any;
  result.separator = space.separator;
  return result;
}

// Takes everything that sticks to the number, so that `1.2.3` and `5x` are each one mistake.
Token Lexer::number() {
  const std::uint32_t begin = at_;
  bool exponent_possible = !starts_with_base(content_.substr(at_, 2));
  while (is_digit(byte(at_)) || is_letter(byte(at_)) || byte(at_) == '.') {
    const char c = byte(at_++);
    const bool exponent = c == 'e' || c == 'E' || c == 'd' || c == 'D';
    const bool sign = byte(at_) == '+' || byte(at_) == '-';
    if (exponent_possible && exponent && sign && is_digit(byte(at_ + 1))) ++at_;
    exponent_possible = exponent_possible && (is_digit(c) || c == '.');
  }
  Token result = token(TokenKind::number, begin);
  const std::optional<double> value = number_value(result.text);
  if (!value) {
    throw text::Error(result.place, fmt::format("{} is not a number", describe(result)),
                      "numbers look like 2, .5, 23., 5e-10, 0x12af or 11001b");
  }
  if (*value > std::numeric_limits<double>::max()) {
    throw text::Error(result.place, fmt::format("the number {} is too large", result.text),
                      "the largest number is about 1.8e308");
  }
  result.number = *value;
  return result;
}

Token Lexer::string() {
  const std::uint32_t begin = at_++;
  std::string content;
  while (byte(at_) != '"' || at_ >= end_) {
    const std::uint32_t line_end = line_end_length(at_);
    if (at_ >= end_ || (line_end > 0 && mode_ == LexerMode::datafile)) {
      throw Incomplete(place(begin, 1), "this string is never closed", "close it with \"");
    }
    const char c = content_[at_];
    if (line_end > 0) {
      at_ += line_end;  // a line end inside a string is no part of it
    } else if (c == '\\' && line_end_length(at_ + 1) > 0) {
      at_ += 1 + line_end_length(at_ + 1);
    } else if (c == '\\' && at_ + 1 < end_) {
      const char escaped = content_[at_ + 1];
      content += escaped == 'n'   ? '\n'
                 : escaped == 't' ? '\t'
                 : escaped == 'r' ? '\r'
                 : escaped == 'b' ? '\b'
                 : escaped == 'q' ? '"'
                                  : escaped;
      at_ += 2;
    } else {
      content += c;
      ++at_;
    }
  }
  ++at_;
  Token result = token(TokenKind::string, begin);
  result.content = std::move(content);
  return result;
}

// A command of one letter with the meaning that it had at first.
Token Lexer::quoted_letter() {
  const std::uint32_t begin = at_;
  at_ += 3;
  Token result = token(TokenKind::word, begin);
  result.content = std::string(result.text);
  result.text = result.text.substr(1, 1);
  return result;
}

Token Lexer::symbol() {
  const std::uint32_t begin = at_;
  const std::string_view rest = content_.substr(at_, std::min<std::uint32_t>(4, end_ - at_));
  const auto match = [&](const auto& symbols) {
    for (const std::string_view symbol : symbols) {
      if (rest.starts_with(symbol)) return symbol.size();
    }
    return std::size_t{0};
  };
  const bool command = mode_ == LexerMode::command;
  std::size_t length = command ? match(long_command_symbols) : match(long_datafile_symbols);
  const std::string_view single = command ? command_symbols : datafile_symbols;
  if (length == 0 && single.find(rest.front()) != std::string_view::npos) length = 1;
  if (length == 0) refuse_byte();
  at_ += static_cast<std::uint32_t>(length);
  return token(TokenKind::symbol, begin);
}

void Lexer::refuse_byte() {
  if (looks_binary(content_)) {
    at_ = end_;
    throw text::Error(place(0, 1), "this is not a text file", "a datafile is plain text in ASCII or UTF-8");
  }
  const std::uint32_t begin = at_;
  const std::string_view rest = content_.substr(at_, end_ - at_);
  const std::size_t length = utf8_length(rest);
  at_ += static_cast<std::uint32_t>(std::max<std::size_t>(1, length));
  const std::string_view character = rest.substr(0, length);
  if (length == 0 || is_control(rest.front())) {
    const auto value = static_cast<unsigned>(static_cast<unsigned char>(rest.front()));
    throw text::Error(place(begin, 1), fmt::format("unexpected character: byte 0x{:02x}", value));
  }
  const std::string_view plain = plain_character(character);
  throw text::Error(place(begin, static_cast<std::uint32_t>(length)),
                    fmt::format("unexpected character \"{}\"", character),
                    plain.empty() ? std::string{} : fmt::format("write {} instead", plain));
}

const Token& LexerStream::peek(std::size_t ahead) {
  std::size_t at = 0;
  while (true) {
    while (ahead_.size() <= at) ahead_.push_back(lexer_.next());
    const bool passed_over = brackets_ > 0 && ahead_[at].is(TokenKind::newline);
    if (!passed_over && ahead-- == 0) return ahead_[at];
    if (ahead_[at].is(TokenKind::end)) return ahead_[at];
    ++at;
  }
}

Token LexerStream::take() {
  peek();
  while (brackets_ > 0 && ahead_.front().is(TokenKind::newline)) ahead_.pop_front();
  Token result = std::move(ahead_.front());
  ahead_.pop_front();  // at the end the lexer gives another
  previous_end_ = result.place.offset + result.place.length;
  return result;
}

void LexerStream::rewind(std::uint32_t mark) {
  ahead_.clear();
  lexer_.seek(mark);
  previous_end_ = mark;
}

std::string_view LexerStream::text_from(std::uint32_t offset) const {
  const std::string_view rest = std::string_view(lexer_.source()->content).substr(0, lexer_.end());
  const std::size_t begin = rest.find_first_not_of(" \t", offset);
  return begin == std::string_view::npos ? std::string_view{} : rest.substr(begin);
}

std::string_view LexerStream::text_after_next() {
  const text::Place& next = peek().place;
  return text_from(next.offset + next.length);
}

std::string_view LexerStream::bare_word_ahead() const {
  const std::string_view ahead = text_ahead();
  for (const std::string_view no_word : {"//", "/*", ">", "|"}) {
    if (ahead.starts_with(no_word)) return {};
  }
  return ahead.substr(0, ahead.find_first_of(" \t\r\n\f;,{}()\""));
}

Token LexerStream::take_bare_word() {
  const std::string_view word = bare_word_ahead();
  const auto begin = static_cast<std::uint32_t>(text_ahead().data() - lexer_.source()->content.data());
  rewind(begin + static_cast<std::uint32_t>(word.size()));
  Token result;
  result.kind = TokenKind::word;
  result.space_before = true;
  result.text = word;
  result.content = std::string(word);
  result.place = {lexer_.source(), begin, static_cast<std::uint32_t>(word.size())};
  return result;
}

}  // namespace lamella::language
