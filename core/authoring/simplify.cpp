#include "core/authoring/simplify.h"

#include <tbb/parallel_invoke.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>
#include <numbers>
#include <numeric>

#include "core/authoring/gaussian_moments.h"
#include "core/math/special_functions.h"

namespace brume {
namespace {

// The moments of balls that stay balls: a faster GaussianMoments.
struct Ball {
  glm::dvec3 center{0.0};
  double radius = 1.0;
  double mass = 0.0;  // [u^2]

  explicit Ball(const Gaussian& g)
      : center(g.center),
        radius(g.radius),
        mass(std::pow(std::numbers::pi, 1.5) * g.density * g.radius * g.radius * g.radius) {}
  // The one of the mass, mean and variance of two.
  Ball(const Ball& a, const Ball& b) : mass(a.mass + b.mass) {
    const double share = mass > 0.0 ? b.mass / mass : 0.5;
    const glm::dvec3 apart = b.center - a.center;
    center = a.center + share * apart;
    // Variances per axis are half the squared radii.
    radius = std::sqrt(glm::mix(a.radius * a.radius, b.radius * b.radius, share) +
                       2.0 / 3.0 * share * (1.0 - share) * glm::dot(apart, apart));
  }
  void apply_to(Gaussian& gaussian) const {
    gaussian.center = center;
    gaussian.radius = radius;
    gaussian.density = mass / (std::pow(std::numbers::pi, 1.5) * radius * radius * radius);
  }
};

// The product of two Gaussians' optical depths, integrated over parallel lines and averaged over
// their direction [u^2].
double overlap(const Ball& a, const Ball& b) {
  const double square = a.radius * a.radius + b.radius * b.radius;
  const glm::dvec3 apart = b.center - a.center;
  const double k = std::sqrt(glm::dot(apart, apart) / square);
  const double mean = k < 1e-3 ? 1.0 - 2.0 / 3.0 * k * k : dawson(k) / k;
  return a.mass * b.mass / (std::numbers::pi * square) * mean;
}

// The squared error of optical depth when `one` stands for a and b, integrated as above.
double squared_error(const Ball& a, const Ball& b, const Ball& one) {
  const double sum = overlap(a, a) + overlap(b, b) + overlap(one, one) +
                     2.0 * (overlap(a, b) - overlap(a, one) - overlap(b, one));
  return std::max(sum, 0.0);
}

// One ball that stands for two.
Ball stand_in(const Ball& a, const Ball& b, const SimplifyLimits&) {
  return {a, b};
}
GaussianMoments stand_in(const GaussianMoments& a, const GaussianMoments& b,
                         const SimplifyLimits& limits) {
  GaussianMoments one(a, b);
  if (!limits.ellipsoids) one.make_round();
  return one;
}

// `Moments`: Balls or GaussianMoments.
template <class Moments>
class Simplification {
 public:
  Simplification(const Medium& medium, const SimplifyLimits& limits, const AxisDepths& depths,
                 const std::stop_token& stop, const std::function<void(double)>& progress)
      : medium_(medium),
        limits_(limits),
        allowed_(limits.max_error * limits.max_error),
        stop_(stop),
        progress_(progress),
        depths_(depths),
        order_(medium.size()) {
    std::iota(order_.begin(), order_.end(), 0u);
  }

  double estimated_share() {
    if (medium_.empty()) return 1.0;
    std::size_t sampled = 0;
    std::size_t left = 0;
    // Four boxes in different places of the tree; a bit for each way.
    for (const unsigned ways : {0x0u, 0x55555555u, 0xaaaaaaaau, 0xffffffffu}) {
      std::span<std::uint32_t> box = order_;
      for (unsigned level = 0; box.size() > sample_size; ++level) {
        const std::size_t half = box.size() / 2;
        split(box, half);
        box = (ways >> level & 1) == 0 ? box.first(half) : box.subspan(half);
      }
      sampled += box.size();
      left += merged(box).size();
    }
    return static_cast<double>(left) / static_cast<double>(sampled);
  }

