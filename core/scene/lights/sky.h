#pragma once

#include "brume/scene.h"

namespace brume {

// The sky of a scene whose sun is one of its lights, or else null.
const Sky* sun_of_sky(const Scene& scene);

// The unit direction to the sun of an environment's sky, which turns with the environment.
glm::dvec3 direction_to_sun(const Environment& environment, const Sky& sky);
// Sets elevation and azimuth for such a direction.
void aim_sun(const Environment& environment, const glm::dvec3& direction, Sky& sky);

// Puts the environment map of a scene's sky in its place, and its sun behind the lights, without
// keyframes: black where it has set, so that the lights stay as many. Maps of the last skies are
// kept; a new one takes 0.2 s. May be called by several threads at once.
void apply_sky(Scene& scene);

}  // namespace brume
