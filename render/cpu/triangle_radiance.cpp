#include "render/cpu/triangle_radiance.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <limits>

#include "render/cpu/surface_kernels.h"
#include "render/cpu/surfaces.h"

namespace brume {
namespace {

constexpr std::size_t probes = TriangleRadiance::probes;

float greatest(const glm::vec3& v) {
  return std::max({v.r, v.g, v.b});
}

glm::vec3 sent_from(const PointRadiance& radiance, std::size_t point) {
  return {radiance.r[point], radiance.g[point], radiance.b[point]};
}

// How much the lamp sees of the triangle whose probes start at `first`; of a triangle that is
// turned away from it, `none`.
TriangleSight sight_of(const SurfacePoints& points, const SurfaceLight& light,
                       const LightAtPoints& at, std::size_t first) {
  const auto begin = at.cosine.begin() + static_cast<std::ptrdiff_t>(first);
  const bool faces = std::any_of(begin, begin + probes, [](float cosine) { return cosine > 0.0f; });
  if (!faces) return TriangleSight::none;
  if (!light.sights) return TriangleSight::unknown;
  return light.sights->of(points.triangle[first], points.side[first]);
}

RadiancePatch patch_of(const PointRadiance& sent, std::size_t first) {
  std::array<glm::vec3, 6> values;
  for (std::size_t k = 0; k < values.size(); ++k) values[k] = sent_from(sent, first + k);
  return RadiancePatch(values);
}

bool is_close(const RadiancePatch& patch, const SurfacePoints& points, const PointRadiance& sent,
              std::size_t first) {
  float most = 0.0f;
  for (std::size_t k = 0; k < 3; ++k) most = std::max(most, greatest(sent_from(sent, first + k)));
  for (std::size_t k = 0; k < probes; ++k) {
    const glm::vec2& place = TriangleRadiance::probe_places[k];
    const glm::vec3 off = glm::abs(sent_from(sent, first + k) - patch.at(place.x, place.y));
    if (!(greatest(off) <= TriangleRadiance::tolerance * most)) return false;
    // A side is that of the smoothed normals, which must not change on the way.
    if (points.side[first + k] != points.side[first]) return false;
  }
  return true;
}

}  // namespace

void TriangleRadiance::keep(const SurfacePoints& points, std::span<const SurfaceLight> lights,
                            const PointRadiance& radiance) {
  const std::size_t count = points.count / probes;
  std::array<State, Tiles::pixels / probes> states;
  std::array<RadiancePatch, Tiles::pixels / probes> patches;
  for (std::size_t i = 0; i < count; ++i) {
    patches[i] = patch_of(radiance, i * probes);
    states[i] = is_close(patches[i], points, radiance, i * probes) ? State::kept : State::not_kept;
  }
  thread_local LightAtPoints at;
  for (const SurfaceLight& light : lights) {
    see_light(points, glm::vec3(light.light.position - points.origin), at);
    for (std::size_t i = 0; i < count; ++i) {
      if (states[i] != State::kept) continue;
      const TriangleSight sight = sight_of(points, light, at, i * probes);
      if (sight == TriangleSight::unknown) states[i] = State::unknown;
      if (sight == TriangleSight::in_part) states[i] = State::not_kept;
    }
  }
  for (std::size_t i = 0; i < count; ++i) {
    if (states[i] == State::unknown) continue;
    const std::size_t first = i * probes;
    const glm::dvec3 a = points.position[first];
    glm::dvec3 normal = glm::cross(points.position[first + 1] - a, points.position[first + 2] - a);
    normal /= std::max(glm::length(normal), std::numeric_limits<double>::min());
    if (glm::dot(normal, points.to_eye[first]) < 0.0) normal *= -1.0;
    triangles_[points.triangle[first]] = {patches[i], glm::vec3(normal),
                                          static_cast<float>(glm::dot(normal, a)), states[i]};
  }
}

}  // namespace brume
