#pragma once

#include <span>

#include "render/cpu/light_table.h"
#include "render/cpu/visibility.h"
#include "render/medium_index.h"
#include "render/settings.h"

namespace brume {

// The light that surfaces send to the eye: reflection of point lights by brdf(), with cast shadows
// and with the medium's attenuation exp(-T(s, p)) on the way from the light. What the medium takes
// between surface and eye is left to the compositing (eq. 29).

struct SurfaceLight {
  PointLight light;
  const LightTable* table = nullptr;  // where T(s, p) is taken from; null: it is summed exactly
};

// radiance[k] receives the RGB radiance of points[k], those of a tile. Returns the number of
// Gaussian x path pairs evaluated. Thread-safe.
std::uint64_t surface_radiance(const MediumIndex& medium, const Visibility& visibility,
                               std::span<const SurfaceLight> lights,
                               std::span<const SurfacePoint> points,
                               Settings::Arithmetic arithmetic, std::span<glm::vec3> radiance);

}  // namespace brume
