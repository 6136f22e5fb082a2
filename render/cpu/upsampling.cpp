#include "render/cpu/upsampling.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <optional>
#include <span>

#include "render/cpu/interpolation_kernels.h"
#include "render/geometry/tiles.h"

namespace brume {
namespace {

// Whether two distances may belong to one surface.
bool continuous(float a, float b) {
  return a == b || std::abs(a - b) < continuous_share * std::min(a, b);
}

}  // namespace

AirlightSamples::AirlightSamples(const Frame& frame, int scale)
    : frame_(frame),
      scale_(scale),
      film_{(frame.film.width + scale - 2) / scale + 1,
            (frame.film.height + scale - 2) / scale + 1},
      values_(static_cast<std::size_t>(film_.width) * static_cast<std::size_t>(film_.height)),
      curvatures_(values_.size()) {}

void AirlightSamples::measure_curvatures(double tolerance, const Job& job) {
  double square = 0.0;
  for (const glm::vec4& v : values_) {
    square += static_cast<double>(v.x * v.x + v.y * v.y + v.z * v.z);
  }
  const double rms = std::sqrt(square / (3.0 * static_cast<double>(values_.size())));
  const float light = 1.0f / static_cast<float>(std::max(tolerance * rms, 1e-30));
  tolerated_ = glm::vec4(light, light, light, static_cast<float>(1.0 / tolerance));
  job.each(static_cast<std::size_t>(film_.height), [&](std::size_t at) {
    const int row = static_cast<int>(at);
    for (int column = 0; column < film_.width; ++column) {
      float curvature = film_.width < 3 || film_.height < 3 ? unknown_curvature : 0.0f;
      if (column > 0 && column + 1 < film_.width) {
        curvature = std::max(curvature, curvature_along(column, row, 1, 0));
      }
      if (row > 0 && row + 1 < film_.height)
        curvature = std::max(curvature, curvature_along(column, row, 0, 1));
      curvatures_[index(column, row)] = curvature;
    }
  });
}

float AirlightSamples::curvature_of(const glm::vec4& a, const glm::vec4& b,
                                    const glm::vec4& c) const {
  const glm::vec4 d = glm::abs(a + c - 2.0f * b) * tolerated_ * middle_per_second_difference;
  return std::max({d.x, d.y, d.z, d.w});
}

float AirlightSamples::curvature_along(int column, int row, int right, int down) const {
  // Across the edge of an object, distances tell.
  const float t = distance(column, row);
  if (!continuous(distance(column - right, row - down), t) ||
      !continuous(t, distance(column + right, row + down))) {
    return 0.0f;
  }
  return curvature_of(value(column - right, row - down), value(column, row),
                      value(column + right, row + down));
}

struct AirlightSamples::Slope {
  bool known = false;
  glm::vec4 value{0.0f};  // per pixel
  float distance = 0.0f;
};

// From three samples in a row that are as far apart: this one in the middle, or at an end where its
// surface does not go on.
AirlightSamples::Slope AirlightSamples::slope(int column, int row, int right, int down) const {
  const auto is_there = [&](int k) {
    const int c = column + k * right;
    const int r = row + k * down;
    return c >= 0 && r >= 0 && c < film_.width && r < film_.height;
  };
  const auto at = [&](int k) { return distance(column + k * right, row + k * down); };
  const auto is_continuous = [&](int from, int to) {
    return is_there(to) && continuous(at(from), at(to));
  };
  const bool before = is_continuous(0, -1);
  const bool after = is_continuous(0, 1);
  const int center = before && after ? 0 : before ? -1 : 1;
  if (!before && !after) return {};
  if (center != 0 && !is_continuous(center, 2 * center)) return {};
  const int last_column = column + (center + 1) * right;
  const int last_row = row + (center + 1) * down;
  // The last ones may be nearer.
  if (last_column * scale_ > x(last_column) || last_row * scale_ > y(last_row)) return {};

  const auto value_of = [&](int k) -> const glm::vec4& {
    return value(column + k * right, row + k * down);
  };
  const glm::vec4& a = value_of(center - 1);
  const glm::vec4& b = value_of(center);
  const glm::vec4& c = value_of(center + 1);
  if (!(curvature_of(a, b, c) <= max_curvature_of_surroundings)) return {};
  // Of the parabola through all three, at this one.
  const float each = 1.0f / static_cast<float>(scale_);
  const auto from_center = static_cast<float>(-center);
  Slope result{true, each * (0.5f * (c - a) + from_center * (a + c - 2.0f * b))};
  if (std::isfinite(at(0))) {
    const float displaced = at(center - 1) + at(center + 1) - 2.0f * at(center);
    result.distance = each * (0.5f * (at(center + 1) - at(center - 1)) + from_center * displaced);
  }
  return result;
}

AirlightSamples::Surroundings AirlightSamples::surroundings(int column, int row) const {
  const Slope along_x = slope(column, row, 1, 0);
  if (!along_x.known) return {};
  const Slope along_y = slope(column, row, 0, 1);
  if (!along_y.known) return {};
  return {true,
          x(column),
          y(row),
          value(column, row),
          along_x.value,
          along_y.value,
          distance(column, row),
          along_x.distance,
          along_y.distance};
}

glm::vec4 AirlightSamples::Surroundings::value_at(int px, int py) const {
  const glm::vec4 v =
      value + static_cast<float>(px - x) * per_x + static_cast<float>(py - y) * per_y;
  return glm::max(glm::vec4(v.x, v.y, v.z, std::min(v.w, 1.0f)), 0.0f);
}

bool AirlightSamples::Surroundings::show(int px, int py, float at, float tolerance) const {
  if (!std::isfinite(distance)) return !std::isfinite(at);
  const float expected = distance + static_cast<float>(px - x) * distance_per_x +
                         static_cast<float>(py - y) * distance_per_y;
  return std::abs(at - expected) <= tolerance;
}

void set_airlight(Frame& frame, std::size_t pixel, const glm::vec4& value) {
  for (std::size_t k = 0; k < 3; ++k) {
    frame.airlight[3 * pixel + k] = value[static_cast<int>(k)];
    frame.transmittance[3 * pixel + k] = value.w;
  }
}

namespace {

// A cell between four samples, and its pixels [x0, x1) x [y0, y1).
struct Cell {
  int column, row;  // of the first sample
  int x0, y0, x1, y1;
  CellRow::Kind kind;
  std::array<float, 4> distances;  // of the samples, row by row
  std::array<glm::vec4, 4> values;

