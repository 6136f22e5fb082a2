#include "render/gl/profile_maps.h"

#include <algorithm>
#include <cstddef>

namespace brume::gl {
namespace {

// Texels of a row of maps: as many rows of those of profiles hold one for each light that a scene
// may have.
constexpr int row_length = 8224;

}  // namespace

glm::ivec2 ProfileMaps::place_of(std::size_t index) const {
  const auto i = static_cast<int>(index);
  const int columns = row_length / side_;
  return {i % columns * side_, i / columns * side_};
}

void ProfileMaps::upload(std::span<const SlicedLight> lights) {
  std::vector<std::shared_ptr<const IntensityMap>> maps;
  for (const SlicedLight& light : lights) {
    const auto& map = light.falloff.map();
    if (map && std::ranges::find(maps, map) == maps.end()) maps.push_back(map);
  }
  if (maps == maps_) return;
  maps_ = maps;
  side_ = 0;
  if (maps_.empty()) {
    texture_.release();
    return;
  }
  for (const auto& map : maps_) side_ = std::max(side_, map->side);
  const int columns = std::min(static_cast<int>(maps_.size()), row_length / side_);
  const glm::ivec2 size(columns * side_, place_of(maps_.size() - 1).y + side_);
  if (size.y > row_length) {
    throw OutOfMemory("the pictures in the lights' beams do not fit into a texture");
  }
  std::vector<float> texels(static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y));
  for (std::size_t i = 0; i < maps_.size(); ++i) {
    const IntensityMap& map = *maps_[i];
    const glm::ivec2 at = place_of(i);
    for (int row = 0; row < map.side; ++row) {
      std::ranges::copy(
          std::span(map.values)
              .subspan(static_cast<std::size_t>(row) * static_cast<std::size_t>(map.side),
                       static_cast<std::size_t>(map.side)),
          texels.begin() + (at.y + row) * std::ptrdiff_t{size.x} + at.x);
    }
  }
  texture_.reserve(Texture::Format::r32f, size);
  texture_.upload(texels);
}

glm::ivec2 ProfileMaps::place(const IntensityMap& map) const {
  const auto found = std::ranges::find(maps_, &map, [](const auto& p) { return p.get(); });
  return place_of(static_cast<std::size_t>(found - maps_.begin()));
}

void ProfileMaps::bind(const Program& program) {
  if (texture_.size().x == 0) texture_.reserve(Texture::Format::r32f, {1, 1});
  program.bind("profiles", texture_);
}

}  // namespace brume::gl
