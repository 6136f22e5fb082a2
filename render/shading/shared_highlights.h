#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/ext/vector_int2.hpp>
#include <glm/vec3.hpp>
#include <vector>

#include "core/scene/camera_rays.h"
#include "render/util/job.h"
#include "render/visibility/ray_caster.h"

namespace brume {

// What wide highlights reflect at the pixels of a film. Each pixel of a block of 8 x 8 mirrors
// other rays of the lobe, and neighbours on one surface share theirs: the mean over a block around
// each pixel has all rays once, so that it shows neither noise nor copies of what is mirrored.
// Blocks of 4 x 4 have a quarter of the rays, evenly; they are for lobes that are not much wider.
class SharedHighlights {
 public:
  static constexpr int side = 8;
  static constexpr int patterns = side * side;
  // How far shared pixels are away at most.
  static constexpr int max_reach = side / 2;

  // Which rays a pixel of the whole film mirrors, in [0, patterns).
  static std::uint8_t pattern_of(const glm::ivec2& pixel) {
    const int in_quarter = (pixel.y % 4) * 4 + pixel.x % 4;
    const int quarter = (pixel.y / 4 % 2) * 2 + pixel.x / 4 % 2;
    return static_cast<std::uint8_t>(4 * in_quarter + quarter);
  }
  // How far a highlight of this alpha is shared between pixels that are so many radians apart.
  static int reach_of(float alpha, float pixel_angle);

  // Forgets all pixels of a film of that size.
  void reset(const glm::ivec2& size);
  // What a pixel itself mirrors on a surface with this normal. Thread-safe for different pixels.
  void set(const glm::ivec2& pixel, const SurfaceHit& hit, const glm::vec3& normal, int reach,
           const glm::vec3& light);
  // Takes the means of the pixels within.
  void share(const CameraRays::PixelRectangle& within, const Job& job);

  // What a pixel or one beside it reflects of a wide highlight of the same surface; null: nothing
  // known. After share().
  [[nodiscard]] const glm::vec3* near(const glm::ivec2& pixel, const SurfaceHit& hit) const;
  // By pixel, row by row; after share().
  [[nodiscard]] const std::vector<glm::vec3>& light() const { return shared_; }

 private:
  struct Pixel {
    std::int32_t surface = -1;  // < 0: there is no wide highlight
    std::uint32_t copy = 0;
    int reach = 0;
    glm::vec3 normal{0.0f};
    glm::vec3 light{0.0f};
  };
  [[nodiscard]] std::size_t index_of(const glm::ivec2& pixel) const {
    return static_cast<std::size_t>(pixel.y) * static_cast<std::size_t>(size_.x) +
           static_cast<std::size_t>(pixel.x);
  }
  [[nodiscard]] glm::vec3 mean_around(const glm::ivec2& pixel) const;

  glm::ivec2 size_{0};
  std::vector<Pixel> pixels_;
  std::vector<glm::vec3> shared_;
};

}  // namespace brume
