#include "session/help.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <optional>
#include <sstream>
#include <vector>

#include <fmt/format.h>
#include <unistd.h>

#include "language/functions.h"
#include "session/internal_variables.h"
#include "session/session.h"
#include "session/terminal.h"
#include "text/suggest.h"
#include "text/whole_file.h"

namespace lamella::session {

using language::ElementKind;

namespace {

namespace fs = std::filesystem;

struct Group {
  CommandGroup group;
  std::string_view title;
};

constexpr std::array<Group, 7> groups = {{{CommandGroup::scene, "The scene"},
                                          {CommandGroup::motion, "Motion"},
                                          {CommandGroup::mesh, "The mesh"},
                                          {CommandGroup::measure, "Measuring"},
                                          {CommandGroup::output, "Output"},
                                          {CommandGroup::language, "The language"},
                                          {CommandGroup::session, "The session"}}};

// The manual in the source folder, or beside the program.
std::optional<std::string> manual_page(const std::string& name) {
  std::error_code ignored;
  const fs::path program = fs::read_symlink("/proc/self/exe", ignored).parent_path();
  const std::array<fs::path, 3> folders = {LAMELLA_MANUAL, program / "manual",
                                           program.parent_path() / "share/lamella/manual"};
  for (const fs::path& folder : folders) {
    const fs::path path = folder / name;
    if (fs::is_regular_file(path, ignored)) return text::read_whole_file(path.string());
  }
  return std::nullopt;
}

std::string command_help(const Command& command) {
  if (const auto page = manual_page("commands/" + command.name + ".md")) return *page;
  std::string result = fmt::format("# {}\n\n{}\n\n    {}\n", command.name, command.summary, usage(command));
  const std::string arguments = argument_help(command);
  if (!arguments.empty()) result += "\n```\n" + arguments + "```\n";
  return result;
}

// The section of the page on the language whose heading has the word in backticks.
std::optional<std::string> language_section(std::string_view word) {
  const auto page = manual_page("language.md");
  if (!page) return std::nullopt;
  std::istringstream lines(*page);
  std::string result;
  const std::string marked = fmt::format("`{}`", word);
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("#")) {
      if (!result.empty()) break;
      if (line.find(marked) == std::string::npos) continue;
    } else if (result.empty()) {
      continue;
    }
    result += line + "\n";
  }
  return result.empty() ? std::nullopt : std::optional(result);
}

std::string function_help(const language::Function& function) {
  const std::string arguments = function.arguments == 1 ? "x" : "x, y";
  return fmt::format("{}({}): {}\n", function.name, arguments, function.summary);
}

std::string attribute_help(Session& session, std::string_view topic) {
  std::string result;
  for (const ElementKind kind : language::element_kinds) {
    const auto meaning = session.attributes().find(session.scene(), kind, topic);
    if (!meaning) continue;
    const std::string summary = session.attributes().summary(kind, topic);
    const std::string settable = session.attributes().can_set(meaning->id) ? "" : " (cannot be set)";
    result += fmt::format("{}[...].{}: {}{}\n", language::name_of(kind), text::lower(topic),
                          summary.empty() ? "an attribute of yours" : summary, settable);
  }
  return result;
}

std::string name_help(Session& session, std::string_view topic) {
  std::string result;
  if (const language::Variable* const variable = session.scene().variables.find(topic)) {
    const double* const number = std::get_if<double>(&variable->value);
    result += fmt::format(
        "{}: a variable, now {}\n", topic,
        number != nullptr ? fmt::format("{:.15g}", *number) : std::get<std::string>(variable->value));
  }
  const auto procedure = session.scene().procedures.find(text::lower(topic));
  if (procedure != session.scene().procedures.end())
    result += fmt::format("{} := {}\n", procedure->second.name, procedure->second.source);
  if (const auto id = find_internal_variable(topic)) {
    const InternalVariable& variable = internal_variable(*id);
    result += fmt::format("{}: {}{}\n", variable.name, variable.summary,
                          variable.set == nullptr ? " (cannot be set)" : "");
  }
  if (const language::Function* const function = language::find_function(topic))
    result += function_help(*function);
  if (const auto number = language::named_number(topic))
    result += fmt::format("{}: {:.15g}\n", text::lower(topic), *number);
  return result + attribute_help(session, topic);
}

// Pages of the manual that are about no one command.
constexpr std::array<std::string_view, 3> pages = {"language", "switches", "evolver"};

std::vector<std::string> all_topics(Session& session) {
  std::vector<std::string> topics(pages.begin(), pages.end());
  topics.emplace_back("error");
  session.names().collect_statement_words(topics);
  session.names().collect_names(topics);
  for (const ElementKind kind : language::element_kinds) session.names().collect_attributes(kind, topics);
  for (const language::Function& function : language::functions()) topics.emplace_back(function.name);
  return topics;
}

// --- Markdown

