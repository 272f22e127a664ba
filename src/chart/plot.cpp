#include "chart/plot.h"

#include <cmath>
#include <cstdio>

#include <fmt/format.h>

#include "text/error.h"

namespace lamella::chart {

namespace {

// Below this, rounding is all there is.
constexpr double least_error = 1e-15;

double error_of(const Sample& sample, double reference) {
  return std::abs(sample.energy / reference - 1);
}

std::string script(const std::vector<Curve>& curves, double reference, const std::string& title,
                   const std::filesystem::path& picture) {
  std::string text = picture_settings(picture);
  text += "set title " + quoted(title) + "\n";
  text += "set logscale xy\nset format y '%.0e'\nset format x '%g'\n";
  text += "set xlabel 'processor time, s'\nset ylabel 'relative error of the energy'\n";
  text += "set key outside right\nset grid\nset linetype 9 linecolor 'gray40'\nplot ";
  for (std::size_t i = 0; i < curves.size(); ++i) {
    text += fmt::format("{}'-' using 1:2 with linespoints pointsize 0.4 linewidth 1.5 title {}",
                        i > 0 ? ", " : "", quoted(curves[i].method));
  }
  text += "\n";
  for (const Curve& curve : curves) {
    for (const Sample& sample : curve.samples) {
      text += fmt::format("{:.6g} {:.6g}\n", std::max(sample.seconds, 1e-4),
                          std::max(error_of(sample, reference), least_error));
    }
    text += "e\n";
  }
  return text;
}

}  // namespace

std::string quoted(const std::string& text) {
  std::string result = "'";
  for (const char c : text) result += c == '\'' ? std::string("''") : std::string(1, c);
  return result + "'";
}

std::string picture_settings(const std::filesystem::path& picture) {
  const bool png = picture.extension() == ".png";
  return std::string(png ? "set terminal pngcairo size 1000,700 noenhanced\n"
                         : "set terminal svg size 800,560 dynamic background 'white' noenhanced\n") +
         "set output " + quoted(picture.string()) + "\n";
}

std::string table(const std::vector<Curve>& curves, double reference) {
  std::string text = "method,seconds,facets,energy,error\n";
  for (const Curve& curve : curves) {
    for (const Sample& sample : curve.samples) {
      text += fmt::format("{},{:.6g},{},{:.15g},{:.6g}\n", curve.method, sample.seconds, sample.facets,
                          sample.energy, error_of(sample, reference));
    }
  }
  return text;
}

void plot(const std::vector<Curve>& curves, double reference, const std::string& title,
          const std::filesystem::path& picture) {
  run_gnuplot(script(curves, reference, title, picture), picture);
}

void run_gnuplot(const std::string& text, const std::filesystem::path& picture) {
  std::FILE* const pipe = ::popen("gnuplot 2> /dev/null", "w");
  const bool written = pipe != nullptr && std::fwrite(text.data(), 1, text.size(), pipe) == text.size();
  const int status = pipe != nullptr ? ::pclose(pipe) : -1;
  if (!written || status != 0 || !std::filesystem::exists(picture))
    throw text::Error("gnuplot could not draw the chart",
                      "is it installed? the numbers are in the .csv file");
}

}  // namespace lamella::chart
