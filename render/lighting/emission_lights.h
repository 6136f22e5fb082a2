#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "core/revision.h"
#include "render/geometry/box.h"
#include "render/geometry/medium_index.h"
#include "render/geometry/point_source.h"
#include "render/lighting/optical_depth_table.h"
#include "render/util/job.h"

namespace brume {

// Small Gaussians that emit light, as point lights for the light scattered more than once. A grid
// sends what it holds in a few hundred directions: what is small would light walls in patches.
// Larger ones stay on the grid, which knows where within them they emit.
//
// Neighbours are one light, at their center of intensity. Its intensity makes up for what they
// absorb of their own light: a table of optical depths from the center has it in all directions
// alike, as if all were emitted there.
class EmissionLights {
 public:
  struct Light {
    PointSource source;  // intensity times the medium's albedo; see RelativeOptics
    std::unique_ptr<const OpticalDepthTable> table;
  };

  // Of a medium in which surfaces are within `surfaces`; empty: there are none. Cached. Empty after
  // the job was stopped.
  void update(const MediumIndex& medium, double albedo, const Box& surfaces, const Job& job);
  void clear() { *this = EmissionLights(); }

  [[nodiscard]] std::span<const Light> lights() const { return lights_; }
  // What is not among the lights: optics() of the medium, without their emission.
  [[nodiscard]] std::span<const RelativeOptics> others() const { return others_; }
  [[nodiscard]] Revision revision() const { return revision_; }

 private:
  Revision medium_ = 0;
  double albedo_ = 0.0;
  Box surfaces_;
  Revision revision_ = 0;
  std::vector<Light> lights_;
  std::vector<RelativeOptics> others_;
};

}  // namespace brume
