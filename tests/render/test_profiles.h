#pragma once

#include "brume/scene.h"

namespace brume {

// At every degree: the cosine of the polar angle below the luminaire, 0 above.
LightProfile cosine_profile();

// At every 5 degrees: two unlike lobes to the sides.
LightProfile lobed_profile(double rotation);

}  // namespace brume
