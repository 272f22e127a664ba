#include "session/completion.h"

#include <algorithm>
#include <optional>

#include "language/functions.h"
#include "session/session.h"
#include "text/suggest.h"

namespace lamella::session {

using language::ElementKind;

namespace {

constexpr std::string_view statement_words[] = {"if",       "while",    "do",     "for",   "foreach",
                                                "break",    "continue", "return", "local", "procedure",
                                                "function", "then",     "else"};
constexpr std::string_view value_words[] = {"sum",     "max",        "min",    "avg",           "count",
                                            "sprintf", "is_defined", "sizeof", "valid_element", "where",
                                            "and",     "or",         "not"};

bool is_name(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
}

std::size_t name_begin(std::string_view text, std::size_t end) {
  while (end > 0 && is_name(text[end - 1])) --end;
  return end;
}

// Where the statement begins in which the cursor stands: behind the last `;` or brace that is in no string.
std::size_t statement_begin(std::string_view line) {
  std::size_t begin = 0;
  bool quoted = false;
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (line[i] == '"' && (i == 0 || line[i - 1] != '\\')) quoted = !quoted;
    if (!quoted && (line[i] == ';' || line[i] == '{' || line[i] == '}')) begin = i + 1;
  }
  return begin;
}

std::vector<std::string> words_of(std::string_view text) {
  std::vector<std::string> words;
  for (std::size_t i = 0; i < text.size();) {
    if (text[i] == ' ' || text[i] == '\t') {
      ++i;
      continue;
    }
    const std::size_t end = std::min(text.find_first_of(" \t", i), text.size());
    words.emplace_back(text.substr(i, end - i));
    i = end;
  }
  return words;
}

class Completer {
 public:
  Completer(Session& session, std::string_view line) : session_(session), line_(line) {
    result_.begin = name_begin(line, line.size());
    statement_ = line.substr(statement_begin(line));
  }

  Completion run() {
    const std::size_t lead = statement_.find_first_not_of(" \t");
    const bool first_word = lead == std::string_view::npos ||
                            name_begin(line_, line_.size()) == (line_.size() - statement_.size()) + lead;
    const bool open_string = std::count(statement_.begin(), statement_.end(), '"') % 2 == 1;
    if (open_string) {
      result_.files = true;
    } else if (result_.begin > 0 && line_[result_.begin - 1] == '.' && attributes_after_dot()) {
      // done
    } else if (first_word) {
      statement_starts();
    } else {
      after_first_word();
    }
    return sorted();
  }

 private:
  void add(std::string_view candidate) { result_.candidates.emplace_back(candidate); }

  Completion sorted() {
    const std::string typed = text::lower(line_.substr(result_.begin));
    std::erase_if(result_.candidates,
                  [&](const std::string& c) { return !text::lower(c).starts_with(typed); });
    std::sort(result_.candidates.begin(), result_.candidates.end());
    result_.candidates.erase(std::unique(result_.candidates.begin(), result_.candidates.end()),
                             result_.candidates.end());
    return result_;
  }

  void statement_starts() {
    for (const Command* const command : session_.names().commands()) {
      add(command->name);
      for (const std::string& alias : command->aliases) {
        if (alias.size() > 1) add(alias);
      }
    }
    for (const std::string_view word : statement_words) add(word);
    for (const auto& [key, procedure] : session_.scene().procedures) add(procedure.name);
    session_.scene().variables.for_each(
        [&](language::VariableId id, const auto&) { add(session_.scene().variables.name(id)); });
    kinds();
  }

  void kinds() {
    for (const ElementKind kind : language::element_kinds) {
      add(language::name_of(kind));
      add(language::plural_of(kind));
    }
  }

  void values() {
    std::vector<std::string> names;
    session_.names().collect_names(names);
    for (const std::string& name : names) add(name);
    for (const language::Function& function : language::functions()) add(function.name);
    for (const language::NamedNumber& number : language::named_numbers()) add(number.name);
    for (const std::string_view word : value_words) add(word);
    kinds();
  }

  void attributes(ElementKind kind) {
    std::vector<std::string> names;
    session_.names().collect_attributes(kind, names);
    for (const std::string& name : names) add(name);
  }