  std::optional<Simplified> run() {
    Simplified result;
    if (medium_.empty()) return result;
    const std::vector<Part> parts = merged(order_);
    if (stop_.stop_requested()) return std::nullopt;
    double squared_errors = 0.0;
    double squares = 0.0;
    for (const Part& part : parts) {
      if (part.is_merged()) {
        Gaussian& g = result.merged.emplace_back(medium_.gaussian(part.members[0]));
        if (limits_.across_groups) g.group = 0;
        part.moments.apply_to(g);
        result.members.insert(result.members.end(), part.members.begin(), part.members.end());
        result.member_ends.push_back(static_cast<std::uint32_t>(result.members.size()));
      } else {
        result.kept.push_back(part.members[0]);
      }
      squared_errors += part.squared_error;
      squares += part.moments.mass * seen_depth(part.moments);
    }
    std::ranges::sort(result.kept);
    if (squares > 0.0) result.error = std::sqrt(squared_errors / squares);
    return result;
  }

 private:
  // Below it, a tree's halves are not worth two tasks.
  static constexpr std::size_t parallel_size = 4096;
  static constexpr std::size_t sample_size = 512;

  struct Part {
    Moments moments;
    double squared_error = 0.0;                // of what it stands for:
    std::span<const std::uint32_t> members{};  // indices

    [[nodiscard]] bool is_merged() const { return members.size() > 1; }
  };

  // Light sees the first unit of optical depth.
  [[nodiscard]] double seen_depth(const Moments& moments) const {
    return std::min(depths_.least(moments.center), 1.0);
  }

  [[nodiscard]] bool may_merge(const Part& a, const Part& b) const {
    const std::uint32_t first = a.members[0];
    const std::uint32_t second = b.members[0];
    if (!limits_.across_groups && medium_.group(first) != medium_.group(second)) return false;
    return medium_.optics(first) == medium_.optics(second);
  }

  // The parts of a box of Gaussians, halved along its longest side.
  std::vector<Part> merged(std::span<std::uint32_t> order) {
    if (order.size() == 1) return {{Moments(medium_.gaussian(order[0])), 0.0, order}};
    if (stop_.stop_requested()) return {};
    const std::size_t half = order.size() / 2;
    split(order, half);
    std::vector<Part> parts;
    std::vector<Part> others;
    const auto first = [&] { parts = merged(order.first(half)); };
    const auto second = [&] { others = merged(order.subspan(half)); };
    if (order.size() < parallel_size) {
      first();
      second();
    } else {
      tbb::parallel_invoke(first, second);
    }
    if (parts.size() == 1 && others.size() == 1 && may_merge(parts[0], others[0])) {
      const Part& a = parts[0];
      const Part& b = others[0];
      const Moments one = stand_in(a.moments, b.moments, limits_);
      // Errors of different sizes do not add up in phase.
      const double error =
          squared_error(a.moments, b.moments, one) + a.squared_error + b.squared_error;
      if (error <= allowed_ * one.mass * seen_depth(one)) return {{one, error, order}};
    }
    parts.insert(parts.end(), others.begin(), others.end());
    if (progress_ && order.size() >= parallel_size / 2 && order.size() < parallel_size) {
      done_ += order.size();
      progress_(static_cast<double>(done_) / static_cast<double>(medium_.size()));
    }
    return parts;
  }

  void split(std::span<std::uint32_t> order, std::size_t half) const {
    glm::dvec3 low(std::numeric_limits<double>::infinity());
    glm::dvec3 high(-std::numeric_limits<double>::infinity());
    const std::span<const glm::dvec3> centers = medium_.centers();
    for (const std::uint32_t i : order) {
      low = glm::min(low, centers[i]);
      high = glm::max(high, centers[i]);
    }
    const glm::dvec3 size = high - low;
    const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    std::nth_element(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(half), order.end(),
                     [&](std::uint32_t a, std::uint32_t b) {
                       const double x = centers[a][axis];
                       const double y = centers[b][axis];
                       return x != y ? x < y : a < b;
                     });
  }

