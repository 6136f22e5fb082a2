#pragma once

#include <span>

#include "render/cpu/visibility.h"
#include "render/medium_index.h"
#include "render/settings.h"

namespace brume {

// The light that surfaces send to the eye: reflection of point lights by brdf(), with cast shadows
// and with the medium's attenuation exp(-T(s, p)) on the way from the light. What the medium takes
// between surface and eye is left to the compositing (eq. 29).

// radiance[k] receives the RGB radiance of points[k], which should be close to each other (those of
// a tile). Returns the number of Gaussian x path pairs evaluated.
// Thread-safe.
std::uint64_t surface_radiance(const MediumIndex& medium, const Visibility& visibility,
                               std::span<const PointLight> lights,
                               std::span<const SurfacePoint> points,
                               Settings::Arithmetic arithmetic, std::span<glm::dvec3> radiance);

}  // namespace brume
