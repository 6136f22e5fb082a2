#include "render/film_airlight.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec4.hpp>
#include <limits>
#include <numeric>
#include <vector>

#include "render/cpu/interpolation_kernels.h"
#include "render/tiles.h"

namespace brume {
namespace {

// The pixels of a frame that one call of a method evaluates.
class Batch {
 public:
  // Adds to `pixel_pairs`.
  Batch(const CameraRays& rays, std::span<const SurfaceHit> hits, const Film& film,
        std::span<float> pixel_pairs)
      : rays_(rays), hits_(hits), film_(film), pixel_pairs_(pixel_pairs) {}

  [[nodiscard]] bool full() const { return count_ == Tiles::pixels; }

  void add(int x, int y) {
    pixels_[count_] = static_cast<std::size_t>(y) * static_cast<std::size_t>(film_.width) +
                      static_cast<std::size_t>(x);
    lengths_[count_] =
        hits_.empty() ? std::numeric_limits<double>::infinity() : hits_[pixels_[count_]].distance;
    directions_[count_++] = rays_.direction(x + 0.5, y + 0.5);
  }

  // Evaluates what was added, calls store(pixel index, airlight and transmittance) for each pixel
  // in order, and starts anew.
  template <class Store>
  std::uint64_t evaluate(std::span<const std::uint32_t> gaussians, const TileMethod& method,
                         Store store) {
    if (count_ == 0) return 0;
    const TileRays rays{rays_.eye(), std::span(directions_).first(count_),
                        std::span(lengths_).first(count_)};
    const std::uint64_t pairs = method(
        gaussians, rays, {std::span(airlight_).first(count_), std::span(depths_).first(count_)});
    // A tile's rays share their Gaussians.
    const float each = static_cast<float>(pairs) / static_cast<float>(count_);
    for (std::size_t k = 0; k < count_; ++k) {
      pixel_pairs_[pixels_[k]] += each;
      const glm::vec3& l = airlight_[k];
      store(pixels_[k], glm::vec4(finite(l.x), finite(l.y), finite(l.z),
                                  finite(static_cast<float>(std::exp(-depths_[k])))));
    }
    count_ = 0;
    return pairs;
  }

 private:
  const CameraRays& rays_;
  std::span<const SurfaceHit> hits_;
  Film film_;
  std::span<float> pixel_pairs_;
  std::size_t count_ = 0;
  std::array<std::size_t, Tiles::pixels> pixels_;
  std::array<glm::dvec3, Tiles::pixels> directions_;
  std::array<double, Tiles::pixels> lengths_;
  std::array<glm::vec3, Tiles::pixels> airlight_;
  std::array<double, Tiles::pixels> depths_;
};

void store(Frame& frame, std::size_t pixel, const glm::vec4& value) {
  for (std::size_t k = 0; k < 3; ++k) {
    frame.airlight[3 * pixel + k] = value[static_cast<int>(k)];
    frame.transmittance[3 * pixel + k] = value.w;
  }
}

// How far apart two distances may be to belong to one surface.
bool continuous(float a, float b) {
  return a == b || std::abs(a - b) < 0.05f * std::min(a, b);
}

// Every scale-th pixel of a film, the last column and row included.
class Samples {
 public:
  Samples(const Frame& frame, int scale)
      : frame_(frame),
        scale_(scale),
        film_{(frame.film.width + scale - 2) / scale + 1,
              (frame.film.height + scale - 2) / scale + 1},
        values_(static_cast<std::size_t>(film_.width) * static_cast<std::size_t>(film_.height)),
        bends_(values_.size()) {}

