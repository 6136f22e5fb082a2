#include "render/render_plan.h"

#include <algorithm>

namespace brume {

RenderPlan::RenderPlan(const Scene& scene, AirlightMethod method) {
  const auto skip = [this](const char* stage, const std::string& why) {
    skipped.push_back({stage, why});
  };
  std::size_t off = 0;
  std::size_t black = 0;
  for (const PointLight& light : scene.lights) {
    if (!light.on) {
      ++off;
    } else if (light.intensity == glm::dvec3(0.0)) {
      ++black;
    } else {
      lights.push_back(light);
    }
  }
  surfaces = !scene.surfaces.empty();
  environment = scene.environment && scene.environment->intensity > 0.0;
  lit_surfaces = surfaces && (environment || !lights.empty());
  const auto densities = scene.medium.densities();
  gaussians = std::any_of(densities.begin(), densities.end(), [](double c) { return c > 0.0; });
  homogeneous = scene.medium.homogeneous_density() > 0.0;
  noise = gaussians && scene.optics.noise.amplitude > 0.0;
  const bool medium = gaussians || homogeneous;
  airlight = medium && (environment || !lights.empty());
  scattered_on_surfaces = medium && surfaces && !lights.empty();

  if (!surfaces) skip("visibility", "the scene has no surfaces");
  if (surfaces && !lit_surfaces) skip("surfaces", "nothing emits light");
  bool is_asked_for = false;
  for (const Surface& surface : scene.surfaces) {
    is_asked_for |= surface.transfer != Surface::Transfer::none;
    if (!needs_transfer(surface)) continue;
    const TransferRequest request = transfer_request(surface);
    if (std::ranges::find(transfers, request) == transfers.end()) transfers.push_back(request);
  }
  if (transfers.empty()) {
    skip("transfer", !is_asked_for   ? "no surface requests it"
                     : !lit_surfaces ? "nothing emits light"
                                     : "all light is direct");
  }
  if (lit_surfaces && !medium) skip("surface_scattering", "the medium is empty");
  if (!environment) {
    skip("environment", scene.environment ? "its intensity is 0" : "the scene has none");
  }
  // What goes before the airlight is the method's own.
  const char* const no_lights = "nothing emits light";
  const char* const no_medium = "the medium is empty";
  const char* const no_gaussians = lights.empty() ? no_lights : "the medium has no Gaussians";
  if (!gaussians || lights.empty()) {
    if (method == AirlightMethod::paper) {
      skip("light_depth", no_gaussians);
      skip("eye_depth", no_gaussians);
    } else if (method == AirlightMethod::sliced) {
      skip("light_table", no_gaussians);
    }
  }
  if (method == AirlightMethod::sliced && !scattered_on_surfaces) {
    skip("shadow_map", !surfaces        ? "the scene has no surfaces"
                       : lights.empty() ? no_lights
                                        : no_medium);
  }
  if (!homogeneous) skip("homogeneous", "the medium's homogeneous density is 0");
  if (!noise) {
    skip("noise", gaussians ? "its amplitude is 0" : "the medium has no Gaussians");
  }
  if (!airlight) {
    skip("airlight", medium ? no_lights : no_medium);
  }
  if (off > 0) skip("lights", "switched off: " + std::to_string(off));
  if (black > 0) skip("lights", std::to_string(black) + " lights of intensity 0");
}

// Direct light of point lights uses shadow rays.
bool RenderPlan::needs_transfer(const Surface& surface) const {
  if (surface.transfer == Surface::Transfer::none || !lit_surfaces) return false;
  return environment || scattered_on_surfaces ||
         surface.transfer == Surface::Transfer::interreflection;
}

}  // namespace brume
