#include "render/prepare/fog_extent.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <iomanip>
#include <numbers>
#include <sstream>
#include <utility>
#include <vector>

#include "brume/limits.h"
#include "core/math/random_source.h"
#include "core/math/sphere_rule.h"

namespace brume {

FogExtent::FogExtent(const Scene& scene) {
  const double b0 = scene.medium.homogeneous_density();
  const std::optional<double>& extent = scene.optics.extent;
  if (!(b0 > 0.0)) return;
  has_far_light_ = scene.environment || std::ranges::any_of(scene.lights, [](const Light& light) {
                     return light.on && light.as<light::Directional>();
                   });
  if (!has_far_light_ && !extent) return;
  const auto bounds = lit_bounds(scene);
  const double diameter = bounds ? glm::length(bounds->high - bounds->low) : 0.0;
  if (diameter > 0.0) {
    ball_ = {0.5 * (bounds->low + bounds->high), diameter};
  } else {
    ball_.radius = 1.0 / b0;
  }
  if (has_far_light_) view_radius_ = std::max(ball_.radius, extent.value_or(0.0));
  if (!extent) return;
  if (bounds) ball_.center = 0.5 * (bounds->low + bounds->high);
  ball_.radius = *extent;
  fog_ = ball_;
}

FogBall fog_of(const Scene& scene) {
  return scene.optics.extent ? FogExtent(scene).fog() : FogBall();
}

namespace {

double longest_side(const Box& box) {
  const glm::dvec3 extent = box.high - box.low;
  return std::max({extent.x, extent.y, extent.z});
}

// The box, its sides moved outwards to steps of an eighth of its length.
Box in_steps(const Box& box) {
  const double step = std::exp2(std::floor(std::log2(longest_side(box))) - 3.0);
  return {step * glm::floor(box.low / step), step * glm::ceil(box.high / step)};
}

// The space above a plane as well as that in it.
Box with_space_around(const Box& box) {
  const glm::dvec3 margin =
      0.5 * glm::max(0.5 * longest_side(box) - (box.high - box.low), glm::dvec3(0.0));
  return {box.low - margin, box.high + margin};
}

// The sides of the surfaces' bounds on which they hide most of what is there from these places: of
// each axis the low one and the high one.
using HiddenSides = std::array<std::array<bool, 2>, 3>;
HiddenSides hidden_sides(const RayCaster& surfaces, std::span<const glm::dvec3> places) {
  constexpr double hidden_share = 0.5;  // a place may be beside an open end
  constexpr double steep = 0.5;         // cosine of directions that count for a side
  const std::vector<SphereNode> directions = sphere_rule(9);
  HiddenSides hidden{};
  for (std::size_t k = 0; k < 6; ++k) {
    const int axis = static_cast<int>(k / 2);
    const double side = k % 2 == 0 ? -1.0 : 1.0;
    hidden[k / 2][k % 2] = std::ranges::all_of(places, [&](const glm::dvec3& place) {
      double sum = 0.0;
      double behind = 0.0;
      for (const SphereNode& node : directions) {
        if (side * node.direction[axis] < steep) continue;
        sum += node.weight;
        if (surfaces.first_hit(place, node.direction)) behind += node.weight;
      }
      return behind > hidden_share * sum;
    });
  }
  return hidden;
}

// Ends a box soon beyond the bounds of surfaces on sides that they hide.
Box without_hidden_space(Box box, const Box& surfaces, const HiddenSides& hidden) {
  constexpr double margin = 1.0 / 64.0;
  const double beyond = margin * longest_side(box);
  for (int axis = 0; axis < 3; ++axis) {
    const auto& [low, high] = hidden[static_cast<std::size_t>(axis)];
    if (low) box.low[axis] = std::max(box.low[axis], surfaces.low[axis] - beyond);
    if (high) box.high[axis] = std::min(box.high[axis], surfaces.high[axis] + beyond);
  }
  return box;
}

// Distance to the nearest surface, along the directions of the nodes of a sphere rule.
double clearance(const RayCaster& surfaces, const glm::dvec3& position) {
  double nearest = infinity;
  for (const SphereNode& node : sphere_rule(5)) {
    nearest = std::min(nearest, surfaces.first_hit(position, node.direction).distance);
  }
  return nearest;
}

// The share of directions around a place that surfaces hide.
double hidden_share(const RayCaster& surfaces, const glm::dvec3& place) {
  double hidden = 0.0;
  for (const SphereNode& node : sphere_rule(11)) {
    if (surfaces.first_hit(place, node.direction)) hidden += node.weight;
  }
  return hidden / (4.0 * std::numbers::pi);
}

constexpr double closed_share = 0.9;

}  // namespace

Box fog_bounds(double b0, std::span<const PointLight> lights, const glm::dvec3& eye) {
  double nearest = infinity;
  for (const PointLight& light : lights) {
    if (!light.is_far) nearest = std::min(nearest, glm::length(light.position - eye));
  }
  const double least = 0.05 / b0;  // the farthest level is to reach beyond four mean free paths
  const double seen = std::exp2(std::ceil(std::log2(std::max(nearest, least))));
  const glm::dvec3 reach(std::min({2.0 / b0, seen, limits::max_length}));
  Box box{glm::dvec3(infinity), glm::dvec3(-infinity)};
  for (const PointLight& light : lights) {
    if (light.is_far) continue;
    box.low = glm::min(box.low, light.position - reach);
    box.high = glm::max(box.high, light.position + reach);
  }
  if (!(box.low.x <= box.high.x)) return {-reach, reach};
  return with_space_around(in_steps(box));
}

LitSpace space_lit_near(const RayCaster& surfaces, std::span<const glm::dvec3> lights,
                        const std::optional<Box>& room, double reach) {
  constexpr double worth = 0.25;  // of the volume of all
  // All levels of a grid reach some 400 times as far as the finest.
  constexpr double min_share = 1.0 / 128.0;
  const Box& all = surfaces.bounds();
  // Under a sun the fog over a ground needs the nodes below it: without, a floor was 7% too dark.
  const HiddenSides hidden = lights.empty() ? HiddenSides{} : hidden_sides(surfaces, lights);
  const auto with_space = [&](const Box& box) {
    return without_hidden_space(with_space_around(box), all, hidden);
  };
  const double least = 0.5 * min_share * std::max(longest_side(all), 2.0 * reach);
  LitSpace lit{with_space(all)};
  const double whole = volume(lit.fog);
  for (int axis = 0; axis < 3; ++axis) {
    const auto& [low, high] = hidden[static_cast<std::size_t>(axis)];
    if (low) lit.open.low[axis] = all.low[axis];
    if (high) lit.open.high[axis] = all.high[axis];
  }
  std::vector<double> clearances;
  for (const glm::dvec3& light : lights) clearances.push_back(clearance(surfaces, light));
  for (const double reach_of_light : {8.0, 4.0}) {  // in clearances
    Box box{glm::dvec3(infinity), glm::dvec3(-infinity)};
    const auto add = [&box](const glm::dvec3& low, const glm::dvec3& high) {
      box.low = glm::min(box.low, low);
      box.high = glm::max(box.high, high);
    };
    for (std::size_t i = 0; i < lights.size(); ++i) {
      if (!std::isfinite(clearances[i])) continue;
      const glm::dvec3 around(std::max(reach_of_light * clearances[i], least));
      add(lights[i] - around, lights[i] + around);
    }
    if (room) {
      const glm::dvec3 middle = 0.5 * (room->low + room->high);
      add(glm::min(room->low, middle - least), glm::max(room->high, middle + least));
    }
    if (!(box.low.x <= box.high.x)) break;
    box = with_space(in_steps(box));
    if (volume(box) > worth * whole) continue;
    lit.fog = box;
    break;
  }
  return lit;
}

bool close_in(const RayCaster& surfaces, std::span<const glm::dvec3> lights) {
  // Light that is scattered anywhere on its way.
  constexpr std::size_t walks = 512;
  constexpr int steps = 6;
  if (lights.empty() || surfaces.has_panes()) return false;
  RandomSource random(1);
  for (std::size_t i = 0; i < std::max(walks, lights.size()); ++i) {
    glm::dvec3 place = lights[i % lights.size()];
    for (int step = 0; step < steps; ++step) {
      const glm::dvec3 w = glm::normalize(random.in_ball());
      const SurfaceHit hit = surfaces.first_hit(place, w);
      if (!hit) return false;
      place += random.uniform() * hit.distance * w;
    }
  }
  return true;
}

bool is_indoors(const RayCaster& surfaces, const glm::dvec3& place) {
  return hidden_share(surfaces, place) >= 0.75;
}

std::optional<Box> room_around(const RayCaster& surfaces, const glm::dvec3& place) {
  constexpr double corners = 1.5;  // no farther than so many times what is closed
  const double widest = longest_side(surfaces.bounds()) / 3.0;
  const std::vector<SphereNode> nodes = sphere_rule(11);
  std::vector<glm::dvec3> directions;
  for (const SphereNode& node : nodes) directions.push_back(node.direction);
  std::vector<SurfaceHit> hits(directions.size());
  surfaces.first_hits(place, directions, hits);

  std::vector<std::pair<double, double>> walls;  // distance and solid angle
  for (std::size_t i = 0; i < hits.size(); ++i)
    walls.push_back({hits[i].distance, nodes[i].weight});
  std::ranges::sort(walls);
  double open = 4.0 * std::numbers::pi * (1.0 - closed_share);
  while (!walls.empty() && walls.back().second <= open) {
    open -= walls.back().second;
    walls.pop_back();
  }
  if (walls.empty() || !std::isfinite(walls.back().first)) return std::nullopt;

  // The box holds whole surfaces, so that it stays while the eye moves through the room.
  Box box{place, place};
  for (const SurfaceHit& hit : hits) {
    if (!(hit.distance <= corners * walls.back().first)) continue;
    const Box& wall = surfaces.surface_bounds(static_cast<std::size_t>(hit.surface));
    if (longest_side(wall) > widest) continue;  // the ground
    box.low = glm::min(box.low, wall.low);
    box.high = glm::max(box.high, wall.high);
  }
  if (box.low == box.high || longest_side(box) > widest) return std::nullopt;
  return box;
}

std::optional<Box> closed_room_around(const RayCaster& surfaces, const glm::dvec3& place) {
  constexpr double flattest_room = 0.2;  // else a ground with walls or leaves around the place
  if (hidden_share(surfaces, place) < closed_share) return std::nullopt;
  if (const std::optional<Box> room = room_around(surfaces, place)) return room;
  const Box& all = surfaces.bounds();
  const glm::dvec3 sides = all.high - all.low;
  if (std::min({sides.x, sides.y, sides.z}) < flattest_room * longest_side(all))
    return std::nullopt;
  return all;
}

double FogExtent::ray_distance(const glm::dvec3& eye) const {
  return view_radius_ + glm::length(eye - ball_.center);
}

double FogExtent::ray_distance(const CameraRays& rays) const {
  return view_radius_ + std::abs(rays.distance_to(ball_.center));
}

namespace {

// Three digits of a length, all of one that has more.
std::string length_text(double length) {
  std::ostringstream text;
  text << std::setprecision(length < 100.0 ? 2 : 15)
       << (length < 100.0 ? length : std::round(length));
  return text.str();
}

// The extinction of homogeneous fog, by the mean of its albedo [1/u].
double extinction_of_fog(const Scene& scene) {
  const glm::dvec3& albedo = scene.optics.albedo;
  return scene.medium.homogeneous_density() / ((albedo.x + albedo.y + albedo.z) / 3.0);
}

}  // namespace

double transmittance_of_fog(const Scene& scene) {
  const FogExtent extent(scene);
  if (!extent.has_far_light()) return 1.0;
  return std::exp(-extinction_of_fog(scene) * extent.surface_distance());
}

std::optional<std::string> deep_fog_text(const Scene& scene) {
  const double transmittance = transmittance_of_fog(scene);
  if (transmittance >= 0.5) return std::nullopt;
  const double reach = FogExtent(scene).surface_distance();
  const double half =
      std::numbers::ln2 / extinction_of_fog(scene);  // the length that lets it through
  std::ostringstream text;
  text << "the homogeneous fog lets ";
  if (transmittance < 1e-3) {
    text << "less than 0.1";
  } else {
    text << std::setprecision(2) << 100.0 * transmittance;
  }
  text << "% of the light from far away through to the middle of the scene, for it reaches "
       << length_text(reach) << " u, "
       << (scene.optics.extent ? "the medium's extent" : "as far as all that is in the scene")
       << "; a homogeneous density of " << std::setprecision(2)
       << scene.medium.homogeneous_density() * half / reach << ", or a medium.extent of "
       << length_text(half) << ", would let half of it through";
  return text.str();
}

}  // namespace brume
