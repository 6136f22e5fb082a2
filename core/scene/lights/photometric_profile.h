#pragma once

#include <glm/vec3.hpp>
#include <memory>
#include <vector>

#include "core/scene/lights/intensity_map.h"

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

  // The same for fast look-ups.
  [[nodiscard]] const std::shared_ptr<const IntensityMap>& map() const { return map_; }

  // The memory it takes.
  [[nodiscard]] std::size_t bytes() const {
    return map_->values.size() * sizeof(float) + values_.size() * sizeof(double);
  }

 private:
  std::vector<double> polar_angles_;
  std::vector<double> azimuths_;
  std::vector<double> values_;
  double solid_angle_ = 0.0;
  std::shared_ptr<const IntensityMap> map_;
};

}  // namespace brume
