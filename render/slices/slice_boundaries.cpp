#include "render/slices/slice_boundaries.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "core/transport/light_path.h"
#include "render/geometry/ray_range.h"

namespace brume {
namespace {

// Where light falls off within a medium, slices of equal angle as seen from the light.
void add_equi_angular(const SlicedLight& light, const TileCone& rays, const RayRange& range,
                      int count, std::vector<double>& boundaries) {
  // A light almost on the ray would put all slices at one point: half a slice is fine enough, of
  // what is near the light if the medium is endless.
  const double near =
      light_distances * glm::length(light.position - (rays.eye + range.begin * rays.center));
  const double min_distance = light_slice_share * std::min(range.end - range.begin, near) / count;
  PointLightRay<double> path(light.position, rays.eye, rays.center,
                             std::max(light.h_min, min_distance));
  path.ts = rays.nearest_pass(light.position - rays.eye).t;
  const EquiAngular<double> angular(path, range.end);
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

// Distance from the center up to which a Gaussian of radius r and density c needs slices.
double core_radius(double r, double c) {
  return line_depth(c, r) < slice_opaque ? slice_demand::core_radii * r
                                         : cutoff_radius(r, c, slice_demand::tail_depth);
}

// Where a Gaussian among a tile's rays needs slices: where the nearest ray passes it. If the rays
// only hit its tail, the light determines where; then the center's projection serves as well, and
// is symmetric.
struct SliceNeed {
  double t, half;       // from t - half to t + half [u]
  double radius;        // of the Gaussian [u]
  double peak;          // its density where the nearest ray passes it [1/u]
  double weight = 1.0;  // Gaussians that it stands for
};

SliceNeed slice_need(const GaussianTerm<double>& g, double center, const TileCone::Pass& nearest) {
  const double h = g.a * nearest.h;
  const double share = std::exp(-h * h);
  const double radius = 1.0 / g.a;
  return {center + share * (nearest.t - center), core_radius(radius, g.c), radius, g.c * share};
}

// The need of an ellipsoid, by the axis of the cone. It is as wide along the rays as they pass it.
SliceNeed slice_need_of_ellipsoid(const GaussianTerm<double>& g, const TileCone& rays) {
  const LineProfile<double> line = line_profile(g, rays.eye, rays.center);
  const double nearer = (rays.spread * std::max(line.t0, 0.0) + rays.width) / min_radius_of(g);
  const double h = std::max(std::sqrt(line.e) - nearer, 0.0);
  const double radius = 1.0 / line.a;
  return {line.t0, core_radius(radius, g.c), radius, g.c * std::exp(-h * h)};
}

// Which of a tile's Gaussians demand slices. Of many, every so manieth does for those beside it,
// and each that stands out.
class DemandingGaussians {
 public:
  DemandingGaussians(const MediumIndex& medium, std::span<const std::uint32_t> gaussians)
      : step_(std::max<std::size_t>(gaussians.size() / slice_demand::max_gaussians, 1)) {
    if (step_ == 1) return;
    double sum = 0.0;
    for (std::size_t k = 0; k < gaussians.size(); k += step_) {
      sum += depth(medium.gaussians()[gaussians[k]]);
    }
    outstanding_ = slice_demand::outstanding * sum /
                   static_cast<double>((gaussians.size() + step_ - 1) / step_);
  }

  // Gaussians that the k-th, g, stands for; 0: others stand for it.
  [[nodiscard]] double weight(std::size_t k, const GaussianTerm<double>& g) const {
    if (step_ == 1 || depth(g) > outstanding_) return 1.0;
    return k % step_ == 0 ? static_cast<double>(step_) : 0.0;
  }

 private:
  // Proportional to that of a line through its center.
  static double depth(const GaussianTerm<double>& g) { return g.c / g.a; }

  std::size_t step_;
  double outstanding_ = 0.0;
};

// Demand for boundaries along a ray. The error of the midpoint rule is proportional to the second
// derivative of the integrand, so the optimal density of slices is its cube root (c / r^2 within a
// Gaussian, attenuated by the medium in front), plus a uniform part so that thin media are sampled.
class SliceDemand {
 public:
  SliceDemand(const RayRange& range, int bins)
      : begin_(range.begin),
        width_((range.end - range.begin) / bins),
        rate_(static_cast<std::size_t>(bins) + 1),
        curvature_(static_cast<std::size_t>(bins) + 1) {}

  // So many Gaussians of radius r whose density is `peak` where the ray passes them at t.
  void add(double t, double r, double peak, double weight) {
    using namespace slice_demand;
    add_box(t, box_radii * r, weight * box_share * peak, weight * peak / (r * r));
    if (line_depth(peak, r) < slice_opaque) return;
    const double last = cutoff_radius(r, peak, tail_depth) / r;
    for (double k = box_radii; k < last; k += tail_step) {
      const double center = k + 0.5 * tail_step;
      const double density = peak * std::exp(-center * center);
      add_box(t, (k + tail_step) * r, weight * density,
              weight * 4.0 * center * center * density / (r * r));
    }
  }

  // Appends the ends of the range and the boundaries between `count` slices of equal demand.
  void place_boundaries(int count, std::vector<double>& boundaries) const {
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
      demand[i] = std::cbrt(std::max(curvature, 0.0) /
                            (1.0 + std::clamp(depth, 0.0, slice_demand::max_front_depth)));
      // Past this depth only rays that miss the opaque core contribute; damp the demand.
      if (depth > slice_opaque) demand[i] *= slice_opaque / depth;
      depth += rate * width_;
      sum += demand[i];
    }
    const double uniform =
        sum > 0.0 ? slice_demand::uniform_share * sum / static_cast<double>(bins) : 1.0;
    sum += uniform * static_cast<double>(bins);
    boundaries.push_back(begin_);
    double cumulative = 0.0;
    int k = 1;
    for (std::size_t i = 0; i < bins && k < count; ++i) {
      const double bin_demand = demand[i] + uniform;
      for (double target = sum * k / count; k < count && target <= cumulative + bin_demand;
           target = sum * ++k / count) {
        boundaries.push_back(
            begin_ + width_ * (static_cast<double>(i) + (target - cumulative) / bin_demand));
      }
      cumulative += bin_demand;
    }
    boundaries.push_back(begin_ + width_ * static_cast<double>(bins));
  }

 private:
  void add_box(double t, double half, double rate, double curvature) {
    const auto bin = [this](double x) {
      const double max_bin = static_cast<double>(rate_.size() - 1);
      return static_cast<std::size_t>(std::clamp((x - begin_) / width_ + bin_room, 0.0, max_bin));
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

// Where rays of a tile meet fog, but for what is opaque in front of it, and the density for which
// slices of it are chosen [1/u].
struct FogDemand {
  RayRange range;
  double density = 0.0;
};

FogDemand fog_demand(const FogBall& fog, const TileCone& rays, double b0) {
  if (fog.is_endless()) return {{0.0, opaque_fog_depth / b0}, b0};
  const glm::dvec3 q = fog.center - rays.eye;
  const TileCone::Pass nearest = rays.nearest_pass(q);
  const double square = fog.radius * fog.radius - nearest.h * nearest.h;
  if (!(square > 0.0)) return {};
  const double half = std::sqrt(square);
  // A center behind the eye is passed by the axis.
  const double aside = nearest.t < 0.0 ? rays.spread * nearest.h : 0.0;
  const double first = std::max(nearest.t - half, 0.0);
  // The last of the rays to enter it.
  const double t = glm::dot(q, rays.center);
  const double h = glm::length(q - t * rays.center) + rays.spread * std::max(t, 0.0) + rays.width;
  const double last =
      std::max(t - std::sqrt(std::max(fog.radius * fog.radius - h * h, 0.0)), first);
  const double free_path = 1.0 / b0;
  return {{first, std::min(nearest.t + half + aside, last + opaque_fog_depth * free_path)},
          1.0 / (free_path + (last - first))};
}

}  // namespace

int slices_per_light(int slices, std::size_t lights) {
  const int count = std::max(slices / static_cast<int>(std::clamp<std::size_t>(lights, 1, 4)), 4);
  // The Gaussians have `slices` boundaries and four ends, the fog as many again.
  const int room = static_cast<int>(max_slice_boundaries) - 2 * slices - 4;
  return std::clamp(room / std::max(static_cast<int>(lights), 1), 1, count);
}

std::size_t max_boundaries(int slices, std::size_t lights, bool in_fog) {
  const auto count = static_cast<std::size_t>(slices);
  const auto per_light = static_cast<std::size_t>(slices_per_light(slices, lights));
  return 4 + count + lights * (per_light - 1) + (in_fog ? count : 0);
}

void choose_slices(const MediumIndex& medium, std::span<const std::uint32_t> gaussians,
                   std::span<const SlicedLight> lights, const TileCone& rays, int slices,
                   std::vector<double>& boundaries) {
  boundaries.clear();
  const glm::dvec3& w = rays.center;
  const double max_length = rays.max_length;

  // The Gaussians: slices over two radii or more to both sides, and one more for the tail at each
  // end.
  RayRange extent;
  RayRange core;
  thread_local std::vector<SliceNeed> needs;
  needs.clear();
  const DemandingGaussians demanding(medium, gaussians);
  for (std::size_t k = 0; k < gaussians.size(); ++k) {
    const std::uint32_t i = gaussians[k];
    const GaussianTerm<double>& g = medium.gaussians()[i];
    const glm::dvec3 q = g.b - rays.eye;
    const double r = medium.cutoff_radii()[i];
    const double center = glm::dot(q, w);
    const double weight = demanding.weight(k, g);
    if (g.ellipsoid) {
      // Its part on a ray lies as far along the axis, to the cosine between them.
      const double along = r * g.ellipsoid->reach(w);
      extent.add(center - along, (center + along) * std::hypot(1.0, rays.spread));
      if (weight == 0.0) continue;
      SliceNeed& need = needs.emplace_back(slice_need_of_ellipsoid(g, rays));
      need.weight = weight;
      const double half = std::min(need.half, along);
      core.add(need.t - half, need.t + half);
      continue;
    }
    if (weight == 0.0) {
      extent.add(center - r, glm::length(q) + r);
      continue;
    }
    const TileCone::Pass nearest = rays.nearest_pass(q);
    extent.add(center - r, nearest.t + r);
    SliceNeed& need = needs.emplace_back(slice_need(g, center, nearest));
    need.weight = weight;
    const double half = std::min(need.half, r);
    core.add(need.t - half, need.t + half);
  }
  extent.clip(max_length);
  core.clip(max_length);
  const double b0 = medium.homogeneous_density();
  RayRange full_range = extent.empty() ? RayRange() : extent;
  const FogDemand fog = b0 > 0.0 ? fog_demand(medium.fog(), rays, b0) : FogDemand();
  if (!fog.range.empty()) {
    full_range.add(fog.range.begin, fog.range.end);
    full_range.clip(max_length);
  }
  if (full_range.empty()) return;
  boundaries.push_back(full_range.begin);
  boundaries.push_back(full_range.end);
  if (!extent.empty()) {
    if (!core.empty()) {
      SliceDemand demand(core, slice_demand::bins_per_slice * slices);
      for (const SliceNeed& need : needs) {
        if (need.t + need.half < core.begin || need.t - need.half > core.end) continue;
        demand.add(need.t, need.radius, need.peak, need.weight);
      }
      demand.place_boundaries(slices - 2, boundaries);
    }
    boundaries.push_back(extent.begin);
    boundaries.push_back(extent.end);
  }
  const RayRange& lit = fog.range.empty() ? core : full_range;
  for (const SlicedLight& light : lights) {
    if (light.index % points_per_demand != 0) continue;
    // A light in or near the medium; far ones are smooth along the ray.
    const glm::dvec3 q = light.position - rays.eye;
    const double ts = glm::dot(q, w);
    const double h = glm::length(q - ts * w);
    const double distance_to_range = std::max({lit.begin - ts, ts - lit.end, 0.0});
    if (lit.empty() || std::hypot(distance_to_range, h) > near_light_share * (lit.end - lit.begin))
      continue;
    add_equi_angular(light, rays, lit, slices_per_light(slices, lights.size()), boundaries);
  }
  if (!fog.range.empty()) {
    // Slices of equal loss in the fog.
    const bool is_ball = !medium.fog().is_endless();  // which has ends of its own
    const int count = is_ball ? std::max(slices - 1, 1) : slices;
    const double begin = std::min(fog.range.begin, max_length);
    const double end = is_ball ? std::min(fog.range.end, max_length) : full_range.end;
    const double opaque = -std::expm1(-fog.density * (end - begin));
    for (int k = is_ball ? 0 : 1; k < count; ++k) {
      boundaries.push_back(begin - std::log1p(-opaque * k / count) / fog.density);
    }
    if (is_ball) boundaries.push_back(end);
  }
  std::sort(boundaries.begin(), boundaries.end());
  const double min_spacing = min_gap_of_range * (full_range.end - full_range.begin);
  boundaries.erase(std::unique(boundaries.begin(), boundaries.end(),
                               [min_spacing](double a, double b) {
                                 return b - a < std::max(min_spacing, min_gap_of_distance * b);
                               }),
                   boundaries.end());
}

}  // namespace brume
