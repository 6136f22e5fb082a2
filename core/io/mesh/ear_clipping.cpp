#include "core/io/mesh/ear_clipping.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <numeric>

namespace brume {
namespace {

using Index = std::uint32_t;

struct Box {
  glm::dvec2 low, high;
};

Box box_around(std::span<const glm::dvec2> points) {
  Box box{points[0], points[0]};
  for (const glm::dvec2& p : points) {
    box.low = glm::min(box.low, p);
    box.high = glm::max(box.high, p);
  }
  return box;
}

// Doubled areas from which on triangles of a polygon are more than a line and its roundings.
double smallest_area(std::span<const glm::dvec2> points) {
  const Box box = box_around(points);
  const glm::dvec2 size = box.high - box.low;
  return 1e-14 * std::max(size.x * size.x, size.y * size.y);
}

// Points in the cells of a grid of about as many cells, found by box.
class PointGrid {
 public:
  PointGrid(std::span<const glm::dvec2> points, const std::vector<Index>& indices)
      : count_(static_cast<std::size_t>(std::sqrt(static_cast<double>(indices.size()))) + 1) {
    const Box box = box_around(points);
    low_ = box.low;
    for (int axis = 0; axis < 2; ++axis) {
      const double size = box.high[axis] - box.low[axis];
      per_unit_[axis] = size > 0.0 ? static_cast<double>(count_) / size : 0.0;
    }
    starts_.resize(count_ * count_ + 1, 0);
    for (const Index i : indices) ++starts_[cell(points[i]) + 1];
    std::partial_sum(starts_.begin(), starts_.end(), starts_.begin());
    std::vector<std::size_t> next(starts_.begin(), starts_.end() - 1);
    indices_.resize(indices.size());
    for (const Index i : indices) indices_[next[cell(points[i])]++] = i;
  }

  // Whether `holds` is true of a point in the cells that the box meets; counts `tests` down.
  bool any(const glm::dvec2& low, const glm::dvec2& high, std::size_t& tests, auto&& holds) const {
    const std::size_t first = column(low, 0);
    const std::size_t last = column(high, 0);
    for (std::size_t row = column(low, 1); row <= column(high, 1); ++row) {
      const std::size_t end = starts_[row * count_ + last + 1];
      for (std::size_t k = starts_[row * count_ + first]; k < end; ++k) {
        tests -= std::min<std::size_t>(tests, 1);
        if (holds(indices_[k])) return true;
      }
    }
    return false;
  }

 private:
  [[nodiscard]] std::size_t column(const glm::dvec2& p, int axis) const {
    const double place = (p[axis] - low_[axis]) * per_unit_[axis];
    return static_cast<std::size_t>(std::clamp(place, 0.0, static_cast<double>(count_ - 1)));
  }
  [[nodiscard]] std::size_t cell(const glm::dvec2& p) const {
    return column(p, 1) * count_ + column(p, 0);
  }

  glm::dvec2 low_{0.0};
  glm::dvec2 per_unit_{0.0};
  std::size_t count_;                // of rows, and of columns
  std::vector<std::size_t> starts_;  // of each cell within indices_
  std::vector<Index> indices_;
};

// The corners that are left, in a ring.
class Ring {
 public:
  explicit Ring(std::size_t size) : previous_(size), next_(size), size_(size) {
    for (std::size_t i = 0; i < size; ++i) {
      previous_[i] = static_cast<Index>((i + size - 1) % size);
      next_[i] = static_cast<Index>((i + 1) % size);
    }
  }
  [[nodiscard]] std::size_t size() const { return size_; }
  [[nodiscard]] Index previous(Index i) const { return previous_[i]; }
  [[nodiscard]] Index next(Index i) const { return next_[i]; }
  [[nodiscard]] bool contains(Index i) const { return next_[previous_[i]] == i; }
  void remove(Index i) {
    next_[previous_[i]] = next_[i];
    previous_[next_[i]] = previous_[i];
    --size_;
  }

 private:
  std::vector<Index> previous_;
  std::vector<Index> next_;
  std::size_t size_;
};

// The ears that may be cut: the later ones where there are no earlier ones, as in polygons that
// touch or cross themselves.
enum class Cut { ears, touching_ears, lines, convex_corners, all };

class EarClipper {
 public:
  EarClipper(std::span<const glm::dvec2> corners, std::size_t& tests)
      : corners_(corners),
        tests_(tests),
        ring_(corners.size()),
        min_area_(smallest_area(corners)),
        blockers_(corners, blockers()) {}

