// The words with which lines of a datafile begin.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace lamella::datafile {

// In the order in which they must stand.
enum class Section { vertices, edges, faces, bodies, read };

std::optional<Section> section_named(std::string_view word);
std::string_view name_of(Section section);

// What a keyword that is known but not supported is about; nothing for other words.
std::optional<std::string_view> refused_feature(std::string_view word);

// Known words to suggest instead of a mistyped one.
void collect_sections(std::vector<std::string>& into);
void collect_refused(std::vector<std::string>& into);

// A word of the command language, which has its place after `read`.
bool is_command_word(std::string_view word);

}  // namespace lamella::datafile
