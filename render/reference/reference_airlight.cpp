#include "render/reference/reference_airlight.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>
#include <numbers>

#include "core/math/infinity.h"
#include "core/math/quadrature.h"
#include "core/scene/lights/environment.h"
#include "core/transport/phase_function.h"

namespace brume {

ReferenceRay reference_airlight(const MediumIndex& medium, const ExactOcclusion& exact_occlusion,
                                std::span<const PointSource> lights,
                                const ReferenceEnvironment* environment, const glm::dvec3& eye,
                                const glm::dvec3& w, double length, double tolerance) {
  ReferenceRay result;
  std::vector<GaussianTerm<double>> along;
  std::vector<RelativeOptics> optics;
  double last = 0.0;  // where the last Gaussian ends
  medium.bvh().query(RaySegment{eye, w, length, medium.max_displacement()}, [&](std::uint32_t i) {
    along.push_back(medium.gaussians()[i]);
    if (!medium.optics().empty()) optics.push_back(medium.optics()[i]);
    last = std::max(last, glm::dot(along.back().b - eye, w) + medium.cutoff_radii()[i]);
  });
  result.view_pairs = along.size();
  const double b0 = medium.homogeneous_density();
  const FogInterval fog = b0 > 0.0 ? medium.fog().interval(eye, w) : FogInterval{0.0, 0.0};
  const ViewRayMedium<double> ray(along, b0, eye, w, length, medium.noise(), {}, fog);
  result.depth = ray.depth(length);
  last = std::max(last, fog.end);
  if (along.empty() && !(fog.end > 0.0)) return result;

  // The part of the ray that scatters at all; past it shadows are of no interest.
  double end = ray.parameter_at_depth(50.0);
  end = std::min(end, last);
  const ViewRayMedium<double> lit(along, b0, eye, w, end, medium.noise(), optics, fog);
  result.airlight = emission_integral(lit, tolerance);
  if (environment) result.airlight += environment->airlight(medium, lit, tolerance);
  for (const PointSource& light : lights) {
    LightSource<double> source{light.position, light.h_min,   {},       medium.anisotropy(),
                               std::nullopt,   light.falloff, light.fog};
    std::vector<GaussianTerm<double>> toward_light;
    // An endless ray in fog is cut at 1e15 u, beyond which nothing contributes.
    const glm::dvec3 far = eye + std::min(end, 1e15) * w;
    medium.bvh().query(TriangleShape{light.position, eye, far},
                       [&](std::uint32_t i) { toward_light.push_back(medium.gaussians()[i]); });
    source.gaussians = toward_light;
    result.light_pairs += toward_light.size();
    if (!exact_occlusion.empty()) {
      source.lit = exact_occlusion.lit(light.position, eye, w, std::min(end, 1e15));
    }
    result.airlight += light.intensity * airlight_integral(lit, source, tolerance);
  }
  return result;
}

namespace {

using std::numbers::pi;

// Number of directions for transmittance. On fog patches under skies with a low sun the error falls
// with their number to the power 1.3. The forward lobe can make any part of the sky dominant, so
// clusters are limited in size by rows, with as many again by irradiance.
LightGrouping directions(double anisotropy, double tolerance) {
  const int rows = anisotropy == 0.0 ? 4 : std::abs(anisotropy) < 0.7 ? 8 : 16;
  const auto boxes = static_cast<std::size_t>(2 * rows * rows);
  const double count = std::clamp(250.0 * std::pow(tolerance / 1e-3, -0.6), 64.0, 8192.0);
  return {.groups = boxes + static_cast<std::size_t>(count), .min_rows = rows};
}

}  // namespace

ReferenceEnvironment::ReferenceEnvironment(const Environment& environment, double anisotropy,
                                           double fog_depth, double tolerance)
    : anisotropy_(anisotropy),
      attenuation_(std::exp(-fog_depth)),
      groups_(distant_light_groups(*environment.map, directions(anisotropy, tolerance))) {
  const glm::dquat rotation = environment_rotation(environment);
  const auto place = [&](DistantLight& light) {
    light.direction = rotation * light.direction;
    light.irradiance *= environment.intensity;
  };
  for (LightGroup& group : groups_) {
    place(group.combined);
    for (DistantLight& light : group.lights) place(light);
  }
}

std::vector<DistantLight> ReferenceEnvironment::scattered_along(const glm::dvec3& w) const {
  const double scale = attenuation_ / (4.0 * pi);
  std::vector<DistantLight> result;
  result.reserve(groups_.size());
  for (const LightGroup& group : groups_) {
    if (anisotropy_ == 0.0) {
      result.push_back({group.combined.direction, scale * group.combined.irradiance});
      continue;
    }
    glm::dvec3 irradiance(0.0);
    glm::dvec3 moment(0.0);
    for (const DistantLight& light : group.lights) {
      const glm::dvec3 scattered =
          scale * henyey_greenstein(glm::dot(w, light.direction), anisotropy_) * light.irradiance;
      irradiance += scattered;
      moment += (scattered.x + scattered.y + scattered.z) * light.direction;
    }
    const double length = glm::length(moment);
    result.push_back({length > 0.0 ? moment / length : group.combined.direction, irradiance});
  }
  return result;
}

glm::dvec3 ReferenceEnvironment::source(const MediumIndex& medium, const glm::dvec3& x,
                                        const glm::dvec3& w) const {
  return sum(medium, x, scattered_along(w));
}

glm::dvec3 ReferenceEnvironment::sum(const MediumIndex& medium, const glm::dvec3& x,
                                     std::span<const DistantLight> scattered) const {
  GaussiansAroundLight<double> around(x);
  double beyond = 0.0;
  for (std::size_t i = 0; i < medium.size(); ++i) {
    const double cutoff_radius = medium.cutoff_radii()[i];
    if (!(cutoff_radius > 0.0)) continue;
    around.add(medium.gaussians()[i], cutoff_radius);
    beyond = std::max(beyond, glm::length(medium.gaussians()[i].b - x) + 2.0 * cutoff_radius);
  }
  around.finish();
  glm::dvec3 result(0.0);
  const bool is_fog_everywhere = medium.fog().is_endless();
  for (const DistantLight& light : scattered) {
    const double fog = is_fog_everywhere ? 0.0 : medium.fog_depth(x, light.direction, infinity);
    result += std::exp(-around.depth(light.direction, beyond) - fog) * light.irradiance;
  }
  return result;
}

glm::dvec3 ReferenceEnvironment::airlight(const MediumIndex& medium,
                                          const ViewRayMedium<double>& ray,
                                          double tolerance) const {
  // Over the opacity u of the ray up to x, of which J is a smooth function.
  const double opacity = -std::expm1(-ray.depth(ray.d));
  if (!(opacity > 0.0)) return glm::dvec3(0.0);
  const std::vector<DistantLight> scattered = scattered_along(ray.w);
  std::map<double, glm::dvec3> cache;  // the channels mostly evaluate the same points
  glm::dvec3 result(0.0);
  for (int c = 0; c < 3; ++c) {
    const auto channel = [&](double u) {
      const auto [it, is_new] = cache.try_emplace(u);
      if (is_new) {
        const double t = ray.parameter_at_depth(-std::log1p(-u));
        it->second = sum(medium, ray.eye + t * ray.w, scattered) * ray.optics_at(t).albedo;
      }
      return it->second[c];
    };
    // The rule's own estimate is more than ten times its error here.
    result[c] = integrate<double>(channel, std::array{0.0, opacity}, 10.0 * tolerance).value;
  }
  return result;
}

}  // namespace brume
