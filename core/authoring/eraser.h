#pragma once

#include <functional>
#include <span>
#include <unordered_map>

#include "core/medium/medium_edit.h"

namespace brume {

// What an eraser covers from the eye: a cone around a unit direction, `slope` u wide per u of
// distance along it.
struct EraserCone {
  glm::dvec3 eye{0.0};
  glm::dvec3 direction{0.0, 0.0, -1.0};
  double slope = 0.1;  // tangent of the half angle, > 0
};

// How much an eraser takes from a Gaussian whose centre is in the cone: 1 on the axis, falling
// smoothly to 0 at the rim and beyond.
double eraser_cover(const EraserCone& cone, const glm::dvec3& center);

// A stroke of the eraser (section 6 of the paper). Each touch takes `strength` * eraser_cover() of
// the density that a Gaussian had when the stroke first met it; one that has none left is removed.
class EraserStroke {
 public:
  explicit EraserStroke(double strength) : strength_(strength) {}  // in (0, 1]

  // The edit that some touches are, one after the other. Only Gaussians for which `may_erase` are
  // touched.
  MediumEdit touch(const Medium& medium, std::span<const EraserCone> cones,
                   const std::function<bool(GaussianId)>& may_erase);

 private:
  struct Touched {
    double density = 0.0;  // at first
    double erased = 0.0;   // share
  };
  double strength_;
  std::unordered_map<GaussianId, Touched> touched_;
};

}  // namespace brume
