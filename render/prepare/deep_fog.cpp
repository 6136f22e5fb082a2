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

// The extinction of homogeneous fog, by the mean of its albedo [1/u].
double extinction_of_fog(const Scene& scene) {
  const glm::dvec3& albedo = scene.optics.albedo;
  return scene.medium.homogeneous_density() / ((albedo.x + albedo.y + albedo.z) / 3.0);
}

}  // namespace

double transmittance_of_fog(const Scene& scene) {
  const FogExtent extent(scene);
  if (!extent.has_far_light()) return 1.0;
  return std::exp(-extinction_of_fog(scene) * extent.surface_distance());
}

std::optional<std::string> deep_fog_text(const Scene& scene) {
  const double transmittance = transmittance_of_fog(scene);
  if (transmittance >= 0.5) return std::nullopt;
  const double reach = FogExtent(scene).surface_distance();
  const double half =
      std::numbers::ln2 / extinction_of_fog(scene);  // the length that lets it through
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
       << "; a homogeneous density of " << std::setprecision(2)
       << scene.medium.homogeneous_density() * half / reach << ", or a medium.extent of "
       << length_text(half) << ", would let half of it through";
  return text.str();
}

}  // namespace brume