  std::vector<std::array<Index, 3>> clip() {
    for (Index i = 0; i < corners_.size(); ++i) {
      if (ring_.contains(i)) trim(i);
    }
    std::vector<Index> open = remaining();
    std::vector<std::size_t> looked_at(corners_.size(), 0);  // in which round last
    bool has_cut = false;                                    // since all were open
    Cut allowed = Cut::ears;
    for (std::size_t round = 1; ring_.size() > 3 && tests_ > 0; ++round) {
      std::vector<Index> next;
      for (const Index i : open) {
        // Neighbours of what was cut wait for the next round: triangles stay small.
        if (looked_at[i] == round || !ring_.contains(i) || ring_.size() == 3) continue;
        tests_ -= std::min<std::size_t>(tests_, 1);
        if (!may_cut(i, allowed)) continue;
        for (const Index neighbour : {ring_.previous(i), ring_.next(i)}) {
          if (looked_at[neighbour] != round) next.push_back(neighbour);
          looked_at[neighbour] = round;
        }
        cut(i);
        has_cut = true;
        if (allowed != Cut::ears) break;  // others may be ears now
      }
      open = std::move(next);
      if (!open.empty()) {
        allowed = Cut::ears;
        continue;
      }
      allowed = has_cut ? Cut::ears : static_cast<Cut>(static_cast<int>(allowed) + 1);
      has_cut = false;
      open = remaining();
    }
    while (ring_.size() > 2) cut(ring_.next(last_));
    return std::move(triangles_);
  }

 private:
  [[nodiscard]] double area(Index i) const {
    return doubled_area(corners_[ring_.previous(i)], corners_[i], corners_[ring_.next(i)]);
  }

  // Whatever lies within an ear has a corner there that is not convex.
  [[nodiscard]] std::vector<Index> blockers() const {
    std::vector<Index> result;
    for (Index i = 0; i < corners_.size(); ++i) {
      if (!(area(i) > min_area_)) result.push_back(i);
    }
    return result;
  }

  [[nodiscard]] std::vector<Index> remaining() const {
    std::vector<Index> all;
    Index i = last_;
    do {
      all.push_back(i);
      i = ring_.next(i);
    } while (i != last_);
    return all;
  }

  bool may_cut(Index i, Cut allowed) {
    const double corner_area = area(i);
    const bool is_convex = corner_area > min_area_;
    switch (allowed) {
      case Cut::ears:
        return is_convex && !is_blocked(i, 0.0);
      case Cut::touching_ears:
        return is_convex && !is_blocked(i, min_area_);
      case Cut::lines:
        return std::abs(corner_area) <= min_area_;
      case Cut::convex_corners:
        return is_convex;
      default:
        return true;
    }
  }

  // Whether the outline turns back there, or stays: around no area.
  [[nodiscard]] bool is_spike(Index i) const {
    const glm::dvec2& b = corners_[i];
    return std::abs(area(i)) <= min_area_ &&
           glm::dot(b - corners_[ring_.previous(i)], corners_[ring_.next(i)] - b) <= 0.0;
  }

  // Removes a spike, and those that come of that.
  void trim(Index i) {
    while (ring_.size() > 3 && is_spike(i)) {
      last_ = ring_.previous(i);
      const Index next = ring_.next(i);
      ring_.remove(i);
      i = is_spike(last_) ? last_ : next;
    }
  }

  // Whether the outline enters the triangle at `i` elsewhere: a corner lies in it by more than
  // `depth` (doubled areas) or on its edges for 0, or the outline passes its tip into it.
  bool is_blocked(Index i, double depth) {
    const glm::dvec2& a = corners_[ring_.previous(i)];
    const glm::dvec2& b = corners_[i];
    const glm::dvec2& c = corners_[ring_.next(i)];
    const auto is_beyond = [&](Index k) {
      const glm::dvec2& p = corners_[k];
      return doubled_area(a, b, p) > 0.0 && doubled_area(b, c, p) > 0.0;
    };
    const glm::dvec2 low = glm::min(glm::min(a, b), c);
    const glm::dvec2 high = glm::max(glm::max(a, b), c);
    return blockers_.any(low, high, tests_, [&](Index k) {
      const glm::dvec2& p = corners_[k];
      if (!ring_.contains(k) || k == i || p == a || p == c) return false;
      if (p == b) return is_beyond(ring_.previous(k)) || is_beyond(ring_.next(k));
      return doubled_area(a, b, p) >= depth && doubled_area(b, c, p) >= depth &&
             doubled_area(c, a, p) >= depth;
    });
  }

  void cut(Index i) {
    last_ = ring_.previous(i);
    const Index next = ring_.next(i);
    triangles_.push_back({last_, i, next});
    ring_.remove(i);
    trim(next);
    if (ring_.contains(last_)) trim(last_);
  }

  std::span<const glm::dvec2> corners_;
  std::size_t& tests_;
  Ring ring_;
  double min_area_;  // doubled; below are lines
  PointGrid blockers_;
  Index last_ = 0;  // a corner that is left
  std::vector<std::array<Index, 3>> triangles_;
};

}  // namespace

double doubled_area(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

std::vector<std::array<std::uint32_t, 3>> clip_ears(std::span<const glm::dvec2> corners,
                                                    std::size_t& tests) {
  return EarClipper(corners, tests).clip();
}

}  // namespace brume
