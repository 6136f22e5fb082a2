#include "render/reference/environment_integral.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>
#include <numbers>

#include "core/math/quadrature.h"
#include "core/scene/environment.h"
#include "core/transport/phase_function.h"

namespace brume {
namespace {

constexpr double pi = std::numbers::pi;

// From pole to pole. The error of a midpoint rule falls with the square of its steps; the peak of
// the phase function wants a few of them.
int rows_of_sphere(double anisotropy, double tolerance) {
  const double smooth = 0.25 / std::sqrt(tolerance);
  const double peak = pi / (0.4 * (1.0 - std::abs(anisotropy)));
  return static_cast<int>(std::ceil(std::clamp(std::max(smooth, peak), 8.0, 64.0)));
}

}  // namespace

ReferenceEnvironment::ReferenceEnvironment(const Environment& environment, double anisotropy,
                                           double fog_depth, double tolerance)
    : anisotropy_(anisotropy),
      attenuation_(std::exp(-fog_depth)),
      lights_(even_distant_lights(*environment.map, rows_of_sphere(anisotropy, tolerance))) {
  for (DistantLight& light : lights_) {
    light.direction = environment_rotation(environment) * light.direction;
    light.flux *= environment.intensity;
  }
}

glm::dvec3 ReferenceEnvironment::source(const MediumIndex& medium, const glm::dvec3& x,
                                        const glm::dvec3& w) const {
  GaussiansAroundLight<double> around(x);
  double beyond = 0.0;
  for (std::size_t i = 0; i < medium.size(); ++i) {
    const double reach = medium.reach()[i];
    if (!(reach > 0.0)) continue;
    around.add(medium.gaussians()[i], reach);
    beyond = std::max(beyond, glm::length(medium.gaussians()[i].b - x) + 2.0 * reach);
  }
  around.finish();
  glm::dvec3 sum(0.0);
  for (const DistantLight& light : lights_) {
    const double turned = henyey_greenstein(glm::dot(w, light.direction), anisotropy_);
    sum += turned * std::exp(-around.depth(light.direction, beyond)) * light.flux;
  }
  return attenuation_ / (4.0 * pi) * sum;
}

glm::dvec3 ReferenceEnvironment::airlight(const MediumIndex& medium,
                                          const ViewRayMedium<double>& ray,
                                          double tolerance) const {
  // Over the share u of the ray's light that is gone at x, of which J is a smooth function.
  const double gone = -std::expm1(-ray.depth(ray.d));
  if (!(gone > 0.0)) return glm::dvec3(0.0);
  std::map<double, glm::dvec3> known;  // the channels mostly ask at the same places
  glm::dvec3 sum(0.0);
  for (int c = 0; c < 3; ++c) {
    const auto channel = [&](double u) {
      const auto [at, is_new] = known.try_emplace(u);
      if (is_new) {
        const double t = ray.parameter_at_depth(-std::log1p(-u));
        at->second = source(medium, ray.eye + t * ray.w, ray.w);
      }
      return at->second[c];
    };
    // The rule's own estimate is more than ten times its error here.
    sum[c] = integrate<double>(channel, std::array{0.0, gone}, 10.0 * tolerance).value;
  }
  return sum;
}

}  // namespace brume
