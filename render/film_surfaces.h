#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "render/cpu/surfaces.h"
#include "render/cpu/triangle_radiance.h"
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
  TriangleRadiance* kept;  // null: everything is shaded

  // Sets the radiance that each pixel's hit sends to the eye, black where there is none; tile by
  // tile, and within a tile surface by surface. Returns the Gaussian x path pairs evaluated.
  // Finds out about some of the triangles that are not kept.
  std::uint64_t shade(std::span<const RasterPixel> hits, const Job& job,
                      std::span<glm::vec3> radiance) const;

 private:
  // Of a triangle that a pixel sees.
  struct Asked {
    std::uint32_t triangle;
    glm::vec3 direction;
  };
  [[nodiscard]] bool is_same_from_everywhere(std::int32_t surface) const;
  std::uint64_t find_out(std::vector<Asked> asked, const Job& job) const;
};

}  // namespace brume
