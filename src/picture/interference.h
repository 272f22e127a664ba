// The colours of thin films: what a soap film in air reflects of white light.
#pragma once

#include <vector>

#include "picture/colour.h"

namespace lamella::picture {

inline constexpr double water_index = 1.33;

// The part of unpolarised light of a wavelength (nm, as a film's thickness) that the film reflects, its two
// faces and all echoes between them together (Airy). `cosine` is that of the angle to the film's normal.
double reflectance(double wavelength, double thickness, double cosine, double index = water_index);

// The mean of that over all thicknesses: what is left of it when the colours are taken away.
double mean_reflectance(double cosine, double index = water_index);

// The CIE 1931 functions of the standard observer, by the multi-lobe fits of C. Wyman, P.-P. Sloan and P.
// Shirley, "Simple Analytic Approximations to the CIE XYZ Color Matching Functions", JCGT 2(2), 2013.
struct Tristimulus {
  double x = 0;
  double y = 0;
  double z = 0;
};
Tristimulus standard_observer(double wavelength);

// The relative power of daylight (CIE illuminant D65), 100 at 560 nm.
double daylight(double wavelength);

// Reflected daylight as linear sRGB, white being all of it. Saturated colours that a screen cannot show are
// brought in by adding grey of their own brightness.
Colour reflected_daylight(double thickness, double cosine);

// reflected_daylight over mean_reflectance, so that its mean over thickness is 1: rows of `thicknesses`
// values from 0 to `most_thick`, for `cosines` cosines from 0 to 1.
struct InterferenceTable {
  int thicknesses = 0;
  int cosines = 0;
  double most_thick = 0;
  std::vector<Colour> colours;
};
// The one that pictures use, made when first needed.
const InterferenceTable& interference_table();

}  // namespace lamella::picture
