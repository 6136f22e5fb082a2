#include "core/io/import/node_motion.h"

#include <algorithm>
#include <glm/common.hpp>
#include <glm/ext/matrix_transform.hpp>
#include <ranges>
#include <unordered_map>
#include <utility>

#include "brume/error.h"
#include "core/number_domain.h"

namespace brume {
namespace {

glm::dvec3 mixed(const glm::dvec3& a, const glm::dvec3& b, double share) {
  return glm::mix(a, b, share);
}
glm::dquat mixed(const glm::dquat& a, const glm::dquat& b, double share) {
  return glm::slerp(a, b, share);
}

MorphWeights mixed(const MorphWeights& a, const MorphWeights& b, double share) {
  return (1.0 - share) * a + share * b;
}

glm::dvec3 valid(const glm::dvec3& v) {
  return v;
}
glm::dquat valid(const glm::dquat& q) {
  const double length = glm::length(q);
  return length > 0.0 ? q / length : glm::dquat(1.0, 0.0, 0.0, 0.0);
}

MorphWeights valid(const MorphWeights& weights) {
  return weights;
}

template <class T>
T evaluated(const Track<T>& track, double time) {
  const bool is_cubic = track.interpolation == TrackInterpolation::cubic;
  const auto value = [&](std::size_t i) { return track.values[is_cubic ? 3 * i + 1 : i]; };
  const auto next = std::ranges::upper_bound(track.times, time);
  if (next == track.times.begin()) return valid(value(0));
  const auto i = static_cast<std::size_t>(next - track.times.begin()) - 1;
  if (next == track.times.end() || track.interpolation == TrackInterpolation::step) {
    return valid(value(i));
  }
  const double span = track.times[i + 1] - track.times[i];
  const double t = (time - track.times[i]) / span;
  if (!is_cubic) return mixed(valid(value(i)), valid(value(i + 1)), t);
  const double t2 = t * t;
  const double t3 = t2 * t;
  return valid((2.0 * t3 - 3.0 * t2 + 1.0) * value(i) +
               span * (t3 - 2.0 * t2 + t) * track.values[3 * i + 2] +
               (3.0 * t2 - 2.0 * t3) * value(i + 1) + span * (t3 - t2) * track.values[3 * i + 3]);
}

void add_times(const auto& track, std::vector<double>& times) {
  if (track) times.insert(times.end(), track->times.begin(), track->times.end());
}

}  // namespace

MorphWeights value_at(const Track<MorphWeights>& track, double time) {
  return evaluated(track, time);
}

glm::dmat4 NodeTransform::matrix() const {
  return glm::translate(glm::dmat4(1.0), translation) * glm::mat4_cast(rotation) *
         glm::scale(glm::dmat4(1.0), scale);
}

NodeMotion::NodeMotion(const std::filesystem::path& file, std::vector<MovingNode> nodes)
    : file_(file), nodes_(std::move(nodes)) {
  for (const MovingNode& node : nodes_) {
    moves_.push_back(node.tracks.has_any() || (node.parent && moves_[*node.parent]));
  }
}

glm::dmat4 NodeMotion::to_parent(std::size_t node, double time) const {
  const auto& [parent, at_rest, transform, tracks] = nodes_[node];
  if (!tracks.has_any()) return at_rest;
  NodeTransform moved = transform;
  if (tracks.translation) moved.translation = evaluated(*tracks.translation, time);
  if (tracks.rotation) moved.rotation = evaluated(*tracks.rotation, time);
  if (tracks.scale) moved.scale = evaluated(*tracks.scale, time);
  return moved.matrix();
}

std::vector<glm::dmat4> NodeMotion::to_world(std::span<const std::size_t> nodes,
                                             double time) const {
  std::unordered_map<std::size_t, glm::dmat4> known;
  std::vector<std::size_t> chain;  // up to a known one
  std::vector<glm::dmat4> transforms;
  for (const std::size_t node : nodes) {
    chain.clear();
    std::optional<std::size_t> i = node;
    for (; i && !known.contains(*i); i = nodes_[*i].parent) chain.push_back(*i);
    glm::dmat4 transform = i ? known.at(*i) : glm::dmat4(1.0);
    for (const std::size_t link : std::views::reverse(chain)) {
      transform = transform * to_parent(link, time);
      known.emplace(link, transform);
    }
    count(1 + chain.size());
    transforms.push_back(transform);
  }
  return transforms;
}

glm::dmat4 NodeMotion::to_world(std::size_t node, double time) const {
  return to_world(std::span(&node, 1), time).front();
}

void NodeMotion::check_coordinates(const glm::dvec3& point) const {
  for (int axis = 0; axis < 3; ++axis) {
    if (domain::coordinate.contains(point[axis])) continue;
    throw InputError(file_, "",
                     "the animation of a node: " + domain::coordinate.refusal(point[axis]));
  }
}

std::vector<double> NodeMotion::times(std::size_t node) const {
  std::vector<double> times;
  for (std::optional<std::size_t> i = node; i; i = nodes_[*i].parent) {
    const NodeTracks& tracks = nodes_[*i].tracks;
    add_times(tracks.translation, times);
    add_times(tracks.rotation, times);
    add_times(tracks.scale, times);
    count(1 + times.size());
  }
  std::ranges::sort(times);
  times.erase(std::ranges::unique(times).begin(), times.end());
  return times;
}

void NodeMotion::count(std::size_t steps) const {
  // A minute at most; files of other programs take less than a second.
  constexpr std::size_t max_steps = std::size_t{1} << 28;
  steps_ += steps;
  if (steps_ > max_steps) {
    throw InputError(file_, "", "its animations take too long: its nodes are too deep or too many");
  }
}

}  // namespace brume
