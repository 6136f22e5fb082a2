#include "render/prepare/deep_fog.h"

#include <cmath>
#include <iomanip>
#include <numbers>
#include <sstream>

#include "render/prepare/fog_extent.h"

namespace brume {

double transmittance_of_fog(const Scene& scene) {
  const FogExtent extent(scene);
  if (extent.ball().is_endless()) return 1.0;
  return std::exp(-extent.surface_optical_depth(scene.medium.homogeneous_density()));
}

std::optional<std::string> deep_fog_text(const Scene& scene) {
  const double transmittance = transmittance_of_fog(scene);
  if (transmittance >= 0.5) return std::nullopt;
  const double reach = FogExtent(scene).surface_distance();
  std::ostringstream text;
  text << std::setprecision(2) << "the homogeneous fog lets " << 100.0 * transmittance
       << "% of the light from far away through to the middle of the scene, for it reaches "
       << reach << " u, as far as all that is in the scene; a homogeneous density of "
       << std::numbers::ln2 / reach << " would let half of it through";
  return text.str();
}

}  // namespace brume
