#include "render/gl/slice_texture.h"

#include <algorithm>

#include "render/geometry/ray_range.h"
#include "render/gl/shader_constants.h"
#include "render/slices/slice_boundaries.h"

namespace brume::gl {

void SliceTexture::choose(Programs& programs, DeviceClock& clock, OpticalDepthTables& lights,
                          std::size_t light_count, int slices, TileLists& lists,
                          const FilmView& view, const FilmTextures& textures) {
  const glm::ivec2 tiles = lists.tiles();
  tiles_ = tiles;
  const auto tile_count = static_cast<std::size_t>(tiles.x) * static_cast<std::size_t>(tiles.y);
  const auto node_count =
      static_cast<std::size_t>(2 * tiles.x + 1) * static_cast<std::size_t>(2 * tiles.y + 1);
  stride_ = static_cast<int>(max_boundaries(slices, light_count, view.fog.density > 0.0f));
  const auto record = static_cast<std::size_t>(stride_) + 1;
  chosen_.reserve(tile_count * record * sizeof(float));
  const std::size_t rows = node_count * record / node_texture_width + 1;
  if (rows > node_texture_width) throw OutOfMemory("the slices do not fit into device memory");
  nodes_.reserve(Texture::Format::r32f, glm::ivec2(node_texture_width, static_cast<int>(rows)));

  clock.time(view.plan.medium_stage(), [&] {
    const Program& choose =
        programs.get("choose_slices", lists.defined() + ray_definitions(view.rays));
    set_rays(choose, view.rays);
    choose.set("film", glm::ivec2(view.film.width, view.film.height));
    choose.set("tiles", tiles);
    choose.set("scale", view.plan.settings.airlight_scale);
    choose.set("ray_end", static_cast<float>(std::min(view.ray_end, endless)));
    choose.set("light_count", static_cast<int>(light_count));
    choose.set("slices", slices);
    choose.set("per_light", slices_per_light(slices, light_count));
    set_fog(choose, view.fog);
    choose.set("stride", stride_);
    lights.bind(choose);
    lists.bind(choose);
    choose.bind("Chosen", chosen_);
    choose.bind("depths", textures.depth);
    choose.dispatch_linear(tile_count);

    const Program& merge = programs["merge_slices"];
    merge.set("tiles", tiles);
    merge.set("stride", stride_);
    merge.bind("Chosen", chosen_);
    merge.bind("slice_nodes", nodes_);
    merge.dispatch_linear(node_count);
  });
}

void SliceTexture::bind(const Program& program) const {
  program.set("stride", stride_);
  program.bind("slice_nodes", nodes_);
}

std::vector<std::vector<float>> SliceTexture::download_tiles() const {
  const std::size_t record = stride() + 1;
  std::vector<std::vector<float>> tiles(static_cast<std::size_t>(tiles_.x * tiles_.y));
  std::vector<float> values(tiles.size() * record);
  chosen_.download(std::span(values));
  for (std::size_t i = 0; i < tiles.size(); ++i) {
    const auto first = values.begin() + static_cast<std::ptrdiff_t>(i * record);
    tiles[i].assign(first + 1, first + 1 + static_cast<std::ptrdiff_t>(*first));
  }
  return tiles;
}

std::vector<std::vector<float>> SliceTexture::download_nodes() const {
  const std::size_t record = stride() + 1;
  std::vector<std::vector<float>> nodes(
      static_cast<std::size_t>((2 * tiles_.x + 1) * (2 * tiles_.y + 1)));
  std::vector<float> values(static_cast<std::size_t>(nodes_.size().x) *
                            static_cast<std::size_t>(nodes_.size().y));
  nodes_.download(std::span(values));
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const auto first = values.begin() + static_cast<std::ptrdiff_t>(i * record);
    if (*first > 0.0f) {
      nodes[i].assign(first + 1, first + static_cast<std::ptrdiff_t>(record));
    }
  }
  return nodes;
}

}  // namespace brume::gl
