#include "render/gl/profile_maps.h"

#include <algorithm>
#include <cstddef>

namespace brume::gl {
namespace {

constexpr int map_side = PhotometricProfile::side;
// Columns of maps: 32 rows of them hold one for each light that a scene may have, in 8224 texels a
// side.
constexpr int columns = 32;

glm::ivec2 place_of(std::size_t index) {
  const auto i = static_cast<int>(index);
  return {i % columns * map_side, i / columns * map_side};
}

}  // namespace

void ProfileMaps::upload(std::span<const SlicedLight> lights) {
  std::vector<std::shared_ptr<const PhotometricProfile>> profiles;
  for (const SlicedLight& light : lights) {
    const auto& profile = light.falloff.profile();
    if (profile && std::ranges::find(profiles, profile) == profiles.end()) {
      profiles.push_back(profile);
    }
  }
  if (profiles == profiles_) return;
  profiles_ = profiles;
  if (profiles_.empty()) {
    texture_.release();
    return;
  }
  const glm::ivec2 size = place_of(std::min<std::size_t>(profiles_.size(), columns) - 1) +
                          glm::ivec2(map_side, place_of(profiles_.size() - 1).y + map_side);
  std::vector<float> texels(static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y));
  for (std::size_t i = 0; i < profiles_.size(); ++i) {
    const glm::ivec2 at = place_of(i);
    for (int row = 0; row < map_side; ++row) {
      const auto first_value =
          profiles_[i]->map().subspan(static_cast<std::size_t>(row) * map_side, map_side);
      std::ranges::copy(first_value, texels.begin() + (at.y + row) * std::ptrdiff_t{size.x} + at.x);
    }
  }
  texture_.reserve(Texture::Format::r32f, size);
  texture_.upload(texels);
}

glm::ivec2 ProfileMaps::place(const PhotometricProfile& profile) const {
  const auto found = std::ranges::find(profiles_, &profile, [](const auto& p) { return p.get(); });
  return place_of(static_cast<std::size_t>(found - profiles_.begin()));
}

void ProfileMaps::bind(const Program& program) {
  if (texture_.size().x == 0) texture_.reserve(Texture::Format::r32f, {1, 1});
  program.bind("profiles", texture_);
}

}  // namespace brume::gl
