#include "core/io/import/node_keys.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <glm/trigonometric.hpp>
#include <utility>

#include "core/io/import/node_transform.h"
#include "core/io/import/sampler.h"
#include "core/number_domain.h"

namespace brume {
namespace {

template <class Measure>
auto sampled(const NodeMotion& motion, std::size_t node, const auto& state_at,
             const Measure& measure) {
  return Sampler(state_at, measure, motion.file()).run(motion.times(node));
}

// A member of the samples as keys.
template <class State, class T>
Keys<T> keys_of(const std::vector<Sample<State>>& samples, T State::*member) {
  Keys<T> keys;
  for (const Sample<State>& sample : samples) {
    keys.push_back({sample.time, sample.state.*member,
                    sample.is_held ? Interpolation::constant : Interpolation::linear});
  }
  return keys;
}

template <class T>
bool is_constant(const Keys<T>& keys) {
  return std::ranges::all_of(keys,
                             [&](const Key<T>& key) { return key.value == keys.front().value; });
}

// The allowed error of points that move between these.
double max_offset(const std::vector<glm::dvec3>& points) {
  glm::dvec3 low = points.front();
  glm::dvec3 high = low;
  for (const glm::dvec3& point : points) {
    low = glm::min(low, point);
    high = glm::max(high, point);
  }
  constexpr double rounding = 1e-9;
  return max_share * glm::distance(low, high) +
         rounding * (1.0 + std::max(glm::length(low), glm::length(high)));
}

std::vector<glm::dvec3> origins(const NodeMotion& motion, std::size_t node) {
  std::vector<glm::dvec3> points;
  for (const double time : motion.times(node)) points.emplace_back(motion.to_world(node, time)[3]);
  return points;
}

struct PlacementMeasure {
  double offset;

