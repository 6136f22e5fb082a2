#include "core/scene/lights/photometric_profile.h"

#include <algorithm>
#include <cmath>
#include <glm/trigonometric.hpp>
#include <utility>

namespace brume {
namespace {

// Where x lies between ascending values: x = values[low] + share * (values[low + 1] - values[low]).
struct AngleInterval {
  std::size_t low = 0;
  double share = 0.0;
};

AngleInterval interval_of(const std::vector<double>& values, double x) {
  if (values.size() < 2) return {};
  const auto above = std::upper_bound(values.begin() + 1, values.end() - 1, x);
  const auto low = static_cast<std::size_t>(above - values.begin()) - 1;
  return {low, std::clamp((x - values[low]) / (values[low + 1] - values[low]), 0.0, 1.0)};
}

// The integral of sin p times (1 - s) over s in [0, 1], p = begin + s width, and of sin p times s.
std::pair<double, double> sine_weights(double begin, double width) {
  if (width < 1e-4) {
    const double half = 0.5 * std::sin(begin + 0.5 * width);
    return {half, half};
  }
  const double mean = (std::cos(begin) - std::cos(begin + width)) / width;
  const double rising = (std::sin(begin + width) - std::sin(begin)) / (width * width) -
                        std::cos(begin + width) / width;
  return {mean - rising, rising};
}

glm::dvec3 octahedral_direction(double u, double v) {
  const double z = 1.0 - std::abs(u) - std::abs(v);
  if (z >= 0.0) return {u, v, z};
  return {std::copysign(1.0 - std::abs(v), u), std::copysign(1.0 - std::abs(u), v), z};
}

}  // namespace

PhotometricProfile::PhotometricProfile(std::vector<double> polar_angles,
                                       std::vector<double> azimuths,
                                       std::vector<double> intensities)
    : polar_angles_(std::move(polar_angles)),
      azimuths_(std::move(azimuths)),
      values_(std::move(intensities)) {
  const double greatest = std::ranges::max(values_);
  for (double& value : values_) value /= greatest;

  const std::size_t rows = polar_angles_.size();
  for (std::size_t a = 0; a + 1 < azimuths_.size(); ++a) {
    const double turn = glm::radians(azimuths_[a + 1] - azimuths_[a]);
    const auto mean = [&](std::size_t p) {
      return 0.5 * (values_[a * rows + p] + values_[(a + 1) * rows + p]);
    };
    for (std::size_t p = 0; p + 1 < rows; ++p) {
      const double begin = glm::radians(polar_angles_[p]);
      const double width = glm::radians(polar_angles_[p + 1]) - begin;
      const auto [falling, rising] = sine_weights(begin, width);
      solid_angle_ += turn * width * (falling * mean(p) + rising * mean(p + 1));
    }
  }

  constexpr int side = 257;
  IntensityMap map{.side = side};
  map.values.reserve(std::size_t{side} * side);
  const auto coordinate = [](int i) { return 2.0 * i / (side - 1) - 1.0; };
  for (int y = 0; y < side; ++y) {
    for (int x = 0; x < side; ++x) {
      map.values.push_back(
          static_cast<float>(at(octahedral_direction(coordinate(x), coordinate(y)))));
    }
  }
  map_ = std::make_shared<const IntensityMap>(std::move(map));
}

PhotometricProfile PhotometricProfile::isotropic() {
  return {{0.0, 180.0}, {0.0, 360.0}, std::vector(4, 1.0)};
}

double PhotometricProfile::at(const glm::dvec3& w) const {
  const double across = std::hypot(w.x, w.y);
  const double polar = glm::degrees(std::atan2(across, w.z));
  // Rounding may leave so much.
  constexpr double room = 1e-9;
  if (polar < polar_angles_.front() - room || polar > polar_angles_.back() + room) return 0.0;
  double azimuth = across > 0.0 ? glm::degrees(std::atan2(w.y, w.x)) : 0.0;
  if (azimuth < 0.0) azimuth += 360.0;
  const AngleInterval p = interval_of(polar_angles_, polar);
  const AngleInterval a = interval_of(azimuths_, azimuth);
  const std::size_t rows = polar_angles_.size();
  const std::size_t next = rows > 1 ? 1 : 0;
  const auto along = [&](std::size_t column) {
    const double* values = values_.data() + column * rows + p.low;
    return std::lerp(values[0], values[next], p.share);
  };
  return std::lerp(along(a.low), along(a.low + 1), a.share);
}

}  // namespace brume
