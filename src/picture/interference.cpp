#include "picture/interference.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace lamella::picture {

namespace {

constexpr double shortest = 380;
constexpr double longest = 780;
constexpr double step = 5;

double square(double x) {
  return x * x;
}

// Of the light's amplitude at one face, for the two polarisations.
struct Amplitudes {
  double across = 0;
  double along = 0;
};

double cosine_inside(double cosine, double index) {
  return std::sqrt(1 - (1 - cosine * cosine) / square(index));
}

Amplitudes fresnel(double cosine, double index) {
  const double inside = cosine_inside(cosine, index);
  return {(cosine - index * inside) / (cosine + index * inside),
          (index * cosine - inside) / (index * cosine + inside)};
}

double lobe(double wavelength, double height, double peak, double below, double above) {
  return height * std::exp(-square((wavelength - peak) / (wavelength < peak ? below : above)) / 2);
}

Colour linear_srgb(const Tristimulus& t) {
  return {static_cast<float>(3.2404542 * t.x - 1.5371385 * t.y - 0.4985314 * t.z),
          static_cast<float>(-0.9692660 * t.x + 1.8760108 * t.y + 0.0415560 * t.z),
          static_cast<float>(0.0556434 * t.x - 0.2040259 * t.y + 1.0572252 * t.z)};
}

Colour brought_in(const Colour& colour, double brightness) {
  const float lowest = std::min({colour.red, colour.green, colour.blue});
  if (lowest >= 0) return colour;
  const auto grey = static_cast<float>(std::max(brightness, 0.0));
  if (grey <= 0) return {};
  const float part = lowest / (lowest - grey);
  return mix(colour, {grey, grey, grey}, part);
}

// Daylight times the observer's functions at each wavelength, scaled so that all of it is the screen's white.
struct Weight {
  double wavelength = 0;
  Tristimulus of;
};

std::vector<Weight> make_weights() {
  std::vector<Weight> weights;
  Tristimulus whole;
  for (double wavelength = shortest; wavelength <= longest; wavelength += step) {
    const Tristimulus o = standard_observer(wavelength);
    const double power = daylight(wavelength);
    weights.push_back({wavelength, {power * o.x, power * o.y, power * o.z}});
    whole.x += power * o.x;
    whole.y += power * o.y;
    whole.z += power * o.z;
  }
  constexpr Tristimulus white = {0.95047, 1, 1.08883};  // D65
  for (Weight& w : weights) {
    w.of = {w.of.x * white.x / whole.x, w.of.y * white.y / whole.y, w.of.z * white.z / whole.z};
  }
  return weights;
}

InterferenceTable make_table() {
  InterferenceTable table{256, 24, 1530, {}};
  table.colours.reserve(static_cast<std::size_t>(table.thicknesses * table.cosines));
  for (int j = 0; j < table.cosines; ++j) {
    // Seen exactly edge on a film reflects everything, whatever its thickness.
    const double cosine = std::max(0.02, static_cast<double>(j) / (table.cosines - 1));
    const auto scale = static_cast<float>(1 / mean_reflectance(cosine));
    for (int i = 0; i < table.thicknesses; ++i) {
      const double thickness = table.most_thick * i / (table.thicknesses - 1);
      table.colours.push_back(scale * reflected_daylight(thickness, cosine));
    }
  }
  return table;
}

}  // namespace

double reflectance(double wavelength, double thickness, double cosine, double index) {
  const Amplitudes r = fresnel(cosine, index);
  const double half_phase = 2 * M_PI * index * thickness * cosine_inside(cosine, index) / wavelength;
  const double wave = square(std::sin(half_phase));
  const auto airy = [&](double amplitude) {
    const double part = square(amplitude);
    if (part >= 1) return 1.0;
    return 4 * part * wave / (square(1 - part) + 4 * part * wave);
  };
  return (airy(r.across) + airy(r.along)) / 2;
}

double mean_reflectance(double cosine, double index) {
  const Amplitudes r = fresnel(cosine, index);
  // The mean of 4 p sin^2 / ((1-p)^2 + 4 p sin^2) over the phase is 2 p / (1 + p).
  const auto mean = [](double amplitude) { return 2 * square(amplitude) / (1 + square(amplitude)); };
  return (mean(r.across) + mean(r.along)) / 2;
}

Tristimulus standard_observer(double w) {
  return {lobe(w, 1.056, 599.8, 37.9, 31.0) + lobe(w, 0.362, 442.0, 16.0, 26.7) +
              lobe(w, -0.065, 501.1, 20.4, 26.2),
          lobe(w, 0.821, 568.8, 46.9, 40.5) + lobe(w, 0.286, 530.9, 16.3, 31.1),
          lobe(w, 1.217, 437.0, 11.8, 36.0) + lobe(w, 0.681, 459.0, 26.0, 13.8)};
}

double daylight(double wavelength) {
  // Every 10 nm from 380 to 780 nm.
  static constexpr std::array<double, 41> table = {
      49.9755, 54.6482, 82.7549, 91.4860, 93.4318, 86.6823, 104.865, 117.008, 117.812, 114.861, 115.923,
      108.811, 109.354, 107.802, 104.790, 107.689, 104.405, 104.046, 100.000, 96.3342, 95.7880, 88.6856,
      90.0062, 89.5991, 87.6987, 83.2886, 83.6992, 80.0268, 80.2146, 82.2778, 78.2842, 69.7213, 71.6091,
      74.3490, 61.6040, 69.8856, 75.0870, 63.5927, 46.4182, 66.8054, 63.3828};
  const double at = (wavelength - shortest) / 10;
  if (at < 0 || at > 40) return 0;
  const auto row = std::min<std::size_t>(static_cast<std::size_t>(at), table.size() - 2);
  const double part = at - static_cast<double>(row);
  return (1 - part) * table[row] + part * table[row + 1];
}

Colour reflected_daylight(double thickness, double cosine) {
  static const std::vector<Weight> weights = make_weights();
  Tristimulus seen;
  for (const Weight& w : weights) {
    const double part = reflectance(w.wavelength, thickness, cosine);
    seen.x += part * w.of.x;
    seen.y += part * w.of.y;
    seen.z += part * w.of.z;
  }
  return brought_in(linear_srgb(seen), seen.y);
}

const InterferenceTable& interference_table() {
  static const InterferenceTable table = make_table();
  return table;
}

}  // namespace lamella::picture
