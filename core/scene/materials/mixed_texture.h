#pragma once

#include <functional>
#include <glm/vec4.hpp>
#include <memory>

#include "core/scene/materials/texture.h"

namespace brume {

// Whether some texel is not opaque.
bool has_alpha(const Texture& texture);

// An sRGB-encoded image as large as the larger one, with mix(texel of a, texel of b), linear RGBA;
// null: white. One of them must be there.
std::shared_ptr<const Texture> mixed_texture(
    const Texture* a, const Texture* b,
    const std::function<glm::vec4(const glm::vec4&, const glm::vec4&)>& mix);

}  // namespace brume
