#pragma once

#include <glm/vec3.hpp>
#include <vector>

#include "core/io/image/deep_exr_file.h"

namespace brume {

// Transmittance and airlight up to points on a ray, per channel.
struct RayProfile {
  std::vector<float> distances;           // ascending [u]
  std::vector<glm::dvec3> depths;         // optical depth from the eye, ascending
  std::vector<glm::dvec3> airlight;       // that reaches the eye, ascending
  std::vector<glm::dvec3> transmittance;  // exp(-depths); see add()

  [[nodiscard]] std::size_t size() const { return distances.size(); }
  void clear();
  void add(float distance, const glm::dvec3& depth, const glm::dvec3& light);
};

// How far a deep pixel may be off wherever it is held out: that is what it shows of the fog up to
// any distance.
struct DeepTolerance {
  double transmittance = 0.0;
  glm::dvec3 airlight{0.0};
};

// The error between two neighbouring points that one sample stands for, in tolerances; from how far
// every second point, half-way between its neighbours, is off what they interpolate to.
double error_between_points(const RayProfile& ray, const DeepTolerance& tolerance);

// Appends the volume samples of a ray: as few as have the tolerance at every point, each as long as
// it can be. At both of its ends a sample is exact, so all of them together are what the ray ends
// with. Two neighbouring points make a sample even if that breaks the tolerance.
void fit_deep_samples(const RayProfile& ray, const DeepTolerance& tolerance,
                      std::vector<DeepSample>& samples);

}  // namespace brume
