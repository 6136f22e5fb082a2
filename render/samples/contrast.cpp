#include "render/samples/contrast.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace brume {
namespace {

// Second differences that count. Of radiance, relative to the brightest of three pixels and to the
// mean of the picture: an edge of such a contrast is hardly seen.
constexpr float min_contrast = 0.04f;
constexpr float mean_share = 0.05f;
// The contrast of airlight, and of transmittance: fog is smooth, and where it is the filter changes
// a fiftieth of them.
constexpr float min_fog_contrast = 0.5f;
// The step of the inverse distances of surfaces, which are linear over a plane.
constexpr float min_depth_step = 0.02f;

// Three pixels in a row.
class Triple {
 public:
  Triple(const Frame& frame, std::size_t before, std::size_t pixel, std::size_t after)
      : frame_(frame), pixels_{before, pixel, after} {}

  [[nodiscard]] bool has_depth_step() const {
    const auto inverse = [&](std::size_t k) {
      const float depth = frame_.depth[pixels_[k]];
      return std::isfinite(depth) ? 1.0f / depth : 0.0f;
    };
    const float a = inverse(0), b = inverse(1), c = inverse(2);
    return std::abs(a + c - 2.0f * b) > min_depth_step * std::max({a, b, c});
  }

  // The contrast of surfaces or the background, seen through the fog.
  [[nodiscard]] bool has_contrast(float floor) const {
    return exceeds(min_contrast, floor, [&](std::size_t pixel, std::size_t c) {
      return frame_.beauty[4 * pixel + c] - frame_.airlight[3 * pixel + c];
    });
  }

  [[nodiscard]] bool has_fog_contrast(float floor) const {
    const auto airlight = [&](std::size_t pixel, std::size_t c) {
      return frame_.airlight[3 * pixel + c];
    };
    const auto transmittance = [&](std::size_t pixel) { return frame_.transmittance[3 * pixel]; };
    return exceeds(min_fog_contrast, floor, airlight) ||
           std::abs(second_difference(transmittance)) > min_fog_contrast;
  }

 private:
  template <class Value>
  [[nodiscard]] float second_difference(const Value& value) const {
    return value(pixels_[0]) + value(pixels_[2]) - 2.0f * value(pixels_[1]);
  }

  template <class Value>
  [[nodiscard]] bool exceeds(float contrast, float floor, const Value& value) const {
    for (std::size_t c = 0; c < 3; ++c) {
      float brightest = floor;
      for (const std::size_t pixel : pixels_) {
        brightest = std::max(brightest, frame_.beauty[4 * pixel + c]);
      }
      const float difference =
          second_difference([&](std::size_t pixel) { return value(pixel, c); });
      if (std::abs(difference) > contrast * brightest) return true;
    }
    return false;
  }

  const Frame& frame_;
  std::array<std::size_t, 3> pixels_;
};

}  // namespace

std::vector<PixelDetail> find_details(const Frame& frame, double mean_radiance, const Job& job) {
  const int width = frame.film.width;
  const int height = frame.film.height;
  std::vector<PixelDetail> details(frame.depth.size(), PixelDetail::none);
  const float floor = mean_share * static_cast<float>(mean_radiance);
  constexpr std::array<std::array<int, 2>, 4> steps{{{1, 0}, {0, 1}, {1, 1}, {1, -1}}};
  job.parallel_for(static_cast<std::size_t>(height), [&](std::size_t row) {
    const int y = static_cast<int>(row);
    for (int x = 0; x < width; ++x) {
      const auto index = [&](int column, int line) {
        return static_cast<std::size_t>(line) * static_cast<std::size_t>(width) +
               static_cast<std::size_t>(column);
      };
      const bool at_left_or_right = x == 0 || x + 1 == width;
      const bool at_top_or_bottom = y == 0 || y + 1 == height;
      bool at_edge = false, has_contrast = false, in_fog = false;
      for (const auto& [right, down] : steps) {
        if ((right != 0 && at_left_or_right) || (down != 0 && at_top_or_bottom)) continue;
        const Triple triple(frame, index(x - right, y - down), index(x, y),
                            index(x + right, y + down));
        at_edge = at_edge || triple.has_depth_step();
        has_contrast = has_contrast || triple.has_contrast(floor);
        in_fog = in_fog || triple.has_fog_contrast(floor);
      }
      if (in_fog && !at_edge) {
        details[index(x, y)] = PixelDetail::fog;
      } else if (at_edge || has_contrast || at_left_or_right || at_top_or_bottom) {
        details[index(x, y)] = PixelDetail::surfaces;
      }
    }
  });
  return details;
}

}  // namespace brume