  [[nodiscard]] static CopyPlacement mixed(const CopyPlacement& a, const CopyPlacement& b,
                                           double share) {
    return {glm::mix(a.translate, b.translate, share), glm::slerp(a.rotate, b.rotate, share),
            glm::mix(a.scale, b.scale, share)};
  }
  [[nodiscard]] double distance(const CopyPlacement& a, const CopyPlacement& b) const {
    const double cosine = std::min(std::abs(glm::dot(a.rotate, b.rotate)), 1.0);
    return std::max({glm::distance(a.translate, b.translate) / offset,
                     2.0 * std::acos(cosine) / max_angle,
                     std::abs(a.scale - b.scale) / (max_share * std::max(a.scale, b.scale))});
  }
};

// The axes of a matrix, made a rotation; zero where it has none.
glm::dmat3 turn_of(const glm::dmat3& m) {
  constexpr double tiny = 1e-9;
  const double size = std::max({glm::length(m[0]), glm::length(m[1]), glm::length(m[2])});
  const glm::dvec3 across = glm::cross(m[0], m[1]);
  if (!(glm::length(m[0]) > tiny * size) || !(glm::length(across) > tiny * size * size)) {
    return glm::dmat3(0.0);
  }
  const glm::dvec3 x = glm::normalize(m[0]);
  const glm::dvec3 z = glm::normalize(across);
  return {x, glm::cross(z, x), z};
}

// The only axis without a length; none: -1.
int flat_axis(const glm::dmat3& m) {
  constexpr double tiny = 1e-9;
  const double size = std::max({glm::length(m[0]), glm::length(m[1]), glm::length(m[2])});
  int flat = -1;
  for (int axis = 0; axis < 3; ++axis) {
    if (glm::length(m[axis]) > tiny * size) continue;
    if (flat >= 0) return -1;
    flat = axis;
  }
  return flat;
}

double size_of(const glm::dmat3& m) {
  return std::cbrt(std::abs(glm::determinant(m)));
}

}  // namespace

NodeKeys placement_keys(const NodeMotion& motion, std::size_t node) {
  NodeKeys result;
  const std::vector<double> times = motion.times(node);
  // A node that is flat has a height meanwhile: its axes need an inverse.
  const int flat = flat_axis(glm::dmat3(motion.to_world(node, times.front())));
  const auto axes_at = [&](double time) {
    glm::dmat3 axes(motion.to_world(node, time));
    if (flat < 0) return axes;
    const glm::dvec3 height = glm::cross(axes[(flat + 1) % 3], axes[(flat + 2) % 3]);
    const double area = glm::length(height);
    axes[flat] = area > 0.0 ? height / std::sqrt(area) : glm::dvec3(0.0);
    return axes;
  };
  double scale = 0.0;
  double whole = times.front();  // when it is largest: hidden nodes are often small ones
  for (const double time : times) {
    if (const double size = size_of(axes_at(time)); size > scale) {
      scale = size;
      whole = time;
    }
  }
  const glm::dmat3 turn = turn_of(axes_at(whole));
  if (!(scale > 0.0) || turn == glm::dmat3(0.0)) {  // it is nowhere to be seen
    result.to_placed = motion.to_world(node, 0.0);
    return result;
  }
  const glm::dmat3 shape = glm::transpose(turn) * axes_at(whole) / scale;
  const glm::dmat3 inverse = glm::inverse(shape);
  const auto state_at = [&](double time) {
    const glm::dmat4 to_world = motion.to_world(node, time);
    motion.check_coordinates(glm::dvec3(to_world[3]));
    const glm::dmat3 placed = axes_at(time) * inverse;
    constexpr double smallest = 1e-6;
    CopyPlacement placement{glm::dvec3(to_world[3]), {1.0, 0.0, 0.0, 0.0}, size_of(placed)};
    placement.scale = domain::length.nearest(std::max(placement.scale, smallest * scale));
    // One that vanishes is turned as shortly before or after.
    constexpr double moment = 1e-3;
    for (const double near : {0.0, -moment, moment}) {
      const glm::dmat3 found_turn =
          near == 0.0 ? turn_of(placed) : turn_of(axes_at(time + near) * inverse);
      if (found_turn == glm::dmat3(0.0)) continue;
      placement.rotate = glm::normalize(glm::quat_cast(found_turn));
      const glm::dmat3 rest = placed - placement.scale * found_turn;
      for (int k = 0; k < 9 && near == 0.0; ++k) {
        constexpr double allowed = 1e-3;
        result.is_stretched = result.is_stretched || std::abs(rest[k / 3][k % 3]) > allowed * scale;
      }
      break;
    }
    return placement;
  };
  const PlacementMeasure measure{max_offset(origins(motion, node))};
  const auto samples = sampled(motion, node, state_at, measure);
  result.to_placed = glm::dmat4(shape);
  if (flat >= 0) result.to_placed[flat] = glm::dvec4(0.0);
  const auto add = [&](auto& keys, auto member) {
    keys = keys_of(samples, member);
    if (is_constant(keys)) keys.resize(1);
  };
  add(result.keys.translate, &CopyPlacement::translate);
  add(result.keys.rotate, &CopyPlacement::rotate);
  add(result.keys.scale, &CopyPlacement::scale);
  return result;
}

namespace {

struct CameraState {
  glm::dvec3 eye;
  glm::dvec3 target;
  double roll;  // [degrees]
};

double turned(double first, double second) {
  return std::remainder(second - first, 360.0);
}

struct CameraMeasure {
  double offset;
  double distance_to_target;

  [[nodiscard]] static CameraState mixed(const CameraState& a, const CameraState& b, double share) {
    return {glm::mix(a.eye, b.eye, share), glm::mix(a.target, b.target, share),
            a.roll + share * turned(a.roll, b.roll)};
  }
  [[nodiscard]] double distance(const CameraState& a, const CameraState& b) const {
    const glm::dvec3 turn = (a.target - a.eye) - (b.target - b.eye);
    return std::max({glm::distance(a.eye, b.eye) / offset,
                     glm::length(turn) / (max_angle * distance_to_target),
                     std::abs(turned(a.roll, b.roll)) / glm::degrees(max_angle)});
  }
};

struct LightState {
  glm::dvec3 position;
  glm::dvec3 direction;
};

struct LightMeasure {
  double offset;

