#include "render/paths/camera_ray.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace brume {
namespace {

// Optical depth beyond which nothing returns: exp(-40) = 4e-18.
constexpr double opaque = 40.0;

std::vector<GaussianTerm<double>> gaussians_on(const MediumIndex& medium, const glm::dvec3& eye,
                                               const glm::dvec3& w, double length) {
  std::vector<GaussianTerm<double>> found;
  medium.bvh().query(RaySegment{eye, w, length, medium.max_displacement()},
                     [&](std::uint32_t i) { found.push_back(medium.gaussians()[i]); });
  return found;
}

}  // namespace

CameraRay::CameraRay(const MediumIndex& medium, const glm::dvec3& eye, const glm::dvec3& w,
                     double length)
    : medium_(
          [&] {
            std::vector<GaussianTerm<double>> found = gaussians_on(medium, eye, w, length);
            gaussians_ = found.size();
            return found;
          }(),
          medium.homogeneous_density(), eye, w, length, medium.noise(), {},
          medium.fog().interval(eye, w)) {
  if (gaussians_ > 0 || medium.homogeneous_density() > 0.0) depth_ = medium_.depth(length);
  if (!(depth_ > 0.0)) return;
  // Between them all but a millionth of what scatters.
  const double first = medium_.parameter_at_depth(1e-6 * std::min(depth_, 1.0));
  const double last = medium_.parameter_at_depth(
      depth_ > opaque ? opaque : depth_ * (1.0 - (std::isfinite(length) ? 0.0 : 1e-9)));
  for (std::size_t i = 0; i < nodes; ++i) {
    const double f = static_cast<double>(i) / (nodes - 1);
    t_[i] = i + 1 == nodes ? last : first + f * (last - first);
    depths_[i] = medium_.depth(t_[i]);
  }
}

CameraRay::Point CameraRay::at(double t) const {
  const auto sums = medium_.at(t);
  return {t, sums.density + medium_.homogeneous_density(t), sums.depth};
}

CameraRay::Point CameraRay::at_depth(double level) const {
  const auto above = std::ranges::lower_bound(depths_, level);
  if (above == depths_.end()) return at(t_.back());
  const auto i = static_cast<std::size_t>(above - depths_.begin());
  double low = i > 0 ? t_[i - 1] : 0.0;
  double high = t_[i];
  const double depth_low = i > 0 ? depths_[i - 1] : 0.0;
  // Newton's method, bisecting where it leaves the bracket.
  double t = low + (high - low) * (level - depth_low) / (depths_[i] - depth_low);
  Point point = at(t);
  for (int k = 0; k < 100; ++k) {
    const double error = point.depth - level;
    if (std::abs(error) <= 1e-12 * level) break;
    (error < 0.0 ? low : high) = t;
    double next = t - error / point.density;
    if (!(low < next && next < high)) next = 0.5 * (low + high);
    if (!(low < next && next < high)) break;
    t = next;
    point = at(t);
  }
  return point;
}

}  // namespace brume
