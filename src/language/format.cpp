#include "language/format.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

#include <fmt/format.h>

#include "text/error.h"

namespace lamella::language {

namespace {

constexpr int widest = 10000;

// A conversion such as %-8.3f, and the values that are left for it and those after it.
class Formatter {
 public:
  Formatter(std::string_view format, std::span<const Value> values) : format_(format), values_(values) {}

  std::string run() {
    std::string result;
    while (at_ < format_.size()) {
      const char c = format_[at_++];
      if (c != '%') {
        result += c;
      } else if (at_ < format_.size() && format_[at_] == '%') {
        result += '%';
        ++at_;
      } else {
        result += conversion();
      }
    }
    if (!values_.empty()) {
      throw text::Error(fmt::format("{} value{} more than the format has places for", values_.size(),
                                    values_.size() == 1 ? "" : "s"));
    }
    return result;
  }

 private:
  const Value& next_value(std::string_view conversion) {
    if (values_.empty())
      throw text::Error(fmt::format("no value is given for \"{}\"", conversion), "add it after a comma");
    const Value& value = values_.front();
    values_ = values_.subspan(1);
    return value;
  }

  double next_number(std::string_view conversion) {
    const Value& value = next_value(conversion);
    if (const double* const number = std::get_if<double>(&value)) return *number;
    throw text::Error(fmt::format("\"{}\" takes a number, and its value is the string \"{}\"", conversion,
                                  std::get<std::string>(value)),
                      "%s takes strings");
  }

  char peek() const { return at_ < format_.size() ? format_[at_] : '\0'; }

  // A width or precision: digits, or `*` for the next value.
  int amount() {
    int result = 0;
    if (peek() == '*') {
      ++at_;
      result = static_cast<int>(std::clamp(next_number("*"), -1.0 * widest, 1.0 * widest));
    }
    while (peek() >= '0' && peek() <= '9') result = std::min(widest, result * 10 + (format_[at_++] - '0'));
    return result;
  }

  std::string conversion() {
    const std::size_t begin = at_ - 1;
    std::string flags;
    while (std::string_view("-+ #0").find(peek()) != std::string_view::npos && peek() != '\0')
      flags += format_[at_++];
    const int width = amount();
    std::optional<int> precision;
    if (peek() == '.') {
      ++at_;
      precision = amount();
    }
    while (std::string_view("hlLqjzt").find(peek()) != std::string_view::npos && peek() != '\0') ++at_;
    const char letter = peek();
    if (letter != '\0') ++at_;
    return write(format_.substr(begin, at_ - begin), "%" + flags + "*.*", width, precision.value_or(-1),
                 letter);
  }

  std::string write(std::string_view written, std::string pattern, int width, int precision, char letter) {
    const auto print = [&](auto value, std::string_view kind) {
      pattern += kind;
      const int length = std::snprintf(nullptr, 0, pattern.c_str(), width, precision, value);
      std::string result(static_cast<std::size_t>(std::max(0, length)) + 1, '\0');
      std::snprintf(result.data(), result.size(), pattern.c_str(), width, precision, value);
      result.pop_back();
      return result;
    };
    const std::string kind(1, letter);
    switch (letter) {
      case 'd':
      case 'i':
      case 'u':
      case 'x':
      case 'X':
      case 'o':
        return print(whole(next_number(written), written), "ll" + kind);
      case 'c':
        return print(static_cast<int>(whole(next_number(written), written)), kind);
      case 'e':
      case 'E':
      case 'f':
      case 'F':
      case 'g':
      case 'G':
      case 'a':
      case 'A':
        return print(next_number(written), kind);
      case 's': {
        const Value& value = next_value(written);
        const std::string* const text = std::get_if<std::string>(&value);
        const std::string content = text != nullptr ? *text : format_number(std::get<double>(value));
        return print(content.c_str(), kind);
      }
      default:
        throw text::Error(fmt::format("\"{}\" is no format", written),
                          "formats are %d %x %c %f %e %g %s, and %% for a percent sign");
    }
  }

  static long long whole(double value, std::string_view written) {
    if (!(std::abs(value) < 9e18))
      throw text::Error(fmt::format("\"{}\" cannot write {}", written, value), "use %g");
    return static_cast<long long>(value);
  }

  std::string_view format_;
  std::span<const Value> values_;
  std::size_t at_ = 0;
};

}  // namespace

std::string format_values(std::string_view format, std::span<const Value> values) {
  return Formatter(format, values).run();
}

std::string format_number(double value) {
  return fmt::format("{:.15g}", value);
}

}  // namespace lamella::language