  [[nodiscard]] const Film& film() const { return film_; }
  [[nodiscard]] const Frame& frame() const { return frame_; }
  [[nodiscard]] int x(int column) const { return std::min(column * scale_, frame_.film.width - 1); }
  [[nodiscard]] int y(int row) const { return std::min(row * scale_, frame_.film.height - 1); }
  [[nodiscard]] std::size_t index(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(film_.width) +
           static_cast<std::size_t>(column);
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
  // How wrong linear interpolation beside a sample is, in units of what is tolerated.
  [[nodiscard]] float bend(int column, int row) const { return bends_[index(column, row)]; }

  // After all values are there.
  void measure_bends(double tolerance, const Job& job) {
    double square = 0.0;
    for (const glm::vec4& v : values_)
      square += static_cast<double>(v.x * v.x + v.y * v.y + v.z * v.z);
    const double rms = std::sqrt(square / (3.0 * static_cast<double>(values_.size())));
    const float light = 1.0f / static_cast<float>(std::max(tolerance * rms, 1e-30));
    const auto taken = static_cast<float>(1.0 / tolerance);
    const glm::vec4 unit(light, light, light, taken);
    job.each(static_cast<std::size_t>(film_.height), [&](std::size_t at) {
      const int row = static_cast<int>(at);
      for (int column = 0; column < film_.width; ++column) {
        // With fewer than three in a row nothing tells.
        float bend = film_.width < 3 || film_.height < 3 ? 2.0f : 0.0f;
        if (column > 0 && column + 1 < film_.width) {
          bend = std::max(bend,
                          second_difference(column - 1, row, column, row, column + 1, row, unit));
        }
        if (row > 0 && row + 1 < film_.height) {
          bend = std::max(bend,
                          second_difference(column, row - 1, column, row, column, row + 1, unit));
        }
        bends_[index(column, row)] = bend;
      }
    });
  }

 private:
  // An eighth of it is how far the middle between two samples is from the line between them.
  [[nodiscard]] float second_difference(int c0, int r0, int c1, int r1, int c2, int r2,
                                        const glm::vec4& unit) const {
    // Across the edge of an object, distances tell.
    const float t = distance(c1, r1);
    if (!continuous(distance(c0, r0), t) || !continuous(t, distance(c2, r2))) return 0.0f;
    const glm::vec4 d =
        glm::abs(value(c0, r0) + value(c2, r2) - 2.0f * value(c1, r1)) * unit * 0.125f;
    return std::max({d.x, d.y, d.z, d.w});
  }

  const Frame& frame_;
  int scale_;
  Film film_;
  std::vector<glm::vec4> values_;  // airlight RGB and transmittance
  std::vector<float> bends_;
};

// How much nearer or farther a surface may be than interpolated without the airlight telling: small
// against the Gaussians of the tile and the fog's mean free path.
float depth_tolerance(const MediumIndex& medium, std::span<const std::uint32_t> gaussians) {
  double least = std::numeric_limits<double>::infinity();
  for (const std::uint32_t i : gaussians) least = std::min(least, 0.05 / medium.gaussians()[i].a);
  const double b0 = medium.homogeneous_density();
  if (b0 > 0.0) least = std::min(least, 0.02 / b0);
  return static_cast<float>(least);
}

// A cell between four samples, and its pixels [x0, x1) x [y0, y1).
struct Cell {
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

Cell cell_at(const Samples& samples, int column, int row) {
  const Film& film = samples.frame().film;
  const int beside = std::min(column + 1, samples.film().width - 1);
  const int below = std::min(row + 1, samples.film().height - 1);
  Cell cell{samples.x(column),
            samples.y(row),
            column + 2 >= samples.film().width ? film.width : samples.x(beside),
            row + 2 >= samples.film().height ? film.height : samples.y(below),
            CellRow::Kind::uneven,
            {samples.distance(column, row), samples.distance(beside, row),
             samples.distance(column, below), samples.distance(beside, below)},
            {samples.value(column, row), samples.value(beside, row), samples.value(column, below),
             samples.value(beside, below)}};
  const bool straight =
      std::max({samples.bend(column, row), samples.bend(beside, row), samples.bend(column, below),
                samples.bend(beside, below)}) <= 1.0f;
  const auto finite =
      std::ranges::count_if(cell.distances, [](float t) { return std::isfinite(t); });
  if (straight && finite == 0) cell.kind = CellRow::Kind::open;
  if (straight && finite == 4) cell.kind = CellRow::Kind::solid;
  return cell;
}

// Interpolates row y of a cell's pixels; calls exact(x, y) for those that this is not good enough
// for.
template <class Exact>
void interpolate_row(const Cell& cell, int y, float tolerance, Frame& frame, Exact exact) {
  const float fy = cell.share_down(y, frame.film);
  const auto& [v00, v10, v01, v11] = cell.values;
  const auto& t = cell.distances;
  const glm::vec4 left = v00 + fy * (v01 - v00);
  const glm::vec4 right = v10 + fy * (v11 - v10);
  const float near = t[0] + fy * (t[2] - t[0]);
  const float far = t[1] + fy * (t[3] - t[1]);
  for (int x = cell.x0; x < cell.x1; ++x) {
    const float fx = cell.share_right(x, frame.film);
    const std::size_t pixel =
        static_cast<std::size_t>(y) * static_cast<std::size_t>(frame.film.width) +
        static_cast<std::size_t>(x);
    const bool on_sample = (fx == 0.0f || fx == 1.0f) && (fy == 0.0f || fy == 1.0f);
    const float distance = frame.depth[pixel];
    const bool level = cell.kind == CellRow::Kind::solid
                           ? std::abs(distance - (near + fx * (far - near))) <= tolerance
                           : cell.kind == CellRow::Kind::open && !std::isfinite(distance);
    if (on_sample || level) {
      store(frame, pixel, left + fx * (right - left));
    } else {
      exact(x, y);
    }
  }
}

// The cells between two rows of a tile's samples.
class Cells {
 public:
  Cells(const Samples& samples, int begin, int end, int row) {
    for (int column = begin; column < end; ++column) {
      const Cell& cell = cells_[count_] = cell_at(samples, column, row);
      kinds_[count_] = cell.kind;
      above_[count_] = cell.distances[0];
      below_[count_] = cell.distances[2];
      ++count_;
      above_[count_] = cell.distances[1];
      below_[count_] = cell.distances[3];
      if (cell.x1 - cell.x0 == 4) wide_ = count_;
    }
    in_vectors_ = {std::span(kinds_).first(wide_), &samples.value(begin, row),
                   &samples.value(begin, std::min(row + 1, samples.film().height - 1)),
                   above_.data(), below_.data()};
  }

