#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/ext/vector_int2.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <span>
#include <vector>

#include "core/scene/camera_rays.h"
#include "render/util/job.h"
#include "render/visibility/surface_hit.h"

namespace brume {

// Light that a highlight mirrors, over the two parts of its reflectance: f0, and what grazing light
// adds to it.
struct Highlight {
  glm::vec3 base{0.0f}, grazing{0.0f};

  [[nodiscard]] glm::vec3 reflected(const glm::vec3& f0) const { return f0 * base + grazing; }
};

// Wide highlights at the pixels of a film. Each pixel of a block of 8 x 8 mirrors other rays of the
// lobe, and neighbours on one surface share theirs: the mean over a block around each pixel has all
// rays once, so that flat surfaces show neither noise nor copies of what is mirrored. Blocks of
// 4 x 4 have a quarter of the rays, evenly; they are for lobes that are not much wider. Where
// normals vary there are few to share with: lonely pixels. 84 bytes a pixel.
class SharedHighlights {
 public:
  static constexpr int side = 8;
  static constexpr int patterns = side * side;
  // How far shared pixels are away at most.
  static constexpr int max_reach = side / 2;

  struct Pixel {
    std::int32_t surface = -1;  // < 0: there is no wide highlight
    std::uint32_t copy = 0;
    float alpha = 0.0f;
    glm::vec3 normal{0.0f};
    glm::vec3 f0{0.0f};
    Highlight own;

    // Whether a highlight of that surface and normal mirrors about the same.
    [[nodiscard]] bool is_like(std::int32_t other_surface, std::uint32_t other_copy,
                               const glm::vec3& other_normal) const;
  };

  // Which rays a pixel of the whole film mirrors, in [0, patterns).
  static std::uint8_t pattern_of(const glm::ivec2& pixel) {
    const int in_quarter = (pixel.y % 4) * 4 + pixel.x % 4;
    const int quarter = (pixel.y / 4 % 2) * 2 + pixel.x / 4 % 2;
    return static_cast<std::uint8_t>(4 * in_quarter + quarter);
  }

  // Forgets all pixels of a film of that size, whose pixels are so many radians apart; {0, 0} frees
  // the memory.
  void reset(const glm::ivec2& size, float pixel_angle);
  // Thread-safe for different pixels.
  void set(const glm::ivec2& pixel, const Pixel& highlight) {
    pixels_[index_of(pixel)] = highlight;
  }
  // Takes the means of the pixels within, and adds what they reflect to the radiance of a film's
  // pixels.
  void share(const CameraRays::PixelRectangle& within, const Job& job,
             std::span<glm::vec3> radiance);

  // Whether a pixel has found few to share with; it then mirrors nothing here. After share().
  [[nodiscard]] bool is_lonely(const glm::ivec2& pixel) const {
    return pixels_[index_of(pixel)].surface == lonely;
  }
  // The highlight of a pixel or one beside it that a surface point seen in it has as well; null:
  // nothing known. After share().
  [[nodiscard]] const Highlight* find(const glm::ivec2& pixel, const SurfaceHit& hit,
                                      const glm::vec3& normal) const;

 private:
  static constexpr std::int32_t lonely = -2;
  [[nodiscard]] std::size_t index_of(const glm::ivec2& pixel) const {
    return static_cast<std::size_t>(pixel.y) * static_cast<std::size_t>(size_.x) +
           static_cast<std::size_t>(pixel.x);
  }
  // Nullopt: the pixel is lonely.
  [[nodiscard]] std::optional<Highlight> mean_around(const glm::ivec2& pixel) const;

  glm::ivec2 size_{0};
  float pixel_angle_ = 0.0f;
  std::vector<Pixel> pixels_;
  std::vector<Highlight> shared_;
};

}  // namespace brume
