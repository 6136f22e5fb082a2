#include "render/geometry/tiles.h"

#include <tbb/parallel_for.h>

#include <numeric>
#include <utility>

namespace brume {
namespace {

// Parts in which Gaussians are sorted into tiles: enough for the threads, and each worth a task.
constexpr std::size_t max_parts = 32;
constexpr std::size_t min_part = 1024;

}  // namespace

Film sample_film(const Film& film, int scale) {
  return {(film.width + scale - 2) / scale + 1, (film.height + scale - 2) / scale + 1};
}

Tiles::Tiles(const Film& film)
    : film_(film),
      columns_((film.width + width - 1) / width),
      rows_((film.height + height - 1) / height) {}

CameraRays::PixelRectangle Tiles::rectangle(std::size_t tile) const {
  const int x = static_cast<int>(tile % static_cast<std::size_t>(columns_)) * width;
  const int y = static_cast<int>(tile / static_cast<std::size_t>(columns_)) * height;
  return {x, y, std::min(x + width, film_.width), std::min(y + height, film_.height)};
}

Tiles::Lists Tiles::lists(const MediumIndex& medium, const CameraRays& rays, int scale,
                          std::size_t entry_limit) const {
  // Whether there are too many entries is asked of the whole film: a region has the same lists.
  const Tiles whole(sample_film({rays.whole_size().x, rays.whole_size().y}, scale));
  const glm::ivec2 first = rays.first_pixel() / (scale * glm::ivec2(width, height));
  // In tiles: [x0, x1) x [y0, y1) per Gaussian.
  std::vector<CameraRays::PixelRectangle> bounds(medium.size());
  std::vector<std::uint8_t> is_seen(medium.size(), 0);  // by any ray of the whole film
  // Gaussians in consecutive parts, each with its number of entries per tile.
  const std::size_t part_size = std::max(medium.size() / max_parts + 1, min_part);
  const std::size_t parts = (medium.size() + part_size - 1) / part_size;
  std::vector<std::vector<std::size_t>> next(parts);
  std::vector<std::size_t> used(parts, 0);
  std::vector<std::size_t> entries(parts, 0);  // on the whole film
  const auto each_of = [&](std::size_t part, auto visit) {
    const std::size_t end = std::min((part + 1) * part_size, medium.size());
    for (std::size_t i = part * part_size; i < end; ++i) visit(i);
  };
  tbb::parallel_for(std::size_t{0}, parts, [&](std::size_t part) {
    each_of(part, [&](std::size_t i) {
      if (!(medium.cutoff_radii()[i] > 0.0)) return;
      const auto b = rays.bounds_on_whole(medium.gaussians()[i], medium.view_cutoff_radius(i));
      if (b.empty()) return;
      // A ray of the last column or row may lie slightly before its grid position.
      const CameraRays::PixelRectangle on_whole{
          b.x0 / scale / width, b.y0 / scale / height,
          std::min((b.x1 + scale - 2) / scale / width + 1, whole.columns_),
          std::min((b.y1 + scale - 2) / scale / height + 1, whole.rows_)};
      if (on_whole.empty()) return;
      is_seen[i] = 1;
      entries[part] += static_cast<std::size_t>(on_whole.x1 - on_whole.x0) *
                       static_cast<std::size_t>(on_whole.y1 - on_whole.y0);
      bounds[i] = {std::max(on_whole.x0 - first.x, 0), std::max(on_whole.y0 - first.y, 0),
                   std::min(on_whole.x1 - first.x, columns_),
                   std::min(on_whole.y1 - first.y, rows_)};
      if (!bounds[i].empty()) ++used[part];
    });
  });

  Lists lists;
  lists.used = std::reduce(used.begin(), used.end());
  if (std::reduce(entries.begin(), entries.end()) > entry_limit) {
    for (std::uint32_t i = 0; i < medium.size(); ++i) {
      if (is_seen[i] != 0) lists.gaussians.push_back(i);
    }
    return lists;
  }
  const auto each_tile = [&](const CameraRays::PixelRectangle& b, auto visit) {
    for (int y = b.y0; y < b.y1; ++y) {
      for (int x = b.x0; x < b.x1; ++x) {
        visit(static_cast<std::size_t>(y) * static_cast<std::size_t>(columns_) +
              static_cast<std::size_t>(x));
      }
    }
  };
  tbb::parallel_for(std::size_t{0}, parts, [&](std::size_t part) {
    next[part].assign(count(), 0);
    each_of(part, [&](std::size_t i) {
      each_tile(bounds[i], [&](std::size_t tile) { ++next[part][tile]; });
    });
  });
  // Where the entries of each part begin.
  lists.offsets.assign(count() + 1, 0);
  std::size_t sum = 0;
  for (std::size_t tile = 0; tile < count(); ++tile) {
    lists.offsets[tile] = sum;
    for (std::vector<std::size_t>& of_part : next) {
      sum += std::exchange(of_part[tile], sum);
    }
  }
  lists.offsets.back() = sum;
  lists.gaussians.resize(sum);
  tbb::parallel_for(std::size_t{0}, parts, [&](std::size_t part) {
    each_of(part, [&](std::size_t i) {
      each_tile(bounds[i], [&](std::size_t tile) {
        lists.gaussians[next[part][tile]++] = static_cast<std::uint32_t>(i);
      });
    });
  });
  return lists;
}

}  // namespace brume
