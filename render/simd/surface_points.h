#pragma once

#include <array>
#include <cstddef>
#include <glm/vec3.hpp>

#include "brume/scene.h"
#include "render/geometry/tiles.h"
#include "render/simd/gaussian_kernels.h"

namespace brume {

// One value per point of a tile, padded to whole vectors.
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

// The reflection of a metallic-roughness material at points: see GgxReflection.
struct GgxPoints {
  PointVectors diffuse, f0;
  PointVectors emitted;  // radiance
  PointArray alpha;
  PointArray lobe;  // 1; 0 where mirrored rays hold what the highlight reflects of surfaces and fog
};

// Hit points of one surface in a tile, as arrays in single precision; padded to padded(count) by
// repeating the last. See SurfacePoint.
struct SurfacePoints {
  const Surface* surface = nullptr;
  std::size_t count = 0;
  PointArray u, v;             // barycentric, of the triangle's second and third corner
  glm::dvec3 origin{0.0};      // origin of positions
  PointVectors position;       // [u]
  PointVectors normal;         // unit, or 0 if degenerate
  PointVectors to_eye;         // unit
  PointVectors shadow_origin;  // [u]
  PointArray side;             // 1 if the front (of the mesh's normals) is visible, else -1
  // Between neighbouring view rays, and between parallel ones [u]; both 0: textures are not
  // averaged.
  float pixel_angle = 0.0f, pixel_width = 0.0f;
  GgxPoints ggx;  // set for such materials only

  [[nodiscard]] std::size_t padded_size() const { return padded(count); }
};

// One light at the points.
struct LightAtPoints {
  PathBatch paths;            // from the light to the points
  PointArray cosine;          // of the angle between normal and light direction
  PointArray inverse_square;  // of the distance [1/u^2]; 0 for a light on the surface
  PointArray depths;          // T(s, p), b0 included
  PointArray lit;             // share that surfaces let through; undefined for cosine <= 0
};

struct PointRadiance {
  PointArray r, g, b;

  [[nodiscard]] glm::vec3 operator[](std::size_t k) const { return {r[k], g[k], b[k]}; }
  void add(std::size_t k, const glm::vec3& radiance) {
    r[k] += radiance.r;
    g[k] += radiance.g;
    b[k] += radiance.b;
  }
};

}  // namespace brume
