#include "core/scene/animation/animation.h"

#include <algorithm>
#include <glm/geometric.hpp>

#include "brume/keys.h"
#include "core/scene/animation/keys_in_domain.h"
#include "core/scene/imported_scene.h"

namespace brume {
namespace {

// Visits all values that a frame of the scene shows.
void visit_all(auto& scene, double& homogeneous_density, auto&& visit) {
  visit_keyed(scene.camera, scene.camera_keys, visit);
  visit_keyed_density(homogeneous_density, scene.density_keys, visit);
  visit_keyed(scene.optics, visit);
  visit_keyed(scene.optics.noise, visit);
  for (auto& group : scene.groups) visit_keyed(group, visit);
  for (auto& emitter : scene.emitters) visit_keyed(emitter, visit);
  for (auto& light : scene.lights) visit_keyed(light, visit);
  if (scene.environment) visit_keyed_environment(*scene.environment, visit);
  for (auto& surface : scene.surfaces) visit_keyed_surface(surface, visit);
}

// Those of imported scenes, which move by themselves.
void visit_imported(const Scene& scene, auto&& visit) {
  for (const Surface& surface : scene.surfaces) {
    if (!surface.imported) continue;
    for (const ImportedPart& part : surface.imported->parts) {
      visit(part.keys.translate);
      visit(part.keys.rotate);
      visit(part.keys.scale);
      if (part.deformation) visit(part.deformation->poses);
    }
  }
}

void keep_target_off_eye(Camera& camera) {
  if (glm::length(camera.target - camera.eye) > 0.0) return;
  // So far that it is another point, however far out both are.
  camera.target.z -= 1.0 + 1e-6 * glm::length(camera.eye);
}

}  // namespace

bool has_keys(const Scene& scene) {
  bool found = false;
  double unused = 0.0;
  const auto look = [&found](const char*, const auto&, const auto& keys, const NumberDomain&) {
    found = found || !keys.empty();
  };
  visit_all(scene, unused, look);
  for (const NamedCamera& camera : scene.cameras) visit_keyed(camera.camera, camera.keys, look);
  visit_imported(scene, [&found](const auto& keys) { found = found || keys.size() > 1; });
  return found;
}

double last_key_time(const Scene& scene) {
  double last = 0.0;
  double unused = 0.0;
  visit_all(scene, unused,
            [&last](const char*, const auto&, const auto& keys, const NumberDomain&) {
              if (!keys.empty()) last = std::max(last, keys.back().time);
            });
  visit_imported(scene, [&last](const auto& keys) {
    if (!keys.empty()) last = std::max(last, keys.back().time);
  });
  return last;
}

void apply_keys(Scene& scene, double time) {
  double homogeneous_density = scene.medium.homogeneous_density();
  const auto evaluate = [time](const char*, auto& value, const auto& keys,
                               const NumberDomain& domain) {
    if (!keys.empty()) value = value_at(keys, time, domain);
  };
  visit_all(scene, homogeneous_density, evaluate);
  scene.medium.set_homogeneous_density(homogeneous_density);
  keep_target_off_eye(scene.camera);
  for (NamedCamera& camera : scene.cameras) {
    visit_keyed(camera.camera, camera.keys, evaluate);
    keep_target_off_eye(camera.camera);
  }
}

void clear_keys(Scene& scene) {
  double unused = 0.0;
  visit_all(scene, unused,
            [](const char*, auto&, auto& keys, const NumberDomain&) { keys.clear(); });
}

}  // namespace brume
