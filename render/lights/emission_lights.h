#pragma once

#include <memory>
#include <span>
#include <vector>

#include "brume/revision.h"
#include "render/geometry/medium_index.h"
#include "render/geometry/point_source.h"
#include "render/optical_depth/optical_depth_table.h"
#include "render/util/job.h"
#include "render/visibility/ray_caster.h"

namespace brume {

// Gaussians that emit light, as point lights for the light scattered more than once. A grid sends
// what it holds in a few hundred directions: what is small there would light walls in patches, and
// what is smaller than its spacing is widened. What is larger stays on the grid, which knows where
// within it light is emitted.
//
// Neighbours are one light: a normal distribution around their center of intensity. Its table of
// optical depths has what lets through of it the whole medium, themselves among it, in the mean
// over points that are spread as their emission is.
class EmissionLights {
 public:
  struct Light {
    PointSource source;  // intensity times the medium's albedo; see RelativeOptics
    std::unique_ptr<const OpticalDepthTable> table;
    double width = 0.0;  // of what it stands for [u]
    std::vector<std::size_t> gaussians;
  };

  // Finds those of a medium around surfaces; null: there are none. Cached. Empty after the job was
  // stopped.
  void update(const MediumIndex& medium, double albedo, const RayCaster* surfaces, const Job& job);
  void clear() { *this = EmissionLights(); }

  [[nodiscard]] std::span<const Light> lights() const { return lights_; }
  // What a grid holds: optics() of the medium, without the emission of what are points to it:
  // is_point(light).
  template <class IsPoint>
  [[nodiscard]] std::vector<RelativeOptics> held(IsPoint is_point) const {
    std::vector<RelativeOptics> optics = optics_;
    for (const Light& light : lights_) {
      if (!is_point(light)) continue;
      for (const std::size_t i : light.gaussians) optics[i].emission = glm::dvec3(0.0);
    }
    return optics;
  }
  [[nodiscard]] Revision revision() const { return revision_; }

 private:
  Revision medium_ = 0;
  FogBall fog_;
  double albedo_ = 0.0;
  Revision surfaces_ = 0;
  Revision revision_ = 0;
  std::vector<Light> lights_;
  std::vector<RelativeOptics> optics_;
};

}  // namespace brume
