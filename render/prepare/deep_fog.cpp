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
  text << "the homogeneous fog lets ";
  if (transmittance < 1e-3) {
    text << "less than 0.1";
  } else {
    text << std::setprecision(2) << 100.0 * transmittance;
  }
  text << "% of the light from far away through to the middle of the scene, for it reaches "
       << std::setprecision(reach < 100.0 ? 2 : 15) << (reach < 100.0 ? reach : std::round(reach))
       << " u, as far as all that is in the scene; a homogeneous density of "
       << std::setprecision(2) << std::numbers::ln2 / reach << " would let half of it through";
  return text.str();
}

}  // namespace brume