  // Fills what can be interpolated; calls exact(x, y) for the other pixels, cell by cell.
  template <class Exact>
  void interpolate(float tolerance, Frame& frame, Exact exact) const {
    if (count_ == 0) return;
    const Cell& first = cells_[0];
    std::array<std::uint32_t, 4> done{};
    for (int y = first.y0; y < first.y1 && wide_ > 0; ++y) {
      const std::size_t pixel =
          static_cast<std::size_t>(y) * static_cast<std::size_t>(frame.film.width) +
          static_cast<std::size_t>(first.x0);
      done[static_cast<std::size_t>(y - first.y0)] = interpolate_cells(
          in_vectors_, first.share_down(y, frame.film), tolerance, &frame.depth[pixel],
          &frame.airlight[3 * pixel], &frame.transmittance[3 * pixel]);
    }
    for (std::size_t i = 0; i < count_; ++i) {
      for (int y = first.y0; y < first.y1; ++y) {
        if ((done[static_cast<std::size_t>(y - first.y0)] >> i & 1) != 0) continue;
        interpolate_row(cells_[i], y, tolerance, frame, exact);
      }
    }
  }

 private:
  std::size_t count_ = 0;
  std::size_t wide_ = 0;  // so many are four pixels wide, all but the last of a film
  std::array<Cell, Tiles::width> cells_;
  std::array<CellRow::Kind, Tiles::width> kinds_;
  std::array<float, Tiles::width + 1> above_, below_;
  CellRow in_vectors_;
};

// Interpolates the cells right of and below the samples of one tile; calls exact(x, y) for pixels
// that this is not good enough for.
template <class Exact>
void interpolate(const Samples& samples, const CameraRays::PixelRectangle& tile, float tolerance,
                 Frame& frame, Exact exact) {
  const int last_column = std::max(samples.film().width - 1, 1);
  const int last_row = std::max(samples.film().height - 1, 1);
  for (int row = tile.y0; row < std::min(tile.y1, last_row); ++row) {
    Cells(samples, tile.x0, std::min(tile.x1, last_column), row)
        .interpolate(tolerance, frame, exact);
  }
}

}  // namespace

FilmAirlight film_airlight(const MediumIndex& medium, const CameraRays& rays,
                           const Settings& settings, const TileMethod& method,
                           std::span<const SurfaceHit> hits, const Job& job, Frame& frame) {
  const int scale = settings.airlight_scale;
  Samples samples(frame, scale);
  const Tiles tiles(samples.film());
  const Tiles::Lists lists = tiles.lists(medium, rays, scale);
  FilmAirlight result;
  std::vector<float>& pixel_pairs = frame.statistics.pixel_pairs;
  pixel_pairs.assign(frame.depth.size(), 0.0f);
  result.gaussians_used = lists.used;
  std::atomic<std::uint64_t> pairs = 0;
  std::atomic<std::size_t> exact = 0;
  job.each_reported(tiles.count(), [&](std::size_t tile) {
    Batch batch(rays, hits, frame.film, pixel_pairs);
    std::array<std::size_t, Tiles::pixels> order;
    std::size_t count = 0;
    Tiles::each_pixel(tiles.rectangle(tile), [&](int column, int row) {
      order[count++] = samples.index(column, row);
      batch.add(samples.x(column), samples.y(row));
    });
    count = 0;
    pairs += batch.evaluate(lists.of(tile), method, [&](std::size_t pixel, const glm::vec4& value) {
      samples.value(order[count++]) = value;
      store(frame, pixel, value);
    });
    exact += count;
  });
  if (scale > 1 && !job.stop.stop_requested()) {
    samples.measure_bends(settings.upsampling_tolerance, job);
    job.each(tiles.count(), [&](std::size_t tile) {
      Batch batch(rays, hits, frame.film, pixel_pairs);
      const auto evaluate = [&] {
        pairs +=
            batch.evaluate(lists.of(tile), method, [&](std::size_t pixel, const glm::vec4& value) {
              ++exact;
              store(frame, pixel, value);
            });
      };
      interpolate(samples, tiles.rectangle(tile), depth_tolerance(medium, lists.of(tile)), frame,
                  [&](int x, int y) {
                    if (batch.full()) evaluate();
                    batch.add(x, y);
                  });
      evaluate();
    });
  }
  result.pairs = pairs;
  result.exact_pixels = exact;
  return result;
}

}  // namespace brume
