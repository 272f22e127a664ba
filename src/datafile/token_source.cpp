#include "datafile/token_source.h"

#include <algorithm>
#include <filesystem>
#include <limits>
#include <optional>

#include <fmt/format.h>

#include "datafile/include_files.h"
#include "datafile/plain_numbers.h"

namespace lamella::datafile {

namespace {

namespace files = std::filesystem;
using language::Token;
using language::TokenKind;

constexpr std::size_t most_sources = 10000;
// What one use of a macro may grow to: a dozen lines of doubling macros would fill the memory.
constexpr std::size_t most_macro_tokens = 100000;

text::SourcePointer read_included(const std::string& path, const Token& name) {
  std::error_code ignored;
  if (files::is_directory(path, ignored)) {
    throw Unreadable(name.place, fmt::format("\"{}\" is a folder, not a file", name.content));
  }
  try {
    return read_text(path);
  } catch (const text::Error& error) {
    throw Unreadable(name.place, error.diagnostics().front().message);
  }
}

}  // namespace

void PlainRow::clear() {
  values.clear();
  spots.clear();
  complete = false;
}

TokenSource::TokenSource(text::SourcePointer file) {
  std::string path = canonical_path_of(file->name);
  open(std::move(file), std::move(path), {});
}

void TokenSource::open(text::SourcePointer source, std::string canonical_path,
                       const text::Place& included_at) {
  sources_.push_back(source);
  files_.push_back({language::Lexer(std::move(source), language::LexerMode::datafile),
                    std::move(canonical_path), included_at});
}

const Token& TokenSource::peek(std::size_t ahead) {
  while (ahead_.size() <= ahead) {
    try {
      ahead_.push_back(next());
    } catch (const text::Error&) {
      if (ahead_.empty()) at_line_start_ = false;  // what could not be read is passed over
      throw;
    }
  }
  return ahead_[ahead];
}

Token TokenSource::take() {
  peek();
  Token result = std::move(ahead_.front());
  ahead_.pop_front();
  at_line_start_ = result.is(TokenKind::newline);
  return result;
}

void TokenSource::skip_line() {
  while (true) {
    try {
      while (!peek().ends_line()) take();
      return;
    } catch (const Unreadable&) {
      throw;
    } catch (const language::Incomplete&) {
      throw;
    } catch (const text::Error&) {
      // One mistake has been found on this line already.
    }
  }
}

void TokenSource::next_line() {
  skip_line();
  while (true) {
    try {
      while (peek().is(TokenKind::newline)) take();
      at_line_start_ = true;
      return;
    } catch (const Unreadable&) {
      throw;
    } catch (const language::Incomplete&) {
      throw;
    } catch (const text::Error&) {
      skip_line();
    }
  }
}

Token TokenSource::next() {
  while (true) {
    if (!expanded_.empty()) {
      Token result = std::move(expanded_.front());
      expanded_.pop_front();
      return result;
    }
    Token token = files_.back().lexer.next();
    if (token.is(TokenKind::end) && files_.size() > 1) {
      files_.pop_back();
      token.kind = TokenKind::newline;
      return token;
    }
    if (token.is_symbol("#")) {
      const std::size_t depth = files_.size();
      directive(token);
      if (files_.size() == depth) continue;
      token.kind = TokenKind::newline;  // an included file begins on a line of its own
      return token;
    }
    if (!token.is(TokenKind::word) || macros_.empty()) return token;
    const auto macro = macros_.find(token.text);
    if (macro == macros_.end()) return token;
    std::vector<std::string> active;
    std::vector<Token> tokens;
    expand(macro->first, token, active, tokens);
    std::move(tokens.begin(), tokens.end(), std::back_inserter(expanded_));
  }
}

void TokenSource::directive(const Token& hash) {
  const Token word = files_.back().lexer.next();
  if (word.is_word("define")) {
    define(hash);
  } else if (word.is_word("include")) {
    include(hash);
  } else {
    const std::string name = word.ends_line() ? "#" : fmt::format("#{}", word.text);
    throw text::Error(word.ends_line() ? hash.place : language::join(hash.place, word.place),
                      fmt::format("unknown directive {}", name),
                      "there are #define NAME text and #include \"file\"");
  }
}

void TokenSource::define(const Token& hash) {
  language::Lexer& lexer = files_.back().lexer;
  const Token name = lexer.next();
  if (!name.is(TokenKind::word)) {
    if (name.ends_line()) lexer.seek(name.place.offset);
    throw text::Error(language::join(hash.place, name.place), "#define needs a name",
                      "write #define NAME text");
  }
  Macro macro;
  macro.place = name.place;
  while (true) {
    const std::uint32_t before = lexer.offset();
    Token token = lexer.next();
    if (token.ends_line()) {
      lexer.seek(before);
      break;
    }
    macro.tokens.push_back(std::move(token));
  }
  macros_[std::string(name.text)] = std::move(macro);
}

void TokenSource::include(const Token& hash) {
  const Token name = files_.back().lexer.next();
  if (!name.is(TokenKind::string)) {
    if (name.ends_line()) files_.back().lexer.seek(name.place.offset);
    throw Unreadable(name.ends_line() ? hash.place : name.place,
                     "the name of an included file stands in quotes", "write #include \"file\"");
  }
  const std::optional<std::string> path =
      find_included(name.content, files_.back().lexer.source()->name, sources_.front()->name);
  if (!path) {
    throw Unreadable(
        name.place, fmt::format("cannot find the file \"{}\"", name.content),
        "it is looked for beside this file, beside the datafile, and in the folders of EVOLVERPATH");
  }
  std::string canonical_path = canonical_path_of(*path);
  refuse_loop(canonical_path, name);
  if (sources_.size() >= most_sources) throw Unreadable(name.place, "too many files are included");
  open(read_included(*path, name), std::move(canonical_path), name.place);
}

void TokenSource::refuse_loop(const std::string& canonical_path, const Token& name) const {
  const auto again = std::find_if(files_.begin(), files_.end(), [&](const OpenFile& file) {
    return file.canonical_path == canonical_path;
  });
  if (again == files_.end()) return;
  const auto file_name = [](const OpenFile& file) {
    return files::path(file.lexer.source()->name).filename().string();
  };
  std::string chain;
  text::Diagnostic diagnostic;
  for (auto file = again; file != files_.end(); ++file) {
    chain += fmt::format("{} includes ", file_name(*file));
    if (!file->included_at.known()) continue;
    diagnostic.notes.push_back({file->included_at, fmt::format("{} is included here", file_name(*file))});
  }
  diagnostic.place = name.place;
  diagnostic.message = fmt::format("a file includes itself: {}{}", chain, file_name(*again));
  throw Unreadable(std::move(diagnostic));
}

// Appends what stands for a macro, macros inside it replaced as well; `active` are the macros being replaced.
void TokenSource::expand(const std::string& name, const Token& use, std::vector<std::string>& active,
                         std::vector<Token>& into) const {
  const Macro& macro = macros_.find(name)->second;
  if (std::find(active.begin(), active.end(), name) != active.end()) {
    throw text::Error({text::Severity::error,
                       use.place,
                       fmt::format("the macro {} leads to itself", name),
                       {},
                       {{macro.place, "it is defined here"}}});
  }
  active.push_back(name);
  bool first = true;
  for (const Token& token : macro.tokens) {
    if (into.size() >= most_macro_tokens) {
      throw text::Error(use.place,
                        fmt::format("the macro {} grows to more than {} words", name, most_macro_tokens));
    }
    const auto inner = token.is(TokenKind::word) ? macros_.find(token.text) : macros_.end();
    if (inner != macros_.end()) {
      Token nested = use;
      if (!first) nested.space_before = token.space_before;
      if (!first) nested.separator = token.separator;
      expand(inner->first, nested, active, into);
    } else {
      into.push_back(token);
      into.back().place = use.place;
      if (first) into.back().space_before = use.space_before;
      if (first) into.back().separator = use.separator;
    }
    first = false;
  }
  active.pop_back();
}

Spot TokenSource::spot(const text::Place& place) const {
  Spot result;
  result.offset = place.offset;
  result.length = static_cast<std::uint16_t>(
      std::min<std::uint32_t>(place.length, std::numeric_limits<std::uint16_t>::max()));
  for (std::size_t i = sources_.size(); i-- > 0;) {
    if (sources_[i] == place.source) result.source = static_cast<std::uint16_t>(i);
  }
  return result;
}

text::Place TokenSource::place(Spot spot) const {
  return {sources_[spot.source], spot.offset, spot.length};
}

// Numbers and blanks from byte `at` on. Returns where something else stands.
std::uint32_t TokenSource::scan_numbers(std::uint32_t at, PlainRow& row) const {
  const language::Lexer& lexer = files_.back().lexer;
  const std::string_view content = std::string_view(lexer.source()->content).substr(0, lexer.end());
  const std::uint16_t source = spot({lexer.source(), 0, 0}).source;
  while (true) {
    at = skip_blanks(content, at);
    double value = 0;
    const std::uint32_t length = plain_number(content, at, value);
    if (length == 0) return at;
    row.values.push_back(value);
    row.spots.push_back({at, source, static_cast<std::uint16_t>(length)});
    at += length;
  }
}

// The last number may be part of a formula, so tokens begin with it.
void TokenSource::give_back_last(std::uint32_t begin, PlainRow& row) {
  if (!row.values.empty()) {
    row.values.pop_back();
    row.spots.pop_back();
  }
  files_.back().lexer.seek(row.values.empty() ? begin : row.spots.back().offset + row.spots.back().length);
}

void TokenSource::take_plain_row(PlainRow& row) {
  row.clear();
  if (!ahead_.empty() || !expanded_.empty()) return;
  language::Lexer& lexer = files_.back().lexer;
  const std::string_view content = std::string_view(lexer.source()->content).substr(0, lexer.end());
  std::uint32_t begin = lexer.offset();
  while (line_end_length(content, skip_blanks(content, begin)) > 0) {
    begin = skip_blanks(content, begin);
    begin += line_end_length(content, begin);
  }
  const std::uint32_t at = scan_numbers(begin, row);
  const std::uint32_t line_end = line_end_length(content, at);
  if (row.values.empty() || (line_end == 0 && at < content.size())) {
    give_back_last(begin, row);
    return;
  }
  row.end = {at, row.spots.back().source, 1};
  row.complete = true;
  lexer.seek(at + line_end);
}

void TokenSource::take_plain_values(PlainRow& row) {
  row.clear();
  if (!ahead_.empty() || !expanded_.empty()) return;
  language::Lexer& lexer = files_.back().lexer;
  const std::uint32_t begin = lexer.offset();
  const std::uint32_t at = scan_numbers(begin, row);
  if (at < lexer.end() && lexer.source()->content[at] == '}') {
    lexer.seek(at);
  } else {
    give_back_last(begin, row);
  }
}

std::vector<text::Place> TokenSource::take_rest(bool keep_macros) {
  std::vector<text::Place> rests;
  for (std::size_t i = files_.size(); i-- > 0;) {
    const language::Lexer& lexer = files_[i].lexer;
    std::uint32_t begin = lexer.offset();
    if (i + 1 == files_.size() && !ahead_.empty()) begin = ahead_.front().place.offset;
    rests.push_back({lexer.source(), begin, lexer.end() - begin});
    if (keep_macros && !macros_.empty()) {
      const text::Place& rest = rests.back();
      std::string content = rest.source->content.substr(0, begin) + expanded_text(rest);
      const auto length = static_cast<std::uint32_t>(content.size() - begin);
      rests.back() = {text::make_source(rest.source->name, std::move(content)), begin, length};
    }
  }
  ahead_.clear();
  expanded_.clear();
  return rests;
}

// Text with each macro replaced by the words it stands for. Lines stay what they are, so messages show the
// right line.
std::string TokenSource::expanded_text(const text::Place& rest) const {
  std::string result;
  const std::string_view content = rest.source->content;
  std::uint32_t copied = rest.offset;
  language::Lexer lexer(rest, language::LexerMode::command);
  while (true) {
    Token token;
    try {
      token = lexer.next();
    } catch (const text::Error&) {
      break;  // whoever runs the text will find the same, and say so
    }
    if (token.is(TokenKind::end)) break;
    if (!token.is(TokenKind::word) || !macros_.contains(token.text)) continue;
    result += content.substr(copied, token.place.offset - copied);
    std::vector<std::string> active;
    std::vector<Token> tokens;
    expand(std::string(token.text), token, active, tokens);
    for (const Token& word : tokens) {
      if (&word != tokens.data() && word.space_before) result += word.separator != 0 ? word.separator : ' ';
      result += word.text;
    }
    copied = token.place.offset + token.place.length;
  }
  return result += content.substr(copied, rest.offset + rest.length - copied);
}

}  // namespace lamella::datafile
