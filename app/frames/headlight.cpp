#include "app/frames/headlight.h"

#include <algorithm>
#include <numbers>

#include "core/scene/lights/emitting_surfaces.h"

namespace brume {

bool is_unlit(const Scene& scene) {
  const bool is_empty = scene.surfaces.empty() && scene.medium.size() == 0;
  if (is_empty || scene.environment) return false;
  if (std::ranges::any_of(scene.lights, &Light::on)) return false;
  if (std::ranges::any_of(scene.surfaces, is_emissive)) return false;
  return scene.emitters.empty() && scene.sequences.empty() && !scene.medium.has_emission();
}

Light headlight(const Camera& camera) {
  return {.intensity = glm::dvec3(std::numbers::pi),
          .kind = light::Directional{camera.target - camera.eye}};
}

}  // namespace brume
