#pragma once

#include <glm/ext/vector_int2.hpp>
#include <memory>
#include <span>
#include <vector>

#include "core/scene/lights/intensity_map.h"
#include "render/gl/resources.h"
#include "render/slices/sliced_light.h"

namespace brume::gl {

// The maps of the lights' photometric profiles and pictures, side by side in one texture. Uploaded
// when there are others.
class ProfileMaps {
 public:
  void upload(std::span<const SlicedLight> lights);
  // The first texel of a map that a light of the last upload has.
  [[nodiscard]] glm::ivec2 place(const IntensityMap& map) const;
  // Binds them as `profiles`.
  void bind(const Program& program);

 private:
  [[nodiscard]] glm::ivec2 place_of(std::size_t index) const;

  std::vector<std::shared_ptr<const IntensityMap>> maps_;
  int side_ = 0;  // of the largest
  Texture texture_;
};

}  // namespace brume::gl
