// The nearest known word to a mistyped one.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace lamella::text {

// The candidate with the fewest insertions, deletions, replacements and swaps of neighbours (case is
// ignored), if it is near enough that a person would call it a slip: at most a third of the word's length, at
// least 1.
std::optional<std::string> closest(std::string_view word, std::span<const std::string> candidates);

// `did you mean "candidate"?`, or nothing.
std::string did_you_mean(std::string_view word, std::span<const std::string> candidates);

// Lower-case copy (ASCII).
std::string lower(std::string_view word);

}  // namespace lamella::text
