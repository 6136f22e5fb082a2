#pragma once

#include <glm/vec3.hpp>
#include <span>
#include <vector>

namespace brume {

// Relative intensity of a luminaire by direction, as type C photometry tabulates it (IES LM-63).
// Directions are (x, y, z) = (sin p cos a, sin p sin a, cos p), with the polar angle p from the
// axis, which is straight down as the luminaire hangs, and the azimuth a, counterclockwise seen
// from above.
class PhotometricProfile {
 public:
  // Degrees, ascending: at least one polar angle, in [0, 180], and two azimuths, the first 0, the
  // last 360. `intensities`: finite, >= 0, one at least > 0, in any unit; those of an azimuth
  // follow each other.
  PhotometricProfile(std::vector<double> polar_angles, std::vector<double> azimuths,
                     std::vector<double> intensities);

  // The same in all directions.
  static PhotometricProfile isotropic();

  // In a direction of any length but 0: linear in both angles between the tabulated ones, 0 beyond
  // the polar angles. In [0, 1], 1 at the greatest.
  [[nodiscard]] double at(const glm::dvec3& w) const;

  // Its integral over all directions [sr].
  [[nodiscard]] double solid_angle() const { return solid_angle_; }

  // For fast look-ups: at() at side x side points of an octahedral map, rows one after the other,
  // to be interpolated in both coordinates. The map takes (x, y) / (|x| + |y| + |z|), folded over
  // the diagonals for z < 0, from [-1, 1]^2.
  static constexpr int side = 257;
  [[nodiscard]] std::span<const float> map() const { return map_; }

  // The memory it takes.
  [[nodiscard]] std::size_t bytes() const {
    return map_.size() * sizeof(float) + values_.size() * sizeof(double);
  }

 private:
  std::vector<double> polar_angles_;
  std::vector<double> azimuths_;
  std::vector<double> values_;
  double solid_angle_ = 0.0;
  std::vector<float> map_;
};

}  // namespace brume