  const Medium& medium_;
  const SimplifyLimits& limits_;
  double allowed_;
  const std::stop_token& stop_;
  const std::function<void(double)>& progress_;
  const AxisDepths& depths_;
  std::vector<std::uint32_t> order_;
  std::atomic<std::size_t> done_ = 0;
};

bool has_only_balls(const Medium& medium, const SimplifyLimits& limits) {
  return medium.shapes().empty() && !limits.ellipsoids;
}

}  // namespace

std::vector<Gaussian> Simplified::of(const Medium& medium) const {
  std::vector<Gaussian> all;
  all.reserve(kept.size() + merged.size());
  for (const std::uint32_t i : kept) all.push_back(medium.gaussian(i));
  all.insert(all.end(), merged.begin(), merged.end());
  return all;
}

std::optional<Simplified> simplify(const Medium& medium, const SimplifyLimits& limits,
                                   const std::stop_token& stop,
                                   const std::function<void(double)>& progress) {
  return simplify(medium, limits, AxisDepths(medium), stop, progress);
}

std::optional<Simplified> simplify(const Medium& medium, const SimplifyLimits& limits,
                                   const AxisDepths& depths, const std::stop_token& stop,
                                   const std::function<void(double)>& progress) {
  if (!has_only_balls(medium, limits)) {
    return Simplification<GaussianMoments>(medium, limits, depths, stop, progress).run();
  }
  return Simplification<Ball>(medium, limits, depths, stop, progress).run();
}

double estimated_share(const Medium& medium, const SimplifyLimits& limits,
                       const AxisDepths& depths) {
  const std::stop_token stop;
  const std::function<void(double)> progress;
  if (!has_only_balls(medium, limits)) {
    return Simplification<GaussianMoments>(medium, limits, depths, stop, progress)
        .estimated_share();
  }
  return Simplification<Ball>(medium, limits, depths, stop, progress).estimated_share();
}

namespace {

constexpr int cells_across = 128;

std::size_t index(int column, int row) {
  return static_cast<std::size_t>(row) * cells_across + static_cast<std::size_t>(column);
}

}  // namespace

AxisDepths::AxisDepths(const Medium& medium) {
  low_ = glm::dvec3(std::numeric_limits<double>::infinity());
  glm::dvec3 high(-std::numeric_limits<double>::infinity());
  for (std::size_t i = 0; i < medium.size(); ++i) {
    low_ = glm::min(low_, medium.centers()[i] - medium.radii()[i]);
    high = glm::max(high, medium.centers()[i] + medium.radii()[i]);
  }
  size_ = glm::max(high - low_, 1e-300) / double{cells_across};
  for (auto& image : depths_) image.assign(std::size_t{cells_across} * cells_across, 0.0);
  for (std::size_t i = 0; i < medium.size(); ++i) add(medium.gaussian(i));
}

double AxisDepths::least(const glm::dvec3& x) const {
  const glm::ivec3 cell = cell_of(x);
  double depth = std::numeric_limits<double>::infinity();
  for (int axis = 0; axis < 3; ++axis) {
    depth = std::min(
        depth,
        depths_[static_cast<std::size_t>(axis)][index(cell[(axis + 1) % 3], cell[(axis + 2) % 3])]);
  }
  return depth;
}

glm::ivec3 AxisDepths::cell_of(const glm::dvec3& x) const {
  return glm::ivec3(glm::clamp((x - low_) / size_, 0.0, cells_across - 1.0));
}

// Spread evenly over the square of its size that has its greatest depth's share.
void AxisDepths::add(const Gaussian& gaussian, double times) {
  const double mass =
      times * gaussian.density * std::pow(std::sqrt(std::numbers::pi) * gaussian.mean_radius(), 3);
  glm::dvec3 reach(1.0);
  if (!gaussian.is_ball()) reach = Ellipsoid<double>(gaussian.shape).reach();
  const glm::dvec3 half = 0.5 * std::sqrt(std::numbers::pi) * gaussian.radius * reach;
  const glm::ivec3 first = cell_of(gaussian.center - half);
  const glm::ivec3 last = cell_of(gaussian.center + half);
  for (int axis = 0; axis < 3; ++axis) {
    const int u = (axis + 1) % 3;
    const int v = (axis + 2) % 3;
    const double width = (last[u] - first[u] + 1) * size_[u];
    const double height = (last[v] - first[v] + 1) * size_[v];
    std::vector<double>& image = depths_[static_cast<std::size_t>(axis)];
    for (int row = first[v]; row <= last[v]; ++row) {
      for (int column = first[u]; column <= last[u]; ++column) {
        double& depth = image[index(column, row)];
        depth = std::max(depth + mass / (width * height), 0.0);  // rounding may leave less
      }
    }
  }
}

}  // namespace brume