  // Attributes, and the kinds of parts: vertex[1].edge
  bool attributes_after_dot() {
    const std::size_t dot = result_.begin - 1;
    if (dot == 0 || line_[dot - 1] == '/' || line_[dot - 1] == '.') return false;
    std::size_t end = dot;
    if (line_[end - 1] == ']') end = line_.rfind('[', end);
    if (end == std::string_view::npos || end == 0) return false;
    const std::size_t begin = name_begin(line_, end);
    const std::string_view owner = line_.substr(begin, end - begin);
    if (owner.empty()) return false;
    const std::optional<ElementKind> kind = kind_of(owner);
    for (const ElementKind each : language::element_kinds) {
      if (!kind || *kind == each) attributes(each);
    }
    for (const ElementKind each : language::element_kinds) {
      if (each != kind) add(language::name_of(each));
    }
    return true;
  }

  // Of an element's kind or the name of a loop's element: `foreach vertex vv`.
  std::optional<ElementKind> kind_of(std::string_view owner) const {
    if (const auto kind = language::element_kind(owner)) return kind;
    std::string words(line_);
    std::replace_if(
        words.begin(), words.end(), [](char c) { return !is_name(c); }, ' ');
    const std::vector<std::string> all = words_of(words);
    for (std::size_t i = 1; i < all.size(); ++i) {
      const auto kind = language::element_kind(all[i - 1]);
      if (all[i] == owner && kind) return kind;
    }
    return std::nullopt;
  }

  // The kind of the elements that the statement speaks of last.
  std::optional<ElementKind> last_kind() const {
    std::optional<ElementKind> result;
    std::string words(statement_.substr(0, statement_.size() - (line_.size() - result_.begin)));
    std::replace_if(
        words.begin(), words.end(), [](char c) { return !is_name(c); }, ' ');
    for (const std::string& word : words_of(words)) {
      if (const auto kind = language::element_kind(word)) result = kind;
    }
    return result;
  }

  void after_first_word() {
    const std::vector<std::string> words = words_of(statement_);
    const Command* const command = find_command(session_.names().commands(), words.front());
    if (command == nullptr) {
      if (const auto kind = last_kind()) attributes(*kind);
      for (const std::string_view word : statement_words) add(word);
      return values();
    }
    const bool starts_value = statement_.ends_with('=');
    const std::string last =
        words.size() > 1 && !statement_.ends_with(' ') ? words[words.size() - 2] : words.back();
    arguments(*command, starts_value ? words.back().substr(0, words.back().find('=')) : last);
  }

  void arguments(const Command& command, const std::string& word_before) {
    for (const Argument& argument : command.arguments) {
      if (argument.named && argument.name == text::lower(word_before) && argument.kind != ArgumentKind::flag)
        return value(argument);
    }
    for (const Argument& argument : command.arguments) {
      if (argument.named) add(argument.name);
      if (!argument.named) value(argument);
    }
  }

  void value(const Argument& argument) {
    for (const std::string& choice : argument.choices) add(choice);
    if (!argument.word_for_none.empty()) add(argument.word_for_none);
    switch (argument.kind) {
      case ArgumentKind::file:
        result_.files = true;
        return;
      case ArgumentKind::flag:
        return;
      case ArgumentKind::text:
        if (argument.choices.empty() && result_.begin < line_.size()) values();
        return;
      case ArgumentKind::word:
        return topics();
      case ArgumentKind::elements:
      case ArgumentKind::selection:
      case ArgumentKind::setting:
        if (const auto kind = last_kind()) {
          attributes(*kind);
          add("where");
        }
        kinds();
        return;
      default:
        // Before anything is typed, options alone are a better answer than every name there is.
        if (result_.begin < line_.size()) values();
        return;
    }
  }

  void topics() {
    statement_starts();
    values();
    for (const ElementKind kind : language::element_kinds) attributes(kind);
    add("language");
    add("error");
  }

  Session& session_;
  std::string_view line_;
  std::string_view statement_;
  Completion result_;
};

}  // namespace

Completion complete(Session& session, std::string_view line) {
  return Completer(session, line).run();
}

}  // namespace lamella::session
