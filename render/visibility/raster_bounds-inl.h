// Where the triangles of Raster are on the film. Included once per instruction set by raster.cpp.

#if defined(BRUME_RASTER_BOUNDS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef BRUME_RASTER_BOUNDS_INL_H
#undef BRUME_RASTER_BOUNDS_INL_H
#else
#define BRUME_RASTER_BOUNDS_INL_H
#endif

#include <hwy/highway.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>

#include "render/geometry/edge_on.h"
#include "render/visibility/raster.h"

HWY_BEFORE_NAMESPACE();
namespace brume::HWY_NAMESPACE {

constexpr float infinite = std::numeric_limits<float>::infinity();

// Where rounding leaves a coordinate [pixels].
HWY_INLINE float Below(float x) {
  return x - (0.01f + 1e-5f * std::abs(x));
}
HWY_INLINE float Above(float x) {
  return x + (0.01f + 1e-5f * std::abs(x));
}

// Where on the film a triangle is.
struct Extent {
  glm::vec2 low{infinite};
  glm::vec2 high{-infinite};

  HWY_INLINE void add(const glm::vec2& p) {
    low = glm::min(low, p);
    high = glm::max(high, p);
  }
  // An edge that runs on to behind the eye: where it leaves, in that direction on the film.
  HWY_INLINE void add_beyond(const glm::vec2& direction, float rounding) {
    for (int k = 0; k < 2; ++k) {
      if (direction[k] > -rounding) high[k] = infinite;
      if (direction[k] < rounding) low[k] = -infinite;
    }
  }
};

// On the whole film.
HWY_INLINE Raster::Bounds BoundsOf(const std::array<Raster::Vertex, 3>& corners,
                                   const Raster::View& view) {
  Extent extent;
  int seen = 0;
  for (const Raster::Vertex& v : corners) {
    if (!(v.inverse > 0.0f)) continue;
    ++seen;
    extent.add(view.center + glm::vec2(v.x, v.y) * v.inverse);
  }
  if (seen == 0) return {};
  for (std::size_t k = 0; seen < 3 && k < 3; ++k) {
    for (const std::size_t l : {(k + 1) % 3, (k + 2) % 3}) {
      const Raster::Vertex& corner = corners[k];
      const Raster::Vertex& to = corners[l];
      if (!(corner.inverse > 0.0f) || to.inverse > 0.0f) continue;
      const glm::vec2 a(corner.x, corner.y);
      const glm::vec2 b(to.x, to.y);
      const float behind = std::min(to.z, 0.0f);
      const glm::vec2 size = glm::abs(behind * a) + glm::abs(corner.z * b);
      extent.add_beyond(corner.z * b - behind * a, 1e-4f * (size.x + size.y));
    }
  }
  const auto width = static_cast<float>(view.whole.x);
  const auto height = static_cast<float>(view.whole.y);
  const auto first = [](float x, float end) HWY_ATTR {
    return static_cast<std::int16_t>(std::ceil(std::min(std::max(Below(x), 0.0f), end)));
  };
  const auto last = [](float x, float end) HWY_ATTR {
    return static_cast<std::int16_t>(std::floor(std::min(std::max(Above(x), -1.0f), end - 1.0f)));
  };
  return {first(extent.low.x, width), last(extent.high.x, width), first(extent.low.y, height),
          last(extent.high.y, height)};
}

// The part of bounds on the whole film that is on this one.
HWY_INLINE Raster::Bounds ClippedTo(const Raster::View& view, const Raster::Bounds& whole) {
  const auto first = [](int x, int start) {
    return static_cast<std::int16_t>(std::max(x - start, 0));
  };
  const auto last = [](int x, int start, int size) {
    return static_cast<std::int16_t>(std::min(x - start, size - 1));
  };
  return {first(whole.x0, view.first.x), last(whole.x1, view.first.x, view.width),
          first(whole.y0, view.first.y), last(whole.y1, view.first.y, view.height)};
}

HWY_INLINE Raster::Winding WindingOf(const std::array<Raster::Vertex, 3>& corners) {
  const auto& [a, b, c] = corners;
  if (!(std::min({a.inverse, b.inverse, c.inverse}) > 0.0f)) return Raster::Winding::one;
  const auto project = [](const Raster::Vertex& v) { return glm::vec2(v.x, v.y) * v.inverse; };
  const glm::vec2 along = project(b) - project(a);
  const glm::vec2 across = project(c) - project(a);
  return along.x * across.y > along.y * across.x ? Raster::Winding::one : Raster::Winding::other;
}

// is_edge_on() of a triangle; few need it in double.
HWY_INLINE bool IsEdgeOn(const RasterTriangles& triangles, const glm::uvec3& c,
                         const Raster::View& view) {
  const auto corner = [&](std::uint32_t vertex) {
    return triangles.relative(vertex, glm::vec3(0.0f));
  };
  const std::array<glm::vec3, 3> corners{corner(c.x), corner(c.y), corner(c.z)};
  const glm::vec3 normal = glm::cross(corners[1] - corners[0], corners[2] - corners[0]);
  const glm::vec3 sizes = glm::max(glm::vec3(coordinate_sizes(corners)), glm::abs(view.eye));
  const float size = std::max({sizes.x, sizes.y, sizes.z});
  constexpr auto rounding = static_cast<float>(100.0 * edge_on_rounding);
  constexpr auto share = static_cast<float>(100.0 * edge_on_share);
  if (std::abs(glm::dot(normal, view.eye - corners[0])) >
      glm::dot(glm::abs(normal), rounding * sizes + share * size)) {
    return false;
  }
  return is_edge_on(corners, view.exact_eye);
}

}  // namespace brume::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
