#include "datafile/findings.h"

#include <algorithm>
#include <functional>
#include <tuple>

#include <fmt/format.h>

namespace lamella::datafile {

namespace {

bool same_complaint(const text::Diagnostic& a, const text::Diagnostic& b) {
  return a.place.source == b.place.source && a.place.offset == b.place.offset && a.message == b.message;
}

std::string remainder(std::size_t errors, std::size_t warnings) {
  const auto counted = [](std::size_t count, std::string_view what) {
    return fmt::format("{} more {}{}", count, what, count == 1 ? "" : "s");
  };
  if (warnings == 0) return counted(errors, "error");
  if (errors == 0) return counted(warnings, "warning");
  return fmt::format("{} and {}", counted(errors, "error"), counted(warnings, "warning"));
}

}  // namespace

void Findings::error(text::Place place, std::string message, std::string hint,
                     std::vector<text::Note> notes) {
  add({text::Severity::error, std::move(place), std::move(message), std::move(hint), std::move(notes)});
}

void Findings::warning(text::Place place, std::string message, std::string hint,
                       std::vector<text::Note> notes) {
  add({text::Severity::warning, std::move(place), std::move(message), std::move(hint), std::move(notes)});
}

void Findings::take(const text::Error& error) {
  for (const text::Diagnostic& diagnostic : error.diagnostics()) add(diagnostic);
}

void Findings::add(text::Diagnostic diagnostic) {
  if (!diagnostics_.empty() && same_complaint(diagnostics_.back(), diagnostic)) return;
  if (diagnostic.severity == text::Severity::error) ++errors_;
  diagnostics_.push_back(std::move(diagnostic));
}

std::vector<text::Diagnostic> Findings::in_order(const std::vector<text::SourcePointer>& sources) const {
  const auto key = [&](const text::Diagnostic& diagnostic) {
    const auto at = std::find(sources.begin(), sources.end(), diagnostic.place.source);
    return std::tuple(at - sources.begin(), diagnostic.place.offset);
  };
  std::vector<text::Diagnostic> sorted = diagnostics_;
  std::stable_sort(sorted.begin(), sorted.end(),
                   [&](const auto& a, const auto& b) { return key(a) < key(b); });
  if (sorted.size() <= most_shown) return sorted;

  // Warnings give way to errors.
  const auto is_error = [](const text::Diagnostic& d) { return d.severity == text::Severity::error; };
  if (has_errors()) std::erase_if(sorted, std::not_fn(is_error));
  std::size_t errors = 0;
  for (std::size_t i = most_shown; i < sorted.size(); ++i) errors += is_error(sorted[i]) ? 1 : 0;
  const std::size_t left_out = diagnostics_.size() - std::min(sorted.size(), most_shown);
  sorted.resize(std::min(sorted.size(), most_shown));
  text::Diagnostic last;
  last.severity = has_errors() ? text::Severity::error : text::Severity::warning;
  last.message = remainder(errors, left_out - errors);
  sorted.push_back(std::move(last));
  return sorted;
}

}  // namespace lamella::datafile
