#include "render/scattering/lobe/sky_lobe.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <glm/common.hpp>
#include <numbers>

#include "core/math/basis.h"
#include "core/math/golden_angle.h"
#include "core/math/infinity.h"
#include "core/transport/phase_function.h"
#include "render/scattering/phase_bands.h"

namespace brume {
namespace {

// Rays from a place: so many are spread like the phase function, and so many evenly, for at large
// angles the lobe takes back what bands scatter too much.
constexpr int lobe_directions = 64;
constexpr int even_directions = 24;

}  // namespace

SkyLobe::SkyLobe(const LobedSky& sky, const RayCaster& ray_caster, const LobedMedium& medium,
                 const ViewDepths& depths)
    : sky_(sky), ray_caster_(ray_caster), medium_(medium), depths_(depths) {
  if (sky.scattered.empty()) return;
  add_directions(lobe_directions, std::abs(medium.anisotropy));
  add_directions(even_directions, 0.0);
}

void SkyLobe::add_directions(int count, double anisotropy) {
  const double g = std::abs(medium_.anisotropy);
  const PhaseBands bands(g);
  for (int i = 0; i < count; ++i) {
    const double cosine = henyey_greenstein_quantile((i + 0.5) / count, anisotropy);
    const double sine = std::sqrt(std::max(1.0 - cosine * cosine, 0.0));
    const double turn = golden_angle * i;
    const double phase = henyey_greenstein(cosine, g);
    const double lobe = phase - 4.0 * std::numbers::pi * bands.phase(cosine);
    const double density = lobe_directions * phase + even_directions;
    directions_.push_back({{sine * std::cos(turn), sine * std::sin(turn), cosine},
                           static_cast<float>(lobe / density)});
  }
}

glm::vec3 SkyLobe::whole(const glm::dvec3& w) const {
  const glm::vec3 in_map(sky_.to_map * w);
  glm::vec3 sum(0.0f);
  for (const auto& map : sky_.scattered) sum += map_radiance(*map, in_map);
  return sum;
}

glm::vec3 SkyLobe::operator()(const glm::dvec3& begin, const glm::dvec3& w, double t) const {
  const glm::dvec3 place = begin + t * w;
  const glm::dvec3 coming_from = medium_.anisotropy < 0.0 ? -w : w;
  const double depth = medium_.grid_extinction * depths_(place, coming_from, infinity) +
                       (1.0 - medium_.grid_extinction) * depths_(begin, w, t);
  return static_cast<float>(sky_.scale * std::exp(-depth)) * seen(place, w);
}

glm::vec3 SkyLobe::seen(const glm::dvec3& place, const glm::dvec3& w) const {
  const glm::dvec3 axis = medium_.anisotropy < 0.0 ? -w : w;
  const Basis basis = make_basis(axis);
  std::vector<glm::dvec3> directions;
  for (const auto& [direction, weight] : directions_) {
    directions.push_back(direction.x * basis.u + direction.y * basis.v + direction.z * axis);
  }
  std::vector<SurfaceHit> hits(directions.size());
  ray_caster_.opaque_hits(place, directions, hits, 0.0);
  glm::vec3 all(0.0f), seen(0.0f);
  glm::vec3 all_sizes(1e-30f), seen_sizes(0.0f);
  for (std::size_t i = 0; i < directions.size(); ++i) {
    const glm::vec3 light =
        directions_[i].weight * map_radiance(sky_.radiance, glm::vec3(sky_.to_map * directions[i]));
    all += light;
    all_sizes += glm::abs(light);
    if (hits[i]) continue;
    const auto passing = static_cast<float>(
        ray_caster_.has_panes() ? ray_caster_.transmittance(place, directions[i], infinity) : 1.0);
    seen += passing * light;
    seen_sizes += passing * glm::abs(light);
  }
  // The sum is exact where nothing hides the sky, and where all is hidden.
  return seen + seen_sizes / all_sizes * (whole(w) - all);
}

}  // namespace brume
