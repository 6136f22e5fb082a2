#include "tests/render/test_profiles.h"

#include <cmath>
#include <glm/trigonometric.hpp>

#include "core/scene/lights/photometric_profile.h"

namespace brume {
namespace {

// `intensity`: of the polar angle and the azimuth in radians.
template <class Intensity>
LightProfile profile(double step, double rotation, Intensity&& intensity) {
  std::vector<double> polar;
  std::vector<double> azimuths;
  std::vector<double> values;
  for (double p = 0.0; p <= 180.0; p += step) polar.push_back(p);
  for (double a = 0.0; a <= 360.0; a += step) {
    azimuths.push_back(a);
    for (const double p : polar) values.push_back(intensity(glm::radians(p), glm::radians(a)));
  }
  return {"profile.ies", std::make_shared<const PhotometricProfile>(polar, azimuths, values),
          rotation};
}

}  // namespace

LightProfile cosine_profile() {
  return profile(1.0, 0.0, [](double p, double) { return std::max(std::cos(p), 0.0); });
}

LightProfile lobed_profile(double rotation) {
  return profile(5.0, rotation, [](double p, double a) {
    return std::exp(-8.0 * std::pow(p - 0.7, 2)) * (1.3 + std::cos(a)) *
           (1.0 + std::pow(std::sin(a), 2));
  });
}

}  // namespace brume
