#pragma once

#include <optional>
#include <string>

#include "brume/scene.h"

namespace brume {

// The share of light from far away that homogeneous fog lets through to the middle of the scene,
// where the fog ends (see FogExtent); else 1.
double transmittance_of_fog(const Scene& scene);

// A warning where that is less than half: how far the fog reaches follows from the size of what is
// in the scene.
std::optional<std::string> deep_fog_text(const Scene& scene);

}  // namespace brume
