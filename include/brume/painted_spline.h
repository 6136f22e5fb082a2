#pragma once

#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

#include "brume/brush.h"
#include "brume/gaussian.h"
#include "brume/object_id.h"

namespace brume {

// Identifies a spline in its scene; 0: none.
using SplineId = std::uint32_t;

// A spline that fog was painted along, and what it takes to paint it again. Its Gaussians are in
// the medium like any others; nothing is rendered of the spline itself.
struct PaintedSpline {
  SplineId id = 0;                   // of one scene, > 0
  std::string name{};                // not empty, of one scene
  std::vector<glm::dvec3> points{};  // 1 to limits::spline_points; see core/authoring/spline.h
  Paintbrush brush{};
  MirrorPlanes mirrors{};
  GaussianOptics optics{};
  std::int64_t seed = 1;                // of the stroke
  std::vector<GaussianId> gaussians{};  // painted along it, ascending; some may have been deleted
  ObjectId object_id = 0;               // of what its scene file has besides

  bool operator==(const PaintedSpline&) const = default;
};

// The one with this id; nullptr: none.
template <class Splines>
auto* find_spline(Splines& splines, SplineId id) {
  const auto found = std::ranges::find(splines, id, &PaintedSpline::id);
  return found == splines.end() ? nullptr : &*found;
}

}  // namespace brume
