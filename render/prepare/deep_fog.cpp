#include "render/prepare/deep_fog.h"

#include <cmath>
#include <iomanip>
#include <numbers>
#include <sstream>

#include "render/prepare/fog_extent.h"

namespace brume {

namespace {

// Three digits of a length, all of one that has more.
std::string length_text(double length) {
  std::ostringstream text;
  text << std::setprecision(length < 100.0 ? 2 : 15)
       << (length < 100.0 ? length : std::round(length));
  return text.str();
}

}  // namespace

double transmittance_of_fog(const Scene& scene) {
  const FogExtent extent(scene);
  if (!extent.has_far_light()) return 1.0;
  return std::exp(-scene.medium.homogeneous_density() * extent.surface_distance());
}

std::optional<std::string> deep_fog_text(const Scene& scene) {
  const double transmittance = transmittance_of_fog(scene);
  if (transmittance >= 0.5) return std::nullopt;
  const double reach = FogExtent(scene).surface_distance();
  std::ostringstream text;
  text << "the homogeneous fog lets ";
  if (transmittance < 1e-3) {
    text << "less than 0.1";
  } else {
    text << std::setprecision(2) << 100.0 * transmittance;
  }
  text << "% of the light from far away through to the middle of the scene, for it reaches "
       << length_text(reach) << " u, "
       << (scene.optics.extent ? "the medium's extent" : "as far as all that is in the scene")
       << "; a homogeneous density of " << std::setprecision(2) << std::numbers::ln2 / reach
       << ", or a medium.extent of "
       << length_text(std::numbers::ln2 / scene.medium.homogeneous_density())
       << ", would let half of it through";
  return text.str();
}

}  // namespace brume
