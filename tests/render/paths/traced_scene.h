#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <optional>

#include "brume/scene.h"
#include "render/paths/path_tracer.h"
#include "render/reference/reference_airlight.h"

namespace brume {

// Mean and standard error of samples.
struct PathEstimate {
  glm::dvec3 mean{0.0};
  glm::dvec3 error{0.0};
};

// A scene for tests that trace single rays. Its densities are extinction; `albedo` is that of all
// channels, and the first collision's is included.
class TracedScene {
 public:
  explicit TracedScene(const Scene& scene, double albedo = 1.0);

  struct Estimate {
    std::array<PathEstimate, 3> orders;
    PathEstimate sum;
  };
  // Along the ray from `eye` towards `target`, to the first surface. Errors are of independent
  // blocks; `paths` is a multiple of path_block.
  [[nodiscard]] Estimate airlight(const glm::dvec3& eye, const glm::dvec3& target, int paths,
                                  std::uint64_t seed = 1) const;
  // Towards the eye, of the surface that the ray hits.
  [[nodiscard]] Estimate surface(const glm::dvec3& eye, const glm::dvec3& target, int paths,
                                 std::uint64_t seed = 1) const;

  // Light scattered once, by `reference`, where surfaces do not keep the environment out.
  [[nodiscard]] glm::dvec3 single_scattering(const glm::dvec3& eye, const glm::dvec3& target) const;

  [[nodiscard]] const RayCaster& ray_caster() const { return ray_caster_; }

 private:
  [[nodiscard]] double length(const glm::dvec3& eye, const glm::dvec3& w) const;  // of a view ray
  [[nodiscard]] PathScene scene_from(const glm::dvec3& eye) const;
  template <class Sample>
  [[nodiscard]] static Estimate estimate(int paths, Sample sample);

  Scene scene_;
  double albedo_;
  MediumIndex index_;
  PathMedium medium_;
  RayCaster ray_caster_;
  std::optional<EnvironmentSampler> environment_;
  FogBall fog_;
  double fog_depth_;
};

}  // namespace brume
