#include "app/view/floor.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>

#include "app/view/surface_picker.h"
#include "core/math/infinity.h"
#include "core/scene/copies.h"

namespace brume {

double lowest_surface(const Scene& scene, const SurfaceRange& except) {
  double low = infinity;
  const std::vector<Surface> surfaces = with_placed_copies(scene.surfaces);
  for (std::size_t k = 0; k < surfaces.size(); ++k) {
    if (!except.contains(k)) low = std::min(low, world_box(surfaces[k]).low.y);
  }
  return std::isfinite(low) ? low : 0.0;
}

MeshBox box_of(const Scene& scene, const SurfaceRange& surfaces) {
  MeshBox box{glm::dvec3(infinity), glm::dvec3(-infinity)};
  const std::vector<Surface> placed = with_placed_copies(scene.surfaces);
  for (std::size_t k = 0; k < placed.size(); ++k) {
    if (!surfaces.contains(k)) continue;
    const MeshBox around = world_box(placed[k]);
    box.low = glm::min(box.low, around.low);
    box.high = glm::max(box.high, around.high);
  }
  return box;
}

double floor_below(const Scene& scene, SurfacePicker& picker, const glm::dvec3& point,
                   const SurfaceRange& except) {
  constexpr int max_hits = 100;  // of surfaces that do not count
  glm::dvec3 origin = point;
  for (int k = 0; k < max_hits; ++k) {
    const auto hit = picker.hit(origin, {0.0, -1.0, 0.0});
    if (!hit) break;
    if (!except.contains(picker.index_of(*hit))) return hit->position.y;
    origin.y = hit->position.y - 1e-9 * std::max(1.0, std::abs(hit->position.y));
  }
  return lowest_surface(scene, except);
}

double rise_to_floor(const Scene& scene, SurfacePicker& picker, const SurfaceRange& surfaces) {
  const MeshBox box = box_of(scene, surfaces);
  return floor_below(scene, picker, 0.5 * (box.low + box.high), surfaces) - box.low.y;
}

}  // namespace brume
