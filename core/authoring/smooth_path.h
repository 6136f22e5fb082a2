#pragma once

#include <array>
#include <glm/vec2.hpp>
#include <vector>

namespace brume {

// The centripetal Catmull-Rom segment from the second (excluded) to the third of four distinct
// points, sampled at most about `spacing` > 0 apart. No cusps or loops for unevenly spaced points.
std::vector<glm::dvec2> catmull_rom(const std::array<glm::dvec2, 4>& points, double spacing);

// Incremental smooth curve through the positions of a stroke; lags one position behind, which the
// tangents need.
class SmoothPath {
 public:
  SmoothPath(const glm::dvec2& start, double spacing);

  // Adds a position; returns the new points of the curve.
  std::vector<glm::dvec2> extend(const glm::dvec2& position);
  // The remaining points after the last position.
  std::vector<glm::dvec2> end();

 private:
  double spacing_;
  std::vector<glm::dvec2> last_;  // at most three; the curve is complete up to the last but one
};

}  // namespace brume
