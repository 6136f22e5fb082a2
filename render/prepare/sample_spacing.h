#pragma once

#include "brume/scene.h"
#include "render/settings.h"

namespace brume {

// The settings, with airlight_scale 1 where many Gaussians are smaller on the film than the spacing
// of its samples: between those hardly a pixel can be interpolated, and the tiles of samples, wider
// than those of pixels, only list more of them. Depends on scene, camera and film alone.
Settings with_useful_spacing(const Scene& scene, const Camera& camera, const Film& film,
                             const Settings& settings);

}  // namespace brume
