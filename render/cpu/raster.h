#pragma once

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
// reach; a band is drawn by one thread.
class Raster {
 public:
  static constexpr int band_rows = 8;

  // `eye` is relative to where the vertices are. Refers to `triangles`. After a stop of the job the
  // raster is of no use.
  Raster(const RasterTriangles& triangles, const CameraRays& rays, const glm::dvec3& eye,
         const Film& film, const Job& job);

  [[nodiscard]] std::size_t bands() const { return bands_; }
  // Calls visit(x, y, RasterPixel) for all pixels of a band. Thread-safe.
  template <class Visit>
  void draw(std::size_t band, Visit visit) const {
    const Buffer& buffer = draw_band(band);
    std::size_t k = 0;
    for (int y0 = 0; y0 < band_rows; y0 += block) {
      for (int x0 = 0; x0 < film_.width; x0 += block) {
        for (int i = 0; i < block * block; ++i, ++k) {
          const int x = x0 + i % block;
          const int y = static_cast<int>(band) * band_rows + y0 + i / block;
          if (x >= film_.width || y >= film_.height) continue;
          visit(x, y,
                RasterPixel{buffer.distance[k], buffer.triangle[k], buffer.u[k], buffer.v[k]});
        }
      }
    }
  }

  // Pixels of a band, in blocks of 4 x 4 row by row.
  struct Buffer {
    std::vector<float> distance, u, v;
    std::vector<std::uint32_t> triangle;
  };
  static constexpr int block = 4;

  // A film as the kernels take it: the direction through the middle of pixel (x, y) is
  // corner + x per_x + y per_y, which stands at distance 1 along forward.
  struct View {
    glm::vec3 eye{0.0f};
    glm::vec3 forward{0.0f};
    glm::vec3 corner{0.0f}, per_x{0.0f}, per_y{0.0f};
    glm::vec3 to_x{0.0f}, to_y{0.0f};  // per_x and per_y over the squares of their lengths
    int width = 0;
    int height = 0;
  };
  // Vertices on the film, in pixels from the middle of the first one, and their depth along
  // forward.
  struct Projected {
    std::vector<float> x, y, z;
  };
  // The pixels [x0, x1] x [y0, y1] whose middles a triangle may hold, cut to the film.
  struct Bounds {
    std::int16_t x0 = 0, x1 = -1, y0 = 0, y1 = -1;

    [[nodiscard]] bool empty() const { return x0 > x1 || y0 > y1; }
  };

 private:
  const Buffer& draw_band(std::size_t band) const;
  void sort(const Job& job);

  const RasterTriangles& triangles_;
  Film film_;
  std::size_t bands_;
  View view_;
  Projected projected_;
  std::vector<Bounds> bounds_;  // of all triangles
  // The triangles of each band, ascending.
  std::vector<std::size_t> offsets_;
  std::vector<std::uint32_t> sorted_;
};

}  // namespace brume
