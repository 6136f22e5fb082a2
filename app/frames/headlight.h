#pragma once

#include "brume/scene.h"

namespace brume {

// Whether a scene has something to see and nothing lights it: no light is on, there is no
// environment, and nothing emits. Emitters and sequences count as emitting, since they may later.
bool is_unlit(const Scene& scene);

// A directional light the way a camera looks, which leaves no scene too bright or too dark: white
// diffuse surfaces that face it have a radiance of 1.
Light headlight(const Camera& camera);

}  // namespace brume
