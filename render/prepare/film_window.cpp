#include "render/prepare/film_window.h"

#include <cstddef>
#include <glm/common.hpp>
#include <utility>
#include <vector>

#include "render/geometry/tiles.h"
#include "render/shading/film_surfaces.h"

namespace brume {
namespace {

// Pixels behind the last tile, so that its samples are not the film's last and rays between its
// pixels and the next ones are on the film.
constexpr int behind_last_tile = 2;

}  // namespace

FilmWindow::FilmWindow(const Film& film, const Settings& settings)
    : is_sampled_(settings.samples > 1 && settings.airlight != AirlightMethod::path),
      is_interpolated_(settings.airlight_scale > 1 && settings.airlight != AirlightMethod::path),
      tile_((is_interpolated_ ? settings.airlight_scale : 1) *
            glm::ivec2(Tiles::width, Tiles::height)),
      asked_(film),
      film_(film),
      region_{0, 0, film.width, film.height},
      shaded_(region_),
      first_(0),
      end_(glm::ivec2(film.width, film.height) / tile_ + 2) {
  if (!film.region) return;
  const glm::ivec2 whole(film.region->full_width, film.region->full_height);
  const glm::ivec2 begin(film.region->x, film.region->y);
  const glm::ivec2 end = begin + glm::ivec2(film.width, film.height);
  set_tiles(begin, end);
  const glm::ivec2 block(FilmSurfaces::block_width, FilmSurfaces::block_height);
  const int reach = SharedHighlights::max_reach;
  const glm::ivec2 shaded_begin =
      glm::max((first_ - complete()) * tile_ - reach, 0) / block * block;
  const glm::ivec2 shaded_end = ((end_ + complete()) * tile_ + reach + block - 1) / block * block;
  // Blocks are at least as large as tiles.
  const glm::ivec2 margin = (sliced() - complete()) * tile_;
  const glm::ivec2 start = glm::max(shaded_begin - margin, 0) / block * block;
  const glm::ivec2 last = glm::min(shaded_end + margin + behind_last_tile, whole);
  film_.width = last.x - start.x;
  film_.height = last.y - start.y;
  film_.region = FilmRegion{start.x, start.y, whole.x, whole.y};
  first_ -= start / tile_;
  end_ -= start / tile_;
  const auto on_film = [&](const glm::ivec2& low, const glm::ivec2& high) {
    const glm::ivec2 clipped = glm::min(high, whole);
    return CameraRays::PixelRectangle{low.x - start.x, low.y - start.y, clipped.x - start.x,
                                      clipped.y - start.y};
  };
  region_ = on_film(begin, end);
  shaded_ = on_film(shaded_begin, shaded_end);
}

void FilmWindow::set_tiles(const glm::ivec2& begin, const glm::ivec2& end) {
  // The last cells of a film have the pixels of its last samples, which may be in tiles behind.
  first_ = glm::max(begin - 1, 0) / tile_;
  end_ = (end + tile_ - 1) / tile_;
}

FilmWindow FilmWindow::around(const CameraRays::PixelRectangle& pixels) const {
  FilmWindow part = *this;
  part.set_tiles({pixels.x0, pixels.y0}, {pixels.x1, pixels.y1});
  return part;
}

bool FilmWindow::is_within(int tiles, const glm::ivec2& tile) const {
  return tile.x >= first_.x - tiles && tile.x < end_.x + tiles && tile.y >= first_.y - tiles &&
         tile.y < end_.y + tiles;
}

Frame FilmWindow::cut(Frame frame) const {
  frame.film = asked_;
  if (film_ == asked_) return frame;
  const auto cut_layer = [this](std::vector<float>& layer, int channels) {
    if (layer.empty()) return;
    std::vector<float> part;
    part.reserve(static_cast<std::size_t>(channels) * static_cast<std::size_t>(asked_.width) *
                 static_cast<std::size_t>(asked_.height));
    for (int y = region_.y0; y < region_.y1; ++y) {
      const auto row = layer.begin() + static_cast<std::ptrdiff_t>(channels) * y * film_.width;
      part.insert(part.end(), row + static_cast<std::ptrdiff_t>(channels) * region_.x0,
                  row + static_cast<std::ptrdiff_t>(channels) * region_.x1);
    }
    layer = std::move(part);
  };
  for (auto* layer : {&frame.beauty, &frame.beauty_at_centers}) cut_layer(*layer, 4);
  for (auto* layer :
       {&frame.airlight, &frame.transmittance, &frame.airlight_at_centers, &frame.background}) {
    cut_layer(*layer, 3);
  }
  cut_layer(frame.depth, 1);
  cut_layer(frame.statistics.pixel_pairs, 1);
  return frame;
}

}  // namespace brume
