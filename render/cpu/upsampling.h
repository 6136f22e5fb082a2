#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/ext/vector_int2.hpp>
#include <glm/vec4.hpp>
#include <optional>
#include <span>
#include <vector>

#include "brume/frame.h"
#include "core/scene/camera_rays.h"
#include "render/prepare/upsampling_limits.h"
#include "render/util/job.h"

namespace brume {

// Airlight RGB and transmittance at every scale-th pixel of each row and column, the last included,
// and their edge-aware interpolation (section 5.4 of the paper). Distances come from the frame's
// depth layer; holds a reference to the frame.
class AirlightSamples {
 public:
  AirlightSamples(const Frame& frame, int scale);

  [[nodiscard]] const Film& film() const { return film_; }  // one pixel per sample
  [[nodiscard]] const Frame& frame() const { return frame_; }
  // The pixel of a sample.
  [[nodiscard]] int x(int column) const { return std::min(column * scale_, frame_.film.width - 1); }
  [[nodiscard]] int y(int row) const { return std::min(row * scale_, frame_.film.height - 1); }
  [[nodiscard]] std::size_t index(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(film_.width) +
           static_cast<std::size_t>(column);
  }
  [[nodiscard]] bool is_sample(const glm::ivec2& pixel) const {
    const auto is_on = [this](int coordinate, int size) {
      return coordinate % scale_ == 0 || coordinate == size - 1;
    };
    return is_on(pixel.x, frame_.film.width) && is_on(pixel.y, frame_.film.height);
  }
  glm::vec4& value(std::size_t i) { return values_[i]; }
  [[nodiscard]] const glm::vec4& value(int column, int row) const {
    return values_[index(column, row)];
  }
  [[nodiscard]] float distance(int column, int row) const {
    return frame_
        .depth[static_cast<std::size_t>(y(row)) * static_cast<std::size_t>(frame_.film.width) +
               static_cast<std::size_t>(x(column))];
  }

  // Call when all values are set. Tolerances are relative to the airlight's rms, that of all
  // samples where it is not given, and to a transmittance of 1.
  void measure_curvatures(double tolerance, std::optional<double> rms, const Job& job);
  // Error of linear interpolation next to a sample, in units of the tolerance.
  [[nodiscard]] float curvature(int column, int row) const {
    return curvatures_[index(column, row)];
  }
  // The same of the middle one of three values in a row.
  [[nodiscard]] float curvature_of(const glm::vec4& a, const glm::vec4& b,
                                   const glm::vec4& c) const;

  // Linear extrapolation around a sample, on its surface or the background.
  struct LocalFit {
    bool is_valid = false;
    int x = 0, y = 0;  // the sample's pixel
    glm::vec4 value{0.0f}, per_x{0.0f}, per_y{0.0f};
    float distance = 0.0f, distance_per_x = 0.0f, distance_per_y = 0.0f;

    [[nodiscard]] glm::vec4 value_at(int px, int py) const;
    // Whether a pixel at this distance lies on this surface, to a tolerance [u].
    [[nodiscard]] bool lies_on_surface(int px, int py, float pixel_distance, float tolerance) const;
  };
  [[nodiscard]] LocalFit local_fit(int column, int row) const;

 private:
  struct Slope;
  [[nodiscard]] double rms() const;
  [[nodiscard]] Slope slope(int column, int row, int right, int down) const;
  [[nodiscard]] float curvature_along(int column, int row, int right, int down) const;

  const Frame& frame_;
  int scale_;
  Film film_;
  std::vector<glm::vec4> values_;
  glm::vec4 inverse_tolerance_{1.0f};  // 1 / tolerance
  std::vector<float> curvatures_;
};

// The order of scattered pixels whose rays are evaluated together, so that vector lanes hold
// neighbours: blocks of 8 x 8.
inline std::array<int, 4> in_blocks(const glm::ivec2& pixel) {
  return {pixel.y / 8, pixel.x / 8, pixel.y, pixel.x};
}

// Sets airlight and transmittance of a pixel.
void set_airlight(Frame& frame, std::size_t pixel, const glm::vec4& value);

// A cell of 4 x 4 pixels, all on surfaces or all open, that is too curved to be interpolated.
struct CurvedCell {
  glm::ivec2 first{0};        // its upper left pixel, a sample
  bool is_open = false;       // no corner hits a surface
  std::uint16_t missing = 0;  // bit 4 y + x: a pixel without airlight
};

// The pixels that upsample() leaves to be evaluated.
struct Missing {
  std::vector<glm::ivec2> pixels;
  std::vector<CurvedCell> cells;
};

// Fills the cells right of and below the samples of a tile, after measure_curvatures(): pixels
// at the interpolated distance, to `tolerance` [u], in nearly linear cells by bilinear
// interpolation; others by extrapolation from those of the four surrounding samples that lie on
// their surface. Lists pixels for which neither applies, so that there are no halos and no thin
// objects are lost, and `exact_pixels`.
Missing upsample(const AirlightSamples& samples, const CameraRays::PixelRectangle& tile,
                 float tolerance, std::span<const glm::ivec2> exact_pixels, Frame& frame);

}  // namespace brume