  [[nodiscard]] static LightState mixed(const LightState& a, const LightState& b, double share) {
    return {glm::mix(a.position, b.position, share), glm::mix(a.direction, b.direction, share)};
  }
  [[nodiscard]] double distance(const LightState& a, const LightState& b) const {
    return std::max(glm::distance(a.position, b.position) / offset,
                    glm::distance(a.direction, b.direction) / max_angle);
  }
};

}  // namespace

void add_keys(const NodeMotion& motion, std::size_t node, const glm::dvec3& pivot,
              NamedCamera& named) {
  Camera& camera = named.camera;
  const std::vector<double> times = motion.times(node);
  const auto camera_at = [&](double time) {
    return camera_of_node(motion.to_world(node, time), pivot, camera.vertical_fov);
  };
  const Camera first = camera_at(times.front());
  const double distance = glm::distance(first.eye, first.target);
  const auto forward_of = [](const Camera& seen) { return glm::normalize(seen.target - seen.eye); };
  // The horizon stays level unless the camera rolls, or looks along the vertical.
  constexpr glm::dvec3 vertical(0.0, 1.0, 0.0);
  constexpr double steep = 0.02;
  const bool is_ever_steep = std::ranges::any_of(times, [&](double time) {
    return glm::length(glm::cross(forward_of(camera_at(time)), vertical)) < steep;
  });
  camera.up = is_ever_steep ? first.up : vertical;
  const auto state_at = [&](double time) {
    const Camera found = camera_at(time);
    motion.check_coordinates(found.eye);
    const glm::dvec3 forward = forward_of(found);
    CameraState state{found.eye, found.eye + distance * forward, 0.0};
    const glm::dvec3 right = glm::cross(forward, camera.up);
    if (glm::length(right) > 0.0) {
      const glm::dvec3 unit_right = glm::normalize(right);
      state.roll = glm::degrees(std::atan2(glm::dot(found.up, unit_right),
                                           glm::dot(found.up, glm::cross(unit_right, forward))));
      // Roundings of a level camera.
      constexpr double level = 1e-5;
      if (std::abs(state.roll) < level) state.roll = 0.0;
    }
    return state;
  };
  const CameraMeasure measure{max_offset(origins(motion, node)), distance};
  auto samples = sampled(motion, node, state_at, measure);
  for (std::size_t i = 1; i < samples.size(); ++i) {
    const double last_roll = samples[i - 1].state.roll;
    samples[i].state.roll = last_roll + turned(last_roll, samples[i].state.roll);
  }
  camera.eye = samples.front().state.eye;
  camera.target = samples.front().state.target;
  camera.roll = samples.front().state.roll;
  named.keys.eye = keys_of(samples, &CameraState::eye);
  named.keys.target = keys_of(samples, &CameraState::target);
  Keys<double> roll = keys_of(samples, &CameraState::roll);
  if (!is_constant(roll)) named.keys.roll = std::move(roll);
}

void add_keys(const NodeMotion& motion, std::size_t node, Light& light) {
  auto* spot = std::get_if<light::Spot>(&light.kind);
  auto* sun = std::get_if<light::Directional>(&light.kind);
  glm::dvec3* const direction = spot ? &spot->direction : sun ? &sun->direction : nullptr;
  const auto state_at = [&](double time) {
    const glm::dmat4 to_world = motion.to_world(node, time);
    LightState state{glm::dvec3(to_world[3]), glm::dvec3(0.0)};
    motion.check_coordinates(state.position);
    const glm::dvec3 along = -glm::dvec3(to_world[2]);
    if (direction) state.direction = glm::length(along) > 0.0 ? glm::normalize(along) : *direction;
    return state;
  };
  const auto samples =
      sampled(motion, node, state_at, LightMeasure{max_offset(origins(motion, node))});
  light.position = samples.front().state.position;
  Keys<glm::dvec3> positions = keys_of(samples, &LightState::position);
  if (!sun && !is_constant(positions)) light.keys.position = std::move(positions);
  if (!direction) return;
  *direction = samples.front().state.direction;
  Keys<glm::dvec3> directions = keys_of(samples, &LightState::direction);
  if (!is_constant(directions)) light.keys.direction = std::move(directions);
}

}  // namespace brume
