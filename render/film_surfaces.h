#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <span>

#include "render/cpu/surfaces.h"
#include "render/cpu/visibility.h"
#include "render/job.h"
#include "render/medium_index.h"
#include "render/prepared_shading.h"
#include "render/settings.h"

namespace brume {

// What the surfaces of a view are shaded from.
struct FilmSurfaces {
  std::span<const Surface> surfaces;
  const MediumIndex& medium;
  const Visibility& visibility;
  const PreparedShading& shading;
  const SurfaceLighting& lighting;
  const CameraRays& rays;
  Film film;
  Settings::Arithmetic arithmetic;

  // Sets the exitant radiance of each pixel's hit towards the eye, black where there is none.
  // Returns the Gaussian x path pairs evaluated.
  std::uint64_t shade(std::span<const RasterPixel> hits, const Job& job,
                      std::span<glm::vec3> radiance) const;
};

}  // namespace brume
