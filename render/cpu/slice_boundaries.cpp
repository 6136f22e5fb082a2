#include "render/cpu/slice_boundaries.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <numbers>

#include "core/transport/light_path.h"
#include "render/cpu/ray_range.h"

namespace brume {
namespace {

// Where light falls off within a medium, slices of equal angle as seen from the light.
void add_equi_angular(const SlicedLight& light, const glm::dvec3& eye, const glm::dvec3& w,
                      const RayRange& range, int count, std::vector<double>& boundaries) {
  // A light almost on the ray would put all slices at one point: half a slice is fine enough, of
  // what is near the light if the medium is endless.
  const double near = 16.0 * glm::length(light.position - (eye + range.begin * w));
  const double least = 0.25 * std::min(range.end - range.begin, near) / count;
  const EquiAngular<double> angular(
      LightPath<double>(light.position, eye, w, std::max(light.h_min, least)), range.end);
  const double begin = angular.angle(range.begin);
  for (int k = 1; k < count; ++k) {
    const double t = angular.t(begin + (angular.span - begin) * k / count);
    if (t > range.begin && t < range.end) boundaries.push_back(t);
  }
}

// The depth of a line through a Gaussian of radius r, where its density is at most `peak`.
double line_depth(double peak, double r) {
  return std::sqrt(std::numbers::pi) * peak * r;
}

// An opaque Gaussian wants slices out to where its tail has this depth.
constexpr double tail_depth = 0.02;

// How far from its centre a Gaussian of radius r and density c wants slices.
double core_reach(double r, double c) {
  return line_depth(c, r) < slice_opaque ? 2.0 * r : reach(r, c, tail_depth);
}

// How many boundaries a stretch of a ray wants: the midpoint rule is off by the second derivative
// of what it sums, so slices go with its cube root (c / r^2 within a Gaussian, seen through what
// lies before it), over an even share that keeps thin media in view.
class SliceDemand {
 public:
  SliceDemand(const RayRange& range, int bins)
      : begin_(range.begin),
        width_((range.end - range.begin) / bins),
        rate_(static_cast<std::size_t>(bins) + 1),
        curvature_(static_cast<std::size_t>(bins) + 1) {}

  // A Gaussian of radius r whose density is `peak` where the ray passes it at t.
  void add(double t, double r, double peak) {
    add_box(t, 1.5 * r, 0.59 * peak, peak / (r * r));  // with the Gaussian's integral
    if (line_depth(peak, r) < slice_opaque) return;
    const double last = reach(r, peak, tail_depth) / r;
    for (double k = 1.5; k < last; k += 0.5) {
      const double middle = k + 0.25;
      const double density = peak * std::exp(-middle * middle);
      add_box(t, (k + 0.5) * r, density, 4.0 * middle * middle * density / (r * r));
    }
  }

  // Appends the ends of the range and what lies between `count` slices of equal demand.
  void cut(int count, std::vector<double>& boundaries) const {
    const std::size_t bins = rate_.size() - 1;
    thread_local std::vector<double> demand;
    demand.assign(bins, 0.0);
    double rate = 0.0;
    double curvature = 0.0;
    double depth = 0.0;
    double sum = 0.0;
    for (std::size_t i = 0; i < bins; ++i) {
      rate += rate_[i];
      curvature += curvature_[i];
      demand[i] = std::cbrt(std::max(curvature, 0.0) / (1.0 + std::clamp(depth, 0.0, 4.0)));
      // Behind that much only rays are seen that pass beside it.
      if (depth > slice_opaque) demand[i] *= slice_opaque / depth;
      depth += rate * width_;
      sum += demand[i];
    }
    const double even = sum > 0.0 ? 0.3 * sum / static_cast<double>(bins) : 1.0;
    sum += even * static_cast<double>(bins);
    boundaries.push_back(begin_);
    double reached = 0.0;
    int k = 1;
    for (std::size_t i = 0; i < bins && k < count; ++i) {
      const double here = demand[i] + even;
      for (double wanted = sum * k / count; k < count && wanted <= reached + here;
           wanted = sum * ++k / count) {
        boundaries.push_back(begin_ +
                             width_ * (static_cast<double>(i) + (wanted - reached) / here));
      }
      reached += here;
    }
    boundaries.push_back(begin_ + width_ * static_cast<double>(bins));
  }

