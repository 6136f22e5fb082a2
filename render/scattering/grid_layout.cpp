#include "render/scattering/grid_layout.h"

#include <algorithm>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <optional>
#include <utility>

#include "render/scattering/medium_bounds.h"

namespace brume {
namespace {

Box around(const Box& a, const Box& b) {
  return {glm::min(a.low, b.low), glm::max(a.high, b.high)};
}

// The part of a box within limits, and all that `kept` has of it.
Box within(const Box& box, const Box& limits, const Box& kept) {
  return {glm::max(box.low, glm::min(kept.low, limits.low)),
          glm::min(box.high, glm::max(kept.high, limits.high))};
}

double smallest_side(const Box& box) {
  const glm::dvec3 sides = box.high - box.low;
  return std::min({sides.x, sides.y, sides.z});
}

// The boxes that levels begin with, fine first: the smaller one of that of the Gaussians and that
// of the fog before one of both, where this saves much.
std::vector<Box> first_boxes(const MediumBounds& medium, const Box& fog) {
  constexpr double worth = 0.5;  // of the volume of both
  const bool has_fog = volume(fog) > 0.0;
  if (medium.empty()) return has_fog ? std::vector{fog} : std::vector<Box>();
  const Box gaussians{medium.low, medium.high};
  if (!has_fog) return {gaussians};
  const Box both = around(gaussians, fog);
  const Box& smaller = volume(fog) < volume(gaussians) ? fog : gaussians;
  if (volume(smaller) > worth * volume(both)) return {both};
  return {smaller, both};
}

// Levels as they are added.
class Levels {
 public:
  Levels(const SourceGrid::Content& content, bool has_gaussians)
      : content_(content), has_gaussians_(has_gaussians) {
    if (content.fog_density > 0.0 && !content.fog_ball.is_endless()) {
      const FogBall& ball = content.fog_ball;
      fog_end_ = {ball.center - ball.radius, ball.center + ball.radius};
    }
  }

  void add(const Box& box, double min_spacing, int nodes) {
    static const AxisPlanes none;
    if (layouts_.empty()) first_ = box;
    layouts_.push_back(lay_out(box.low, box.high, min_spacing, nodes,
                               content_.surfaces ? content_.surfaces->planes() : none));
    last_ = box;
  }
  // The box of a coarser level around the last one.
  [[nodiscard]] Box next() const {
    constexpr double not_much_more = 3.0;  // volumes
    const double beyond = glm::length(last_.high - last_.low);
    Box box{last_.low - beyond, last_.high + beyond};
    if (content_.surfaces) {
      const Box& surfaces = content_.surfaces->bounds();
      if (content_.lit.is_closed || !contains(last_, surfaces)) {
        box = within(box, content_.lit.open, last_);
      }
      const Box room = around(last_, surfaces);
      if (content_.lit.is_closed && volume(room) < not_much_more * volume(box)) return room;
    }
    if (!has_gaussians_ && fog_end_) {
      Box end = *fog_end_;  // a ball may end before what light falls on does
      if (content_.surfaces) end = around(end, content_.surfaces->bounds());
      if (content_.receivers) end = around(end, content_.receivers->box);
      box = within(box, end, last_);
    } else if (content_.fog_density > 0.0 && !fog_end_) {
      // Farther out the nodes would be mean free paths apart.
      const double farthest = 2.0 * fog_reach();
      Box limits{first_.low - farthest, first_.high + farthest};
      if (content_.surfaces) limits = around(limits, content_.surfaces->bounds());
      box = within(box, limits, last_);
    }
    return box;
  }
  [[nodiscard]] bool hold_all() const { return hold_fog() && hold_surfaces(); }
  [[nodiscard]] std::size_t size() const { return layouts_.size(); }
  [[nodiscard]] double spacing() const {
    return static_cast<double>(layouts_.back().nodes.spacing);
  }
  [[nodiscard]] std::vector<NodeLayout> take() { return std::move(layouts_); }

 private:
  [[nodiscard]] bool hold_fog() const {
    if (!(content_.fog_density > 0.0)) return true;
    if (content_.surfaces && content_.lit.is_closed)
      return contains(last_, content_.surfaces->bounds());
    // A sky lights all of a ball of fog from beyond it; endless fog scatters what is near.
    if (fog_end_) return contains(last_, *fog_end_);
    return size() > 1 && 0.5 * smallest_side(last_) >= fog_reach();
  }
  [[nodiscard]] double fog_reach() const {
    // Light comes back from beyond the levels as it diffuses, which it does far from lights.
    return scattering_reach(content_.fog_density, content_.fog_ball);
  }
  // Surfaces beyond all levels are lit as those at the border are, which is too much of what
  // Gaussians emit.
  [[nodiscard]] bool hold_surfaces() const {
    const bool has_emission = content_.emission && !content_.emission->lights().empty();
    return !content_.surfaces || (has_gaussians_ && !has_emission) ||
           contains(last_, content_.surfaces->bounds());
  }

  const SourceGrid::Content& content_;
  bool has_gaussians_;
  std::optional<Box> fog_end_;
  std::vector<NodeLayout> layouts_;
  Box first_, last_;
};

}  // namespace

GridLayout lay_out_levels(std::span<const GaussianTerm<double>> gaussians,
                          const SourceGrid::Content& content, const SourceGridSize& size) {
  const MediumBounds medium = medium_bounds(gaussians, content.emission);
  const std::vector<Box> boxes = first_boxes(medium, content.lit.fog);
  if (boxes.empty()) return {{medium.low, medium.high}, {NodeLayout()}};
  const Box& core = boxes.front();
  const bool is_around_gaussians = core == Box{medium.low, medium.high};
  Levels levels(content, !medium.empty());
  levels.add(core, is_around_gaussians ? 0.12 * medium.min_radius : 0.0, size.nodes);
  const auto max_nodes = [&] { return size.nodes / (levels.size() == 1 ? 2 : 4); };
  if (boxes.size() > 1) levels.add(boxes[1], 2.0 * levels.spacing(), max_nodes());
  const bool goes_beyond = (content.receivers && !contains(core, content.receivers->box)) ||
                           (content.surfaces && !contains(core, content.surfaces->bounds()));
  while (levels.size() < SourceGrid::max_levels &&
         (!levels.hold_all() || (levels.size() == 1 && goes_beyond))) {
    levels.add(levels.next(), 2.0 * levels.spacing(), max_nodes());
  }
  return {core, levels.take()};
}

}  // namespace brume
