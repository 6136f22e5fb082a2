#pragma once

#include <array>
#include <glm/vec3.hpp>

#include "render/geometry/medium_index.h"
#include "render/reference/airlight_integral.h"

namespace brume {

// The medium along a view ray, displaced by noise, with its optical depth tabulated to be inverted
// often.
class CameraRay {
 public:
  // `w` unit; `length` to the surface or the end of the fog, may be +inf.
  CameraRay(const MediumIndex& medium, const glm::dvec3& eye, const glm::dvec3& w, double length);

  [[nodiscard]] const glm::dvec3& eye() const { return medium_.eye; }
  [[nodiscard]] const glm::dvec3& w() const { return medium_.w; }
  // The optical depth of the whole ray; +inf possible.
  [[nodiscard]] double depth() const { return depth_; }
  [[nodiscard]] std::size_t gaussians() const { return gaussians_; }

  struct Point {
    double t = 0.0;        // [u]
    double density = 0.0;  // extinction [1/u]
    double depth = 0.0;    // from the eye
  };
  [[nodiscard]] Point at(double t) const;
  // Where the depth is `level` <= depth().
  [[nodiscard]] Point at_depth(double level) const;
  // Where nothing returns from behind any more, or the end of the ray [u].
  [[nodiscard]] double visible_length() const { return t_.back(); }

 private:
  static constexpr std::size_t nodes = 33;

  std::size_t gaussians_ = 0;
  ViewRayMedium<double> medium_;
  double depth_ = 0.0;
  std::array<double, nodes> t_{};
  std::array<double, nodes> depths_{};
};

}  // namespace brume
