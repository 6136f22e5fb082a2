#include "render/albedo.h"

#include <algorithm>

namespace brume {

std::vector<AlbedoGroup> albedo_groups(const glm::dvec3& albedo) {
  std::vector<AlbedoGroup> groups;
  for (std::size_t channel = 0; channel < 3; ++channel) {
    const double w = albedo[static_cast<int>(channel)];
    const auto same = std::find_if(groups.begin(), groups.end(),
                                   [w](const AlbedoGroup& group) { return group.albedo == w; });
    if (same != groups.end()) {
      same->channels.push_back(channel);
    } else {
      groups.push_back({w, {channel}});
    }
  }
  return groups;
}

Medium extinction_medium(const Medium& scattering, double albedo) {
  if (albedo == 1.0) return scattering;
  Medium medium;
  medium.reserve(scattering.size());
  medium.set_homogeneous_density(scattering.homogeneous_density() / albedo);
  for (std::size_t i = 0; i < scattering.size(); ++i) {
    Gaussian g = scattering.gaussian(i);
    g.density /= albedo;
    medium.append(g);
  }
  return medium;
}

}  // namespace brume
