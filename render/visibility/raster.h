#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <span>
#include <vector>

#include "core/scene/camera_rays.h"
#include "render/util/job.h"

namespace brume {

// Triangles of all meshes for rasterization, as arrays.
struct RasterTriangles {
  std::vector<float> x, y, z;       // vertices [u], padded to padded(count)
  std::vector<glm::uvec3> corners;  // vertex indices per triangle

  [[nodiscard]] glm::vec3 relative(std::uint32_t vertex, const glm::vec3& to) const {
    return glm::vec3(x[vertex], y[vertex], z[vertex]) - to;
  }

  void add_vertex(const glm::vec3& p);
  void pad();  // call after the last vertex
};

// First hit of a pixel.
struct RasterPixel {
  float distance = 0.0f;       // along the view ray [u], +inf: nothing
  std::uint32_t triangle = 0;  // index in RasterTriangles::corners
  float u = 0.0f, v = 0.0f;    // barycentric, of the second and third corner
};

// A tiled SIMD rasterizer (Highway, single precision): the nearest triangle at every pixel center,
// both sides visible. Inside tests use the planes through the eye and the edges, which are
// identical for the two triangles of an edge: no gaps, and no clipping.
//
// The film is divided into bands of rows. Triangles are binned into bands in parallel, front-facing
// ones first (by majority winding): the others are mostly back sides of closed meshes and fail the
// depth test. One thread draws a band.
class Raster {
 public:
  static constexpr int band_rows = 8;

  // `eye` is relative to the vertices' origin. Keeps a reference to `triangles`. Invalid after the
  // job was stopped.
  Raster(const RasterTriangles& triangles, const CameraRays& rays, const glm::dvec3& eye,
         const Film& film, const Job& job);

  [[nodiscard]] std::size_t bands() const { return bands_; }
  // Writes hits and distances of a band, into arrays of the whole film. Thread-safe.
  void draw(std::size_t band, std::span<RasterPixel> hits, std::span<float> distances) const;

  // Pixels of a band, in blocks of 4 x 4, row-major.
  struct Buffer {
    std::vector<float> distance, u, v;
    std::vector<std::uint32_t> triangle;
    std::vector<float> farthest;  // per vector of pixels: maximum depth along forward
  };
  static constexpr int block = 4;

  // The camera for the kernels: the direction through the center of pixel (x, y) of the whole film
  // is corner + x per_x + y per_y, at distance 1 along forward.
  struct View {
    glm::vec3 eye{0.0f};
    glm::dvec3 exact_eye{0.0};
    glm::vec3 forward{0.0f};
    glm::vec3 corner{0.0f}, per_x{0.0f}, per_y{0.0f};
    glm::vec3 to_x{0.0f}, to_y{0.0f};  // per_x and per_y over the squares of their lengths
    // The point of the whole film where forward meets it, in pixels from the first one's.
    glm::vec2 center{0.0f};
    glm::ivec2 whole{0};  // its size
    glm::ivec2 first{0};  // where this film begins on it, in whole blocks
    int width = 0;
    int height = 0;
    std::vector<glm::vec4> clip{};  // normals of clipping planes, and how far these are [u]
  };
  // A projected vertex: (x, y) / z is its position in pixels from the whole film's center (which
  // wide views would lose precision without), z its depth along forward. At or behind the eye
  // plane, inverse is 0.
  struct alignas(16) Vertex {
    float x = 0.0f, y = 0.0f, z = 0.0f;
    float inverse = 0.0f;  // 1 / z
  };
  // The pixels [x0, x1] x [y0, y1] whose centers a triangle may contain, clipped to a film.
  struct Bounds {
    std::int16_t x0 = 0, x1 = -1, y0 = 0, y1 = -1;

    [[nodiscard]] bool empty() const { return x0 > x1 || y0 > y1; }
  };
  // Winding of a projected triangle; those that reach behind the eye count as the first.
  enum class Winding : std::uint8_t { one, other };
  // Sum of depths and number of triangles per winding.
  struct WindingDepths {
    std::array<double, 2> sum{};
    std::array<std::size_t, 2> count{};
  };

 private:
  void sort(const Job& job);
  static Winding nearer_winding(std::span<const WindingDepths> depths);

  const RasterTriangles& triangles_;
  Film film_;
  std::size_t bands_;
  View view_;
  std::vector<Vertex> vertices_;
  // Per triangle.
  std::vector<Bounds> bounds_;
  std::vector<Winding> windings_;
  Winding nearer_ = Winding::one;
  // Triangle indices per band, ascending, nearer winding first.
  std::vector<std::size_t> offsets_;
  std::vector<std::uint32_t> sorted_;
};

}  // namespace brume
