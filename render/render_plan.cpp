#include "render/render_plan.h"

#include <algorithm>

namespace brume {

RenderPlan::RenderPlan(const Scene& scene) {
  const auto skip = [this](const char* stage, const std::string& why) {
    skipped.push_back({stage, why});
  };
  for (const PointLight& light : scene.lights) {
    if (light.intensity != glm::dvec3(0.0)) lights.push_back(light);
  }
  surfaces = !scene.surfaces.empty();
  lit_surfaces = surfaces && !lights.empty();
  const auto densities = scene.medium.densities();
  gaussians = std::any_of(densities.begin(), densities.end(), [](double c) { return c > 0.0; });
  homogeneous = scene.medium.homogeneous_density() > 0.0;
  airlight = (gaussians || homogeneous) && !lights.empty();

  if (!surfaces) skip("visibility", "the scene has no surfaces");
  if (surfaces && !lit_surfaces) skip("surfaces", "no light shines");
  if (!gaussians) {
    skip("light_depth", "the medium has no Gaussians");
    skip("eye_depth", "the medium has no Gaussians");
  } else if (lights.empty()) {
    skip("light_depth", "no light shines");
    skip("eye_depth", "no light shines");
  }
  if (!homogeneous) skip("homogeneous", "the medium's homogeneous density is 0");
  if (!airlight) {
    skip("airlight", lights.empty() ? "no light shines" : "the medium is empty");
  }
  if (lights.size() < scene.lights.size()) {
    skip("lights", std::to_string(scene.lights.size() - lights.size()) + " lights of intensity 0");
  }
}

}  // namespace brume
