#pragma once

#include <functional>
#include <glm/vec3.hpp>
#include <optional>
#include <vector>

#include "brume/scene.h"
#include "core/medium/splat.h"
#include "render/settings.h"
#include "render/transfer/transfer_store.h"
#include "render/util/job.h"

namespace brume {

// The display's values of linear radiance [W/(sr u^2)], RGB.
using ShowRadiance = std::function<glm::vec3(const glm::vec3&)>;

// The radiance of each Gaussian of a lit medium in all directions, so that any viewer of splats
// shows it as lit: along a line through its center in each of 28 directions the airlight of it
// alone, attenuated by itself on the way to the eye and by the whole medium on the way from the
// lights, over its opacity on that line; shown, and then projected onto spherical harmonics.
// Viewers attenuate it by what is in front of it. Lights, shadows, orders of scattering and
// emission are those of `sliced` with these settings; homogeneous fog has no splats and is left
// out, noise too. `transfers`: see Renderer. nullopt if stopped.
std::optional<std::vector<SplatColor>> bake_splats(const Scene& scene, const Settings& settings,
                                                   const ShowRadiance& show,
                                                   const TransferStore& transfers,
                                                   const Job& job = {});

}  // namespace brume