 private:
  void add_box(double t, double half, double rate, double curvature) {
    const auto bin = [this](double x) {
      const double most = static_cast<double>(rate_.size() - 1);
      return static_cast<std::size_t>(std::clamp((x - begin_) / width_ + bin_room, 0.0, most));
    };
    const std::size_t first = bin(t - half);
    const std::size_t last = bin(t + half) + 1;
    if (last >= rate_.size() && first + 1 >= rate_.size()) return;
    rate_[first] += rate;
    curvature_[first] += curvature;
    if (last < rate_.size()) {
      rate_[last] -= rate;
      curvature_[last] -= curvature;
    }
  }

  double begin_;
  double width_;
  std::vector<double> rate_;       // differences from bin to bin
  std::vector<double> curvature_;  // the same
};

}  // namespace

void choose_slices(const MediumIndex& medium, std::span<const std::uint32_t> gaussians,
                   std::span<const SlicedLight> lights, const TileRays& rays, int slices,
                   std::vector<double>& boundaries) {
  boundaries.clear();
  glm::dvec3 sum(0.0);
  for (const glm::dvec3& direction : rays.directions) sum += direction;
  const glm::dvec3 w = glm::normalize(sum);
  const double longest = *std::max_element(rays.lengths.begin(), rays.lengths.end());
  // How far a ray of the tile is from the middle one, at distance 1.
  double spread = 0.0;
  for (const glm::dvec3& direction : rays.directions) {
    spread = std::max(spread, glm::dot(direction - w, direction - w));
  }
  spread = std::sqrt(spread);

  // The Gaussians: slices over two radii or more to both sides, and one more for the tail at each
  // end.
  RayRange reach;
  RayRange core;
  for (const std::uint32_t i : gaussians) {
    const GaussianTerm<double>& g = medium.gaussians()[i];
    const double t = glm::dot(g.b - rays.eye, w);
    const double r = medium.reach()[i];
    reach.add(t - r, t + r);
    const double half = std::min(core_reach(1.0 / g.a, g.c), r);
    core.add(t - half, t + half);
  }
  reach.clip(longest);
  core.clip(longest);
  const double b0 = medium.homogeneous_density();
  RayRange whole = reach;
  if (b0 > 0.0) {
    whole.begin = 0.0;
    whole.end = std::min(longest, std::max(reach.empty() ? 0.0 : reach.end, fog_end / b0));
  }
  if (whole.empty()) return;
  boundaries.push_back(whole.begin);
  boundaries.push_back(whole.end);
  if (!reach.empty()) {
    if (!core.empty()) {
      SliceDemand demand(core, 4 * slices);
      for (const std::uint32_t i : gaussians) {
        const GaussianTerm<double>& g = medium.gaussians()[i];
        const glm::dvec3 q = g.b - rays.eye;
        const double t = glm::dot(q, w);
        const double half = core_reach(1.0 / g.a, g.c);
        if (t + half < core.begin || t - half > core.end) continue;
        const double h = g.a * std::max(glm::length(q - t * w) - spread * std::max(t, 0.0), 0.0);
        demand.add(t, 1.0 / g.a, g.c * std::exp(-h * h));
      }
      demand.cut(slices - 2, boundaries);
    }
    boundaries.push_back(reach.begin);
    boundaries.push_back(reach.end);
  }
  const RayRange& lit = b0 > 0.0 ? whole : core;
  for (const SlicedLight& light : lights) {
    // A light in or near the medium; far ones are smooth along the ray.
    const glm::dvec3 q = light.position - rays.eye;
    const double ts = glm::dot(q, w);
    const double h = glm::length(q - ts * w);
    const double gap = std::max({lit.begin - ts, ts - lit.end, 0.0});
    if (lit.empty() || std::hypot(gap, h) > 0.5 * (lit.end - lit.begin)) continue;
    const int count =
        std::max(slices / static_cast<int>(std::min<std::size_t>(lights.size(), 4)), 4);
    add_equi_angular(light, rays.eye, w, lit, count, boundaries);
  }
  if (b0 > 0.0) {
    // Slices of equal loss in the fog.
    const double opaque = -std::expm1(-b0 * whole.end);
    for (int k = 1; k < slices; ++k) {
      boundaries.push_back(-std::log1p(-opaque * k / slices) / b0);
    }
  }
  std::sort(boundaries.begin(), boundaries.end());
  // Float tells no more apart.
  const double least = 1e-9 * (whole.end - whole.begin);
  boundaries.erase(
      std::unique(boundaries.begin(), boundaries.end(),
                  [least](double a, double b) { return b - a < std::max(least, 1e-6 * b); }),
      boundaries.end());
}

}  // namespace brume
