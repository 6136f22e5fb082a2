#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>

#include "core/scene/scene.h"
#include "render/cpu/kernels.h"
#include "render/tiles.h"

namespace brume {

// Values at the points of a tile, in whole vectors.
struct alignas(64) PointArray : std::array<float, Tiles::pixels> {};
static_assert(padded(Tiles::pixels) == Tiles::pixels);

struct PointVectors {
  PointArray x, y, z;

  [[nodiscard]] glm::dvec3 operator[](std::size_t k) const { return {x[k], y[k], z[k]}; }
  void set(std::size_t k, const glm::vec3& v) {
    x[k] = v.x;
    y[k] = v.y;
    z[k] = v.z;
  }
};

// The points of one surface that view rays of a tile hit, as arrays in single precision; those from
// `count` to padded(count) repeat the last. See SurfacePoint.
struct SurfacePoints {
  const Surface* surface = nullptr;
  std::size_t count = 0;
  PointArray u, v;             // barycentric, of the triangle's second and third corner
  glm::dvec3 origin{0.0};      // what positions are relative to
  PointVectors position;       // [u]
  PointVectors normal;         // unit, or 0 where neither triangle nor mesh has one
  PointVectors to_eye;         // unit
  PointVectors shadow_origin;  // [u]
  PointArray side;  // 1 where the side is seen that the normals of the mesh tell, else -1

  [[nodiscard]] std::size_t padded_size() const { return padded(count); }
};

// One light as seen from points.
struct LightAtPoints {
  PathBatch paths;            // from the light to the points
  PointArray cosine;          // between the normal and the direction to the light
  PointArray inverse_square;  // of the distance [1/u^2]; 0 where the light stands on the surface
  PointArray depths;          // T(s, p), b0 included
  PointArray lit;             // 1, or 0 where a surface stands between; 0 or 1 for cosine <= 0
};

struct PointRadiance {
  PointArray r, g, b;
};

}  // namespace brume
