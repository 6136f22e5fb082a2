#include "core/math/color_matching.h"

#include <cmath>

namespace brume {
namespace {

// A lobe that falls off differently to both sides of its peak [nm].
double lobe(double wavelength, double peak, double below, double above) {
  const double x = (wavelength - peak) * (wavelength < peak ? below : above);
  return std::exp(-0.5 * x * x);
}

glm::dvec3 observer(double nm) {
  return {1.056 * lobe(nm, 599.8, 0.0264, 0.0323) + 0.362 * lobe(nm, 442.0, 0.0624, 0.0374) -
              0.065 * lobe(nm, 501.1, 0.0490, 0.0382),
          0.821 * lobe(nm, 568.8, 0.0213, 0.0247) + 0.286 * lobe(nm, 530.9, 0.0613, 0.0322),
          1.217 * lobe(nm, 437.0, 0.0845, 0.0278) + 0.681 * lobe(nm, 459.0, 0.0385, 0.0725)};
}

}  // namespace

glm::dvec3 rec709_of_wavelength(double nm) {
  // From XYZ; columns.
  constexpr double m[3][3] = {{3.2404542, -0.9692660, 0.0556434},
                              {-1.5371385, 1.8760108, -0.2040259},
                              {-0.4985314, 0.0415560, 1.0572252}};
  const glm::dvec3 xyz = observer(nm);
  glm::dvec3 rgb(0.0);
  for (int i = 0; i < 3; ++i) rgb += xyz[i] * glm::dvec3(m[i][0], m[i][1], m[i][2]);
  return rgb;
}

}  // namespace brume
