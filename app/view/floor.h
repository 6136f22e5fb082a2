#pragma once

#include <glm/vec3.hpp>

#include "brume/mesh_arrays.h"
#include "brume/scene.h"

namespace brume {

class SurfacePicker;

// A run of a scene's surfaces.
struct SurfaceRange {
  std::size_t first = 0;
  std::size_t count = 0;

  [[nodiscard]] bool contains(std::size_t index) const { return index - first < count; }
};

// The box around these surfaces and their copies in the world.
MeshBox box_of(const Scene& scene, const SurfaceRange& surfaces);

// The height of the lowest point of surfaces, not counting some; 0 without any [u].
double lowest_surface(const Scene& scene, const SurfaceRange& except = {});
// The height of what lies below a point, not counting these surfaces: another one, or else
// lowest_surface() [u].
double floor_below(const Scene& scene, SurfacePicker& picker, const glm::dvec3& point,
                   const SurfaceRange& except = {});
// The height by which surfaces have to rise to stand on what lies below their middle [u].
double rise_to_floor(const Scene& scene, SurfacePicker& picker, const SurfaceRange& surfaces);

}  // namespace brume
