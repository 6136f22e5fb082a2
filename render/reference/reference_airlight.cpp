#include "render/reference/reference_airlight.h"

#include <algorithm>

#include "render/reference/airlight_integral.h"

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

}  // namespace brume
