#pragma once

#include <optional>
#include <string>

#include "brume/scene.h"

namespace brume {

// The share of light from far away that homogeneous fog lets through to the middle of the scene, of
// a scene with a directional light or an environment (see FogExtent); else 1.
double transmittance_of_fog(const Scene& scene);

// A warning where that is less than half. It says how far the fog reaches, and what would help.
std::optional<std::string> deep_fog_text(const Scene& scene);

}  // namespace brume