  // Where a pixel stands between the samples; those of the last row and column are its own.
  [[nodiscard]] float share_right(int x, const Film& film) const {
    return share(x - x0, std::min(x1, film.width - 1) - x0);
  }
  [[nodiscard]] float share_down(int y, const Film& film) const {
    return share(y - y0, std::min(y1, film.height - 1) - y0);
  }

 private:
  static float share(int part, int whole) {
    return static_cast<float>(part) / static_cast<float>(std::max(whole, 1));
  }
};

Cell cell_at(const AirlightSamples& samples, int column, int row) {
  const Film& film = samples.frame().film;
  const int beside = std::min(column + 1, samples.film().width - 1);
  const int below = std::min(row + 1, samples.film().height - 1);
  Cell cell{column,
            row,
            samples.x(column),
            samples.y(row),
            column + 2 >= samples.film().width ? film.width : samples.x(beside),
            row + 2 >= samples.film().height ? film.height : samples.y(below),
            CellRow::Kind::uneven,
            {samples.distance(column, row), samples.distance(beside, row),
             samples.distance(column, below), samples.distance(beside, below)},
            {samples.value(column, row), samples.value(beside, row), samples.value(column, below),
             samples.value(beside, below)}};
  const bool straight =
      std::max({samples.curvature(column, row), samples.curvature(beside, row),
                samples.curvature(column, below), samples.curvature(beside, below)}) <= 1.0f;
  const auto finite =
      std::ranges::count_if(cell.distances, [](float t) { return std::isfinite(t); });
  if (straight && finite == 0) cell.kind = CellRow::Kind::open;
  if (straight && finite == 4) cell.kind = CellRow::Kind::solid;
  return cell;
}

// The pixels of a cell, one by one.
class CellPixels {
 public:
  CellPixels(const AirlightSamples& samples, const Cell& cell, float tolerance)
      : samples_(samples), cell_(cell), tolerance_(tolerance) {}

  // None if the samples do not tell.
  std::optional<glm::vec4> at(int x, int y) {
    const Film& film = samples_.frame().film;
    const float fx = cell_.share_right(x, film);
    const float fy = cell_.share_down(y, film);
    const float distance =
        samples_.frame().depth[static_cast<std::size_t>(y) * static_cast<std::size_t>(film.width) +
                               static_cast<std::size_t>(x)];
    const auto mix = [&](const auto& four) {
      const auto left = four[0] + fy * (four[2] - four[0]);
      const auto right = four[1] + fy * (four[3] - four[1]);
      return left + fx * (right - left);
    };
    const bool on_sample = (fx == 0.0f || fx == 1.0f) && (fy == 0.0f || fy == 1.0f);
    const bool level = cell_.kind == CellRow::Kind::solid
                           ? std::abs(distance - mix(cell_.distances)) <= tolerance_
                           : cell_.kind == CellRow::Kind::open && !std::isfinite(distance);
    if (on_sample || level) return mix(cell_.values);
    return of_surface(x, y, distance,
                      {(1.0f - fx) * (1.0f - fy), fx * (1.0f - fy), (1.0f - fx) * fy, fx * fy});
  }

