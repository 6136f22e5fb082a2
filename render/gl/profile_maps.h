#pragma once

#include <glm/ext/vector_int2.hpp>
#include <memory>
#include <span>
#include <vector>

#include "core/scene/lights/photometric_profile.h"
#include "render/gl/resources.h"
#include "render/slices/sliced_light.h"

namespace brume::gl {

// The maps of the lights' photometric profiles, side by side in one texture. Uploaded when there
// are others.
class ProfileMaps {
 public:
  void upload(std::span<const SlicedLight> lights);
  // The first texel of a profile that a light of the last upload has.
  [[nodiscard]] glm::ivec2 place(const PhotometricProfile& profile) const;
  // Binds them as `profiles`.
  void bind(const Program& program);

 private:
  std::vector<std::shared_ptr<const PhotometricProfile>> profiles_;
  Texture texture_;
};

}  // namespace brume::gl
