// Curves as a table and as a picture.
#pragma once

#include <filesystem>

#include "chart/race.h"

namespace lamella::chart {

// method,seconds,facets,energy,error with the relative error against `reference`.
std::string table(const std::vector<Curve>& curves, double reference);

// Draws relative error over processor time, both logarithmic, a curve a method, by gnuplot; the file's ending
// decides: .svg or .png. Throws text::Error where gnuplot is missing or fails.
void plot(const std::vector<Curve>& curves, double reference, const std::string& title,
          const std::filesystem::path& picture);

// The lines by which a script of gnuplot writes a picture; and running one. Throws text::Error where gnuplot
// is missing or fails.
std::string picture_settings(const std::filesystem::path& picture);
void run_gnuplot(const std::string& script, const std::filesystem::path& picture);
// In quotes, as gnuplot reads it.
std::string quoted(const std::string& text);

}  // namespace lamella::chart
