#include "render/geometry/tiles.h"
#include "core/scene/camera_rays.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <numeric>

namespace brume {

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
  // In tiles: [x0, x1) x [y0, y1) per Gaussian.
  std::vector<CameraRays::PixelRectangle> bounds(medium.size());
  tbb::parallel_for(std::size_t{0}, medium.size(), [&](std::size_t i) {
    if (!(medium.cutoff_radii()[i] > 0.0)) return;
    const auto b = rays.bounds(medium.gaussians()[i].b, medium.view_cutoff_radius(i));
    if (b.empty()) return;
    // A ray of the last column or row may lie slightly before its grid position.
    bounds[i] = {b.x0 / scale / width, b.y0 / scale / height,
                 std::min((b.x1 + scale - 2) / scale / width + 1, columns_),
                 std::min((b.y1 + scale - 2) / scale / height + 1, rows_)};
  });

  Lists lists;
  std::size_t entries = 0;
  for (std::uint32_t i = 0; i < bounds.size(); ++i) {
    const auto& b = bounds[i];
    if (b.empty()) continue;
    ++lists.used;
    entries += static_cast<std::size_t>(b.x1 - b.x0) * static_cast<std::size_t>(b.y1 - b.y0);
    lists.gaussians.push_back(i);
  }
  if (entries > entry_limit) return lists;
  lists.offsets.assign(count() + 1, 0);
  const auto each_tile = [&](const CameraRays::PixelRectangle& b, auto visit) {
    for (int y = b.y0; y < b.y1; ++y) {
      for (int x = b.x0; x < b.x1; ++x) {
        visit(static_cast<std::size_t>(y) * static_cast<std::size_t>(columns_) +
              static_cast<std::size_t>(x));
      }
    }
  };
  for (const auto& b : bounds) {
    each_tile(b, [&](std::size_t tile) { ++lists.offsets[tile + 1]; });
  }
  std::partial_sum(lists.offsets.begin(), lists.offsets.end(), lists.offsets.begin());
  lists.gaussians.resize(lists.offsets.back());
  std::vector<std::size_t> next(lists.offsets.begin(), lists.offsets.end() - 1);
  for (std::uint32_t i = 0; i < bounds.size(); ++i) {
    each_tile(bounds[i], [&](std::size_t tile) { lists.gaussians[next[tile]++] = i; });
  }
  return lists;
}

}  // namespace brume
