#pragma once

#include <array>
#include <glm/vec2.hpp>
#include <vector>

namespace brume {

// The centripetal Catmull-Rom curve through four points, each unlike the next, from the second
// (left out) to the third: points at most about `spacing` (> 0) apart. Between points that lie
// unevenly, as those of a fast mouse do, it has neither cusps nor loops.
std::vector<glm::dvec2> catmull_rom(const std::array<glm::dvec2, 4>& points, double spacing);

// A smooth curve through the positions of a stroke, in the making: it is one position behind, since
// how it bends to a position depends on the next.
class SmoothPath {
 public:
  SmoothPath(const glm::dvec2& start, double spacing);

  // The points of the curve that another position settles, after those answered before.
  std::vector<glm::dvec2> to(const glm::dvec2& position);
  // Those that are left when there is no other.
  std::vector<glm::dvec2> end();

 private:
  double spacing_;
  std::vector<glm::dvec2> last_;  // at most three: the curve is settled up to the one before last
};

}  // namespace brume
