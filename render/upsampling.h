#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>
#include <glm/ext/vector_int2.hpp>
#include <glm/vec4.hpp>
#include <span>
#include <vector>

#include "core/scene/camera.h"
#include "render/frame.h"
#include "render/job.h"

namespace brume {

// How bent samples of a surface may be, along each axis, for its surroundings to be told from them:
// going on straight for all of a cell is off by up to four times that.
inline constexpr float most_bend_of_surroundings = 0.125f;
// The least share in the linear interpolation of a pixel that samples of its surface must have.
inline constexpr float least_surface_share = 0.25f;

// How far off in depth a pixel may be, for each unit of tolerance: in radii of the smallest
// Gaussian that matters to it, and in mean free paths of b0.
inline constexpr float radii_per_tolerance = 5.0f;
inline constexpr float free_paths_per_tolerance = 2.0f;

// Airlight RGB and transmittance of a frame at every scale-th pixel of each row and column, the
// last ones included, and what they tell of the pixels between them (section 5.4 of the paper).
// Distances are those of the frame's depth layer, which must be there; refers to the frame.
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
    const auto is_on = [this](int at, int size) { return at % scale_ == 0 || at == size - 1; };
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

  // After all values are there: how far they may be off, in shares of the airlight's rms and of a
  // transmittance of 1.
  void measure_bends(double tolerance, const Job& job);
  // How wrong linear interpolation beside a sample is, in units of what is tolerated.
  [[nodiscard]] float bend(int column, int row) const { return bends_[index(column, row)]; }

  // What is around a sample as far as its surface, or the open, goes on as it does in the samples
  // beside it.
  struct Surroundings {
    bool known = false;
    int x = 0, y = 0;  // the sample's pixel
    glm::vec4 value{0.0f}, per_x{0.0f}, per_y{0.0f};
    float distance = 0.0f, distance_per_x = 0.0f, distance_per_y = 0.0f;

    [[nodiscard]] glm::vec4 value_at(int px, int py) const;
    // Whether a pixel at this distance is of this surface, to a tolerance [u].
    [[nodiscard]] bool show(int px, int py, float at, float tolerance) const;
  };
  [[nodiscard]] Surroundings surroundings(int column, int row) const;

 private:
  struct Slope;
  [[nodiscard]] Slope slope(int column, int row, int right, int down) const;
  // How far the middle between two samples is from the line between them, from three in a row.
  [[nodiscard]] float bend_of(const glm::vec4& a, const glm::vec4& b, const glm::vec4& c) const;
  [[nodiscard]] float bend_along(int column, int row, int right, int down) const;

  const Frame& frame_;
  int scale_;
  Film film_;
  std::vector<glm::vec4> values_;
  glm::vec4 tolerated_{1.0f};  // 1 / what is tolerated
  std::vector<float> bends_;
};

// Sets airlight and transmittance of a pixel.
void set_airlight(Frame& frame, std::size_t pixel, const glm::vec4& value);

// Fills the pixels of the cells right of and below the samples of a tile from the samples, after
// measure_bends():
//   pixels as distant as interpolated, to `tolerance` [u], in cells that are nearly linear, by
//   linear interpolation;
//   others from those of the four samples around them whose surface they are on.
// Calls exact(x, y) for pixels that neither is good enough for: there are no halos and no thin
// objects lost; and for the tile's `exact_pixels`, which nothing between samples tells.
void upsample(const AirlightSamples& samples, const CameraRays::PixelRectangle& tile,
              float tolerance, std::span<const glm::ivec2> exact_pixels, Frame& frame,
              const std::function<void(int x, int y)>& exact);

}  // namespace brume
