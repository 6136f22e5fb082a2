#include "render/cpu/upsampling.h"

#include <cmath>
#include <glm/common.hpp>

#include "render/cpu/film_airlight.h"
#include "render/cpu/interpolation_kernels.h"
#include "render/geometry/tiles.h"

namespace brume {
namespace {

// Whether two distances may belong to one surface.
bool continuous(float a, float b) {
  return a == b || std::abs(a - b) < max_relative_step * std::min(a, b);
}

}  // namespace

AirlightSamples::AirlightSamples(const Frame& frame, int scale)
    : frame_(frame),
      scale_(scale),
      film_(sample_film(frame.film, scale)),
      values_(static_cast<std::size_t>(film_.width) * static_cast<std::size_t>(film_.height)),
      curvatures_(values_.size()) {}

double AirlightSamples::rms() const {
  double square = 0.0;
  for (const glm::vec4& v : values_) {
    square += static_cast<double>(v.x * v.x + v.y * v.y + v.z * v.z);
  }
  return std::sqrt(square / (3.0 * static_cast<double>(values_.size())));
}

void AirlightSamples::measure_curvatures(double tolerance, std::optional<double> rms_of_picture,
                                         const Job& job) {
  const double error = tolerance * (rms_of_picture ? *rms_of_picture : rms());
  const float light = 1.0f / static_cast<float>(std::max(error, 1e-30));
  inverse_tolerance_ = glm::vec4(light, light, light, static_cast<float>(1.0 / tolerance));
  job.parallel_for(static_cast<std::size_t>(film_.height), [&](std::size_t row_index) {
    const int row = static_cast<int>(row_index);
    for (int column = 0; column < film_.width; ++column) {
      // Curvature needs three samples per axis; with fewer, never interpolate.
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
  const glm::vec4 d =
      glm::abs(a + c - 2.0f * b) * inverse_tolerance_ * middle_per_second_difference;
  return std::max({d.x, d.y, d.z, d.w});
}

float AirlightSamples::curvature_along(int column, int row, int right, int down) const {
  // Ignore differences across a depth edge; the depth test rejects those pixels.
  const float t = distance(column, row);
  if (!continuous(distance(column - right, row - down), t) ||
      !continuous(t, distance(column + right, row + down))) {
    return 0.0f;
  }
  return curvature_of(value(column - right, row - down), value(column, row),
                      value(column + right, row + down));
}

struct AirlightSamples::Slope {
  bool is_valid = false;
  glm::vec4 value{0.0f};  // per pixel
  float distance = 0.0f;
};

// From three equally spaced samples in a row: this one in the center, or at an end where its
// surface ends.
AirlightSamples::Slope AirlightSamples::slope(int column, int row, int right, int down) const {
  const auto is_there = [&](int k) {
    const int c = column + k * right;
    const int r = row + k * down;
    return c >= 0 && r >= 0 && c < film_.width && r < film_.height;
  };
  const auto distance_at = [&](int k) { return distance(column + k * right, row + k * down); };
  const auto is_continuous = [&](int k0, int k1) {
    return is_there(k1) && continuous(distance_at(k0), distance_at(k1));
  };
  const bool has_previous = is_continuous(0, -1);
  const bool has_next = is_continuous(0, 1);
  const int center = has_previous && has_next ? 0 : has_previous ? -1 : 1;
  if (!has_previous && !has_next) return {};
  if (center != 0 && !is_continuous(center, 2 * center)) return {};
  const int last_column = column + (center + 1) * right;
  const int last_row = row + (center + 1) * down;
  // The last row and column may be spaced closer than `scale`.
  if (last_column * scale_ > x(last_column) || last_row * scale_ > y(last_row)) return {};

  const auto value_of = [&](int k) -> const glm::vec4& {
    return value(column + k * right, row + k * down);
  };
  const glm::vec4& a = value_of(center - 1);
  const glm::vec4& b = value_of(center);
  const glm::vec4& c = value_of(center + 1);
  if (!(curvature_of(a, b, c) <= max_local_fit_curvature)) return {};
  // Slope at this sample of the parabola through all three.
  const float per_pixel = 1.0f / static_cast<float>(scale_);
  const auto from_center = static_cast<float>(-center);
  Slope result{true, per_pixel * (0.5f * (c - a) + from_center * (a + c - 2.0f * b))};
  if (std::isfinite(distance_at(0))) {
    const float second_difference =
        distance_at(center - 1) + distance_at(center + 1) - 2.0f * distance_at(center);
    result.distance = per_pixel * (0.5f * (distance_at(center + 1) - distance_at(center - 1)) +
                                   from_center * second_difference);
  }
  return result;
}

AirlightSamples::LocalFit AirlightSamples::local_fit(int column, int row) const {
  const Slope along_x = slope(column, row, 1, 0);
  if (!along_x.is_valid) return {};
  const Slope along_y = slope(column, row, 0, 1);
  if (!along_y.is_valid) return {};
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

glm::vec4 AirlightSamples::LocalFit::value_at(int px, int py) const {
  const glm::vec4 v =
      value + static_cast<float>(px - x) * per_x + static_cast<float>(py - y) * per_y;
  return glm::max(glm::vec4(v.x, v.y, v.z, std::min(v.w, 1.0f)), 0.0f);
}

bool AirlightSamples::LocalFit::lies_on_surface(int px, int py, float pixel_distance,
                                                float tolerance) const {
  if (!std::isfinite(distance)) return !std::isfinite(pixel_distance);
  const float expected = distance + static_cast<float>(px - x) * distance_per_x +
                         static_cast<float>(py - y) * distance_per_y;
  return std::abs(pixel_distance - expected) <= tolerance;
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

  // Position of a pixel between the samples, 0 to 1; exactly 1 at the film's last row and column.
  [[nodiscard]] float fraction_right(int x, const Film& film) const {
    return fraction(x - x0, std::min(x1, film.width - 1) - x0);
  }
  [[nodiscard]] float fraction_down(int y, const Film& film) const {
    return fraction(y - y0, std::min(y1, film.height - 1) - y0);
  }

 private:
  static float fraction(int offset, int length) {
    return static_cast<float>(offset) / static_cast<float>(std::max(length, 1));
  }
};

Cell cell_at(const AirlightSamples& samples, int column, int row) {
  const Film& film = samples.frame().film;
  const int next_column = std::min(column + 1, samples.film().width - 1);
  const int next_row = std::min(row + 1, samples.film().height - 1);
  Cell cell{column,
            row,
            samples.x(column),
            samples.y(row),
            column + 2 >= samples.film().width ? film.width : samples.x(next_column),
            row + 2 >= samples.film().height ? film.height : samples.y(next_row),
            CellRow::Kind::uneven,
            {samples.distance(column, row), samples.distance(next_column, row),
             samples.distance(column, next_row), samples.distance(next_column, next_row)},
            {samples.value(column, row), samples.value(next_column, row),
             samples.value(column, next_row), samples.value(next_column, next_row)}};
  const bool is_linear =
      std::max({samples.curvature(column, row), samples.curvature(next_column, row),
                samples.curvature(column, next_row), samples.curvature(next_column, next_row)}) <=
      1.0f;
  const auto finite_count =
      std::ranges::count_if(cell.distances, [](float t) { return std::isfinite(t); });
  if (is_linear && finite_count == 0) cell.kind = CellRow::Kind::open;
  if (is_linear && finite_count == 4) cell.kind = CellRow::Kind::solid;
  return cell;
}

// The pixels of a cell, one by one.
class CellPixels {
 public:
  CellPixels(const AirlightSamples& samples, const Cell& cell, float tolerance)
      : samples_(samples), cell_(cell), tolerance_(tolerance) {}

  // nullopt if too little sample weight lies on the pixel's surface; evaluate it exactly.
  std::optional<glm::vec4> value(int x, int y) {
    const Film& film = samples_.frame().film;
    const float fx = cell_.fraction_right(x, film);
    const float fy = cell_.fraction_down(y, film);
    const float distance =
        samples_.frame().depth[static_cast<std::size_t>(y) * static_cast<std::size_t>(film.width) +
                               static_cast<std::size_t>(x)];
    const auto mix = [&](const auto& four) {
      const auto left = four[0] + fy * (four[2] - four[0]);
      const auto right = four[1] + fy * (four[3] - four[1]);
      return left + fx * (right - left);
    };
    const bool on_sample = (fx == 0.0f || fx == 1.0f) && (fy == 0.0f || fy == 1.0f);
    const bool on_interpolated_plane =
        cell_.kind == CellRow::Kind::solid
            ? std::abs(distance - mix(cell_.distances)) <= tolerance_
            : cell_.kind == CellRow::Kind::open && !std::isfinite(distance);
    if (on_sample || on_interpolated_plane) return mix(cell_.values);
    return of_surface(x, y, distance,
                      {(1.0f - fx) * (1.0f - fy), fx * (1.0f - fy), (1.0f - fx) * fy, fx * fy});
  }

 private:
  // From those samples whose surface the pixel is on; `weights` are bilinear.
  std::optional<glm::vec4> of_surface(int x, int y, float distance,
                                      const std::array<float, 4>& weights) {
    if (!corners_) find_corners();
    float weight_sum = 0.0f;
    glm::vec4 sum(0.0f);
    for (std::size_t k = 0; k < 4; ++k) {
      const AirlightSamples::LocalFit& corner = (*corners_)[k];
      if (!corner.is_valid || !corner.lies_on_surface(x, y, distance, tolerance_)) continue;
      weight_sum += weights[k];
      sum += weights[k] * corner.value_at(x, y);
    }
    if (weight_sum < min_surface_weight) return std::nullopt;
    return sum / weight_sum;
  }

  void find_corners() {
    corners_.emplace();
    for (int k = 0; k < 4; ++k) {
      (*corners_)[static_cast<std::size_t>(k)] =
          samples_.local_fit(std::min(cell_.column + k % 2, samples_.film().width - 1),
                             std::min(cell_.row + k / 2, samples_.film().height - 1));
    }
  }

  const AirlightSamples& samples_;
  const Cell& cell_;
  float tolerance_;
  std::optional<std::array<AirlightSamples::LocalFit, 4>> corners_;  // row by row
};

// The cells between two rows of a tile's samples.
class CellStrip {
 public:
  CellStrip(const AirlightSamples& samples, int begin, int end, int row) : samples_(samples) {
    for (int column = begin; column < end; ++column) {
      const Cell& cell = cells_[count_] = cell_at(samples, column, row);
      kinds_[count_] = cell.kind;
      above_[count_] = cell.distances[0];
      below_[count_] = cell.distances[2];
      ++count_;
      above_[count_] = cell.distances[1];
      below_[count_] = cell.distances[3];
      // The last cell of a film may be as wide although its samples are closer together.
      if (cell.x1 - cell.x0 == 4 && samples.x(column + 1) - cell.x0 == 4) wide_ = count_;
    }
    simd_row_ = {std::span(kinds_).first(wide_), &samples.value(begin, row),
                 &samples.value(begin, std::min(row + 1, samples.film().height - 1)), above_.data(),
                 below_.data()};
  }

  // `listed`: pixels that are evaluated in any case.
  void upsample(float tolerance, std::span<const glm::ivec2> listed, Frame& frame,
                Missing& missing) const {
    if (count_ == 0) return;
    const Cell& first = cells_[0];
    const auto pixel = [&](int x, int y) {
      return static_cast<std::size_t>(y) * static_cast<std::size_t>(frame.film.width) +
             static_cast<std::size_t>(x);
    };
    std::array<std::uint32_t, max_cell_rows> done{};
    for (int y = first.y0; y < first.y1 && wide_ > 0; ++y) {
      const std::size_t first_pixel = pixel(first.x0, y);
      done[static_cast<std::size_t>(y - first.y0)] = interpolate_cells(
          simd_row_, first.fraction_down(y, frame.film), tolerance, &frame.depth[first_pixel],
          &frame.airlight[3 * first_pixel], &frame.transmittance[3 * first_pixel]);
    }
    for (std::size_t i = 0; i < count_; ++i) {
      const Cell& cell = cells_[i];
      CellPixels pixels(samples_, cell, tolerance);
      const std::size_t first_missing = missing.pixels.size();
      for (int y = cell.y0; y < cell.y1; ++y) {
        if ((done[static_cast<std::size_t>(y - cell.y0)] >> i & 1) != 0) continue;
        for (int x = cell.x0; x < cell.x1; ++x) {
          if (const std::optional<glm::vec4> value = pixels.value(x, y)) {
            set_airlight(frame, pixel(x, y), *value);
          } else if (listed.empty() ||
                     std::ranges::find(listed, glm::ivec2(x, y)) == listed.end()) {
            missing.pixels.emplace_back(x, y);
          }
        }
      }
      if (listed.empty()) take_curved(cell, first_missing, missing);
    }
  }

 private:
  // Lists the missing pixels of a cell as a cell, if it may be worth to halve it.
  void take_curved(const Cell& cell, std::size_t first_missing, Missing& missing) const {
    const auto pixels = std::span(missing.pixels).subspan(first_missing);
    // In the film's last cells, samples may be closer together, and pixels more.
    const glm::ivec2 first(cell.x0, cell.y0);
    const glm::ivec2 opposite(samples_.x(cell.column + 1), samples_.y(cell.row + 1));
    if (pixels.size() <= static_cast<std::size_t>(halving_samples) ||
        opposite - first != glm::ivec2(4) || glm::ivec2(cell.x1, cell.y1) != opposite)
      return;
    const auto open = std::ranges::count_if(cell.distances, [](float t) { return std::isinf(t); });
    if (open != 0 && open != 4) return;
    CurvedCell curved{first, open == 4};
    for (const glm::ivec2& p : pixels) {
      curved.missing |= static_cast<std::uint16_t>(1 << (4 * (p.y - cell.y0) + p.x - cell.x0));
    }
    missing.cells.push_back(curved);
    missing.pixels.resize(first_missing);
  }

  // Samples are at most four pixels apart; the film's last cells have the border's row too.
  static constexpr std::size_t max_cell_rows = 5;

  const AirlightSamples& samples_;
  std::size_t count_ = 0;
  std::size_t wide_ =
      0;  // cells [0, wide_) are 4 pixels wide; only the film's last may be narrower
  std::array<Cell, Tiles::width> cells_;
  std::array<CellRow::Kind, Tiles::width> kinds_;
  std::array<float, Tiles::width + 1> above_, below_;
  CellRow simd_row_;
};

}  // namespace

Missing upsample(const AirlightSamples& samples, const CameraRays::PixelRectangle& tile,
                 float tolerance, std::span<const glm::ivec2> exact_pixels, Frame& frame) {
  const int last_column = std::max(samples.film().width - 1, 1);
  const int last_row = std::max(samples.film().height - 1, 1);
  Missing missing;
  for (int row = tile.y0; row < std::min(tile.y1, last_row); ++row) {
    const CellStrip cells(samples, tile.x0, std::min(tile.x1, last_column), row);
    cells.upsample(tolerance, exact_pixels, frame, missing);
  }
  for (const glm::ivec2& pixel : exact_pixels) {
    if (!samples.is_sample(pixel)) missing.pixels.push_back(pixel);
  }
  return missing;
}

}  // namespace brume
