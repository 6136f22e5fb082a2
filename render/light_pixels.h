#pragma once

#include <glm/ext/vector_int2.hpp>
#include <span>
#include <vector>

#include "core/scene/camera.h"
#include "core/scene/scene.h"

namespace brume {

// The pixels of a film nearest to point lights in view. Airlight grows there like 1 / distance from
// where a light is seen, up to least_light_distance(); interpolation misses it, and a sample of
// the frame may.
//
// The `width` x `width` pixels, >= 1, whose centres are nearest to each light's film position, as
// far as they are on the film; of lights that shine and stand before the eye. Surfaces that hide a
// light are not asked. Each pixel once, in the film's order.
std::vector<glm::ivec2> light_pixels(std::span<const PointLight> lights, const CameraRays& rays,
                                     const Film& film, int width);

}  // namespace brume