// Removes marks inside a line: `code`, **strong**, [text](address).
std::string without_marks(std::string_view line) {
  std::string result;
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (line[i] == '`' || line.substr(i).starts_with("**")) {
      i += line[i] == '*' ? 1 : 0;
      continue;
    }
    const std::size_t middle = line[i] == '[' ? line.find("](", i) : std::string_view::npos;
    const std::size_t end =
        middle != std::string_view::npos ? line.find(')', middle) : std::string_view::npos;
    if (end != std::string_view::npos && line.substr(i, middle - i).find('`') == std::string_view::npos) {
      result += line.substr(i + 1, middle - i - 1);
      i = end;
      continue;
    }
    result += line[i];
  }
  return result;
}

std::string trimmed(std::string_view text) {
  const std::size_t begin = text.find_first_not_of(' ');
  if (begin == std::string_view::npos) return {};
  return std::string(text.substr(begin, text.find_last_not_of(' ') - begin + 1));
}

// The cells of `| a | b |`.
std::vector<std::string> cells_of(std::string_view line) {
  std::vector<std::string> cells;
  std::string cell;
  for (std::size_t i = 1; i < line.size(); ++i) {
    if (line[i] == '\\' && i + 1 < line.size()) {
      cell += line[++i];
    } else if (line[i] == '|') {
      cells.push_back(trimmed(without_marks(cell)));
      cell.clear();
    } else {
      cell += line[i];
    }
  }
  return cells;
}

bool is_table_rule(std::string_view line) {
  return line.find_first_not_of("|-: ") == std::string_view::npos;
}

// Characters on the screen, where UTF-8 sequences are one each.
std::size_t width_of(std::string_view text) {
  return static_cast<std::size_t>(std::count_if(
      text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; }));
}

std::string table_text(const std::vector<std::vector<std::string>>& rows) {
  std::vector<std::size_t> widths;
  for (const auto& row : rows) {
    widths.resize(std::max(widths.size(), row.size()));
    for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], width_of(row[i]));
  }
  std::string result;
  for (const auto& row : rows) {
    std::string line = "  ";
    for (std::size_t i = 0; i < row.size(); ++i)
      line += row[i] + std::string(widths[i] - width_of(row[i]) + 2, ' ');
    line.erase(line.find_last_not_of(' ') + 1);
    result += line + "\n";
  }
  return result;
}

std::string heading_text(std::string_view line, bool colours) {
  const std::string title = without_marks(line.substr(std::min(line.find_first_not_of("# "), line.size())));
  return colours ? fmt::format("\x1b[1m{}\x1b[0m\n", title) : title + "\n";
}

}  // namespace

std::string readable(std::string_view markdown, bool colours) {
  std::istringstream lines{std::string(markdown)};
  std::string result;
  std::vector<std::vector<std::string>> table;
  bool code = false;
  for (std::string line; std::getline(lines, line);) {
    if (!code && line.starts_with("|")) {
      if (!is_table_rule(line)) table.push_back(cells_of(line));
      continue;
    }
    result += table_text(std::exchange(table, {}));
    if (line.starts_with("```")) {
      code = !code;
    } else if (code) {
      result += "    " + line + "\n";
    } else if (line.starts_with("#")) {
      result += heading_text(line, colours);
    } else {
      result += without_marks(line) + "\n";
    }
  }
  return result + table_text(table);
}

std::string help_overview(Session& session) {
  std::string result;
  for (const Group& group : groups) {
    std::string lines;
    for (const Command* const command : session.names().commands()) {
      if (command->group != group.group) continue;
      const std::string aliases =
          command->aliases.empty() ? "" : fmt::format(" ({})", fmt::join(command->aliases, ", "));
      lines += fmt::format("  {:<28} {}\n", command->name + aliases, command->summary);
    }
    if (!lines.empty()) result += fmt::format("{}\n{}\n", group.title, lines);
  }
  return result +
         "help NAME tells more, about functions, variables and attributes too; help language is on if, "
         "foreach and the rest, help switches on what is on or off, help evolver on Surface Evolver.\n";
}

std::string help_topic(Session& session, std::string_view topic) {
  const bool colours = colours_allowed(STDOUT_FILENO) && !session.output().redirected();
  if (text::lower(topic) == "error")
    return session.last_error().empty() ? "nothing has gone wrong so far\n" : session.last_error();
  for (const std::string_view page_name : pages) {
    if (text::lower(topic) != page_name) continue;
    if (const auto page = manual_page(fmt::format("{}.md", page_name))) return readable(*page, colours);
  }
  std::string result;
  if (const Command* const command = find_command(session.names().commands(), topic))
    result += readable(command_help(*command), colours);
  if (result.empty()) {
    if (const auto section = language_section(text::lower(topic))) result += readable(*section, colours);
  }
  // A letter that is a command is meant as one.
  if (result.empty() || topic.size() > 1) result += name_help(session, topic);
  if (!result.empty()) return result;
  std::vector<std::string> topics = all_topics(session);
  std::string near = text::did_you_mean(topic, topics);
  if (near.empty()) {
    std::erase_if(topics, [&](const std::string& known) { return !known.starts_with(text::lower(topic)); });
    if (!topics.empty()) near = fmt::format("there is help on {}", fmt::join(topics, ", "));
  }
  throw text::Error(fmt::format("there is no help on \"{}\"", topic),
                    near.empty() ? "help alone lists the commands" : near);
}

}  // namespace lamella::session
