#pragma once

#include <functional>
#include <span>
#include <unordered_map>

#include "brume/edits.h"

namespace brume {

// The cone covered by an eraser: `slope` u wide per u of distance along the unit direction, or for
// parallel rays a cylinder.
struct EraserCone {
  glm::dvec3 eye{0.0};
  glm::dvec3 direction{0.0, 0.0, -1.0};
  double slope = 0.1;   // tangent of the half angle; 0 of a cylinder
  double radius = 0.0;  // of a cylinder [u]

  [[nodiscard]] double reach(double along) const { return along * slope + radius; }
};

// Weight of the eraser at a Gaussian's center: 1 on the axis, falling smoothly to 0 at the rim.
double eraser_cover(const EraserCone& cone, const glm::dvec3& center);

// An eraser stroke (section 6 of the paper). Each touch removes `strength` * eraser_cover() of the
// density that a Gaussian had when first touched; Gaussians of zero density are removed.
class EraserStroke {
 public:
  explicit EraserStroke(double strength) : strength_(strength) {}  // in (0, 1]

  // The edit of a sequence of touches, restricted to Gaussians for which `may_erase`.
  MediumEdit touch(const Medium& medium, std::span<const EraserCone> cones,
                   const std::function<bool(GaussianId)>& may_erase);

 private:
  struct Touched {
    double density = 0.0;  // before the stroke
    double erased = 0.0;   // fraction
  };
  double strength_;
  std::unordered_map<GaussianId, Touched> touched_;
};

}  // namespace brume
