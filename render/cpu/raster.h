#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "core/scene/camera.h"
#include "render/job.h"

namespace brume {

// Triangles for a raster, as arrays: of some meshes one after the other.
struct RasterTriangles {
  std::vector<float> x, y, z;       // vertices [u], padded to padded(count)
  std::vector<glm::uvec3> corners;  // of each triangle, in x, y and z

  [[nodiscard]] glm::vec3 relative(std::uint32_t vertex, const glm::vec3& to) const {
    return glm::vec3(x[vertex], y[vertex], z[vertex]) - to;
  }

  void add_vertex(const glm::vec3& p);
  void pad();  // after the last
};

// What a pixel sees.
struct RasterPixel {
  float distance = 0.0f;       // along the view ray [u], +inf: nothing
  std::uint32_t triangle = 0;  // index in RasterTriangles::corners
  float u = 0.0f, v = 0.0f;    // barycentric, of the second and third corner
};

// The nearest triangle at the centre of every pixel of a film, both sides seen alike, in single
// precision SIMD (Highway): what a ray through there hits first. A pixel is in a triangle if it
// lies on one side of the planes through the eye and the edges; these come out the same for the two
// triangles of an edge, so there are no gaps, and none of the triangles needs clipping.
//
// The film is cut in bands of rows. In parallel, triangles are sorted into the bands that they may
// reach, in each those first whose side is seen that most nearly faces the eye: what is behind them
// is mostly the other side of closed meshes, and passed over. A band is drawn by one thread.
class Raster {
 public:
  static constexpr int band_rows = 8;

  // `eye` is relative to where the vertices are; triangles whose plane is nearer to it than
  // `edge_on_height` are not seen. Refers to `triangles`. After a stop of the job the
  // raster is of no use.
  Raster(const RasterTriangles& triangles, const CameraRays& rays, const glm::dvec3& eye,
         double edge_on_height, const Film& film, const Job& job);

  [[nodiscard]] std::size_t bands() const { return bands_; }
  // Sets the hits and distances of a band, in arrays of the whole film. Thread-safe.
  void draw(std::size_t band, std::span<RasterPixel> hits, std::span<float> distances) const;

  // Pixels of a band, in blocks of 4 x 4 row by row.
  struct Buffer {
    std::vector<float> distance, u, v;
    std::vector<std::uint32_t> triangle;
    std::vector<float> farthest;  // per vector of pixels: at most so deep along forward
  };
  static constexpr int block = 4;

  // A film as the kernels take it: the direction through the middle of pixel (x, y) is
  // corner + x per_x + y per_y, which stands at distance 1 along forward.
  struct View {
    glm::vec3 eye{0.0f};
    double edge_on_height = 0.0;
    glm::vec3 forward{0.0f};
    glm::vec3 corner{0.0f}, per_x{0.0f}, per_y{0.0f};
    glm::vec3 to_x{0.0f}, to_y{0.0f};  // per_x and per_y over the squares of their lengths
    glm::vec2 center{0.0f};  // of the film, where forward meets it, in pixels from the first one's
    int width = 0;
    int height = 0;
  };
  // A vertex on the film: (x, y) / z is its place in pixels from the film's center (where a wide
  // view has most to lose), z its depth along forward. What is behind the eye, or as good as beside
  // it, has inverse 0.
  struct alignas(16) Vertex {
    float x = 0.0f, y = 0.0f, z = 0.0f;
    float inverse = 0.0f;  // 1 / z
  };
  // The pixels [x0, x1] x [y0, y1] whose middles a triangle may hold, cut to the film.
  struct Bounds {
    std::int16_t x0 = 0, x1 = -1, y0 = 0, y1 = -1;

    [[nodiscard]] bool empty() const { return x0 > x1 || y0 > y1; }
  };
  // Which way round a triangle's corners stand on the film; one that reaches behind the eye counts
  // as of the first kind.
  enum class Turn : std::uint8_t { one, other };
  // How deep the triangles of each kind are.
  struct TurnDepths {
    std::array<double, 2> sum{};
    std::array<std::size_t, 2> count{};
  };

 private:
  void sort(const Job& job);
  static Turn nearer_turn(std::span<const TurnDepths> depths);

  const RasterTriangles& triangles_;
  Film film_;
  std::size_t bands_;
  View view_;
  std::vector<Vertex> vertices_;
  // Of all triangles.
  std::vector<Bounds> bounds_;
  std::vector<Turn> turns_;
  Turn nearer_ = Turn::one;
  // The triangles of each band, ascending: those of one turn, then those of the other.
  std::vector<std::size_t> offsets_;
  std::vector<std::uint32_t> sorted_;
};

}  // namespace brume
