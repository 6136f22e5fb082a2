#pragma once

#include <optional>
#include <span>

#include "render/cpu/visibility.h"
#include "render/medium_index.h"
#include "render/settings.h"

namespace brume {

// The light that surfaces send to the eye: diffuse reflection of point lights, with cast shadows
// and with the medium's attenuation exp(-T(s, p)) on the way from the light. What the medium takes
// between surface and eye is left to the compositing (eq. 29).

// radiance[k] receives the RGB radiance of hits[k] (0 where nothing is hit). The hits should be
// close to each other (a tile). Returns the number of Gaussian x path pairs evaluated.
// Thread-safe.
std::uint64_t surface_radiance(const MediumIndex& medium, const Visibility& visibility,
                               std::span<const PointLight> lights,
                               std::span<const std::optional<SurfaceHit>> hits,
                               Settings::Arithmetic arithmetic, std::span<glm::dvec3> radiance);

}  // namespace brume