 private:
  // From those samples whose surface the pixel is on; `shares` are the samples'.
  std::optional<glm::vec4> of_surface(int x, int y, float distance,
                                      const std::array<float, 4>& shares) {
    if (!corners_) find_corners();
    float share = 0.0f;
    glm::vec4 sum(0.0f);
    for (std::size_t k = 0; k < 4; ++k) {
      const AirlightSamples::Surroundings& corner = (*corners_)[k];
      if (!corner.known || !corner.show(x, y, distance, tolerance_)) continue;
      share += shares[k];
      sum += shares[k] * corner.value_at(x, y);
    }
    if (share < min_surface_share) return std::nullopt;
    return sum / share;
  }

  void find_corners() {
    corners_.emplace();
    for (int k = 0; k < 4; ++k) {
      (*corners_)[static_cast<std::size_t>(k)] =
          samples_.surroundings(std::min(cell_.column + k % 2, samples_.film().width - 1),
                                std::min(cell_.row + k / 2, samples_.film().height - 1));
    }
  }

  const AirlightSamples& samples_;
  const Cell& cell_;
  float tolerance_;
  std::optional<std::array<AirlightSamples::Surroundings, 4>> corners_;  // row by row
};

// The cells between two rows of a tile's samples.
class Cells {
 public:
  Cells(const AirlightSamples& samples, int begin, int end, int row) : samples_(samples) {
    for (int column = begin; column < end; ++column) {
      const Cell& cell = cells_[count_] = cell_at(samples, column, row);
      kinds_[count_] = cell.kind;
      above_[count_] = cell.distances[0];
      below_[count_] = cell.distances[2];
      ++count_;
      above_[count_] = cell.distances[1];
      below_[count_] = cell.distances[3];
      // The last cell of a film may be as wide between samples that are nearer.
      if (cell.x1 - cell.x0 == 4 && samples.x(column + 1) - cell.x0 == 4) wide_ = count_;
    }
    in_vectors_ = {std::span(kinds_).first(wide_), &samples.value(begin, row),
                   &samples.value(begin, std::min(row + 1, samples.film().height - 1)),
                   above_.data(), below_.data()};
  }

  void upsample(float tolerance, Frame& frame, const std::function<void(int, int)>& exact) const {
    if (count_ == 0) return;
    const Cell& first = cells_[0];
    const auto pixel = [&](int x, int y) {
      return static_cast<std::size_t>(y) * static_cast<std::size_t>(frame.film.width) +
             static_cast<std::size_t>(x);
    };
    std::array<std::uint32_t, 4> done{};
    for (int y = first.y0; y < first.y1 && wide_ > 0; ++y) {
      const std::size_t at = pixel(first.x0, y);
      done[static_cast<std::size_t>(y - first.y0)] = interpolate_cells(
          in_vectors_, first.share_down(y, frame.film), tolerance, &frame.depth[at],
          &frame.airlight[3 * at], &frame.transmittance[3 * at]);
    }
    for (std::size_t i = 0; i < count_; ++i) {
      const Cell& cell = cells_[i];
      CellPixels pixels(samples_, cell, tolerance);
      for (int y = cell.y0; y < cell.y1; ++y) {
        if ((done[static_cast<std::size_t>(y - cell.y0)] >> i & 1) != 0) continue;
        for (int x = cell.x0; x < cell.x1; ++x) {
          if (const std::optional<glm::vec4> value = pixels.at(x, y)) {
            set_airlight(frame, pixel(x, y), *value);
          } else {
            exact(x, y);
          }
        }
      }
    }
  }

 private:
  const AirlightSamples& samples_;
  std::size_t count_ = 0;
  std::size_t wide_ = 0;  // so many are four pixels wide between samples four apart
  std::array<Cell, Tiles::width> cells_;
  std::array<CellRow::Kind, Tiles::width> kinds_;
  std::array<float, Tiles::width + 1> above_, below_;
  CellRow in_vectors_;
};

}  // namespace

void upsample(const AirlightSamples& samples, const CameraRays::PixelRectangle& tile,
              float tolerance, std::span<const glm::ivec2> exact_pixels, Frame& frame,
              const std::function<void(int x, int y)>& exact) {
  const int last_column = std::max(samples.film().width - 1, 1);
  const int last_row = std::max(samples.film().height - 1, 1);
  const auto unless_listed = [&](int x, int y) {
    if (std::ranges::find(exact_pixels, glm::ivec2(x, y)) == exact_pixels.end()) exact(x, y);
  };
  for (int row = tile.y0; row < std::min(tile.y1, last_row); ++row) {
    const Cells cells(samples, tile.x0, std::min(tile.x1, last_column), row);
    if (exact_pixels.empty()) {
      cells.upsample(tolerance, frame, exact);
    } else {
      cells.upsample(tolerance, frame, unless_listed);
    }
  }
  for (const glm::ivec2& pixel : exact_pixels) {
    if (!samples.is_sample(pixel)) exact(pixel.x, pixel.y);
  }
}

}  // namespace brume
