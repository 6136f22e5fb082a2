#include "tools/bench/measure/plan_decisions.h"

#include <algorithm>
#include <cmath>
#include <memory>

#include "render/render_plan.h"
#include "render/renderer.h"
#include "render/transfer/transfer_store.h"
#include "tools/bench/measure/frames.h"
#include "tools/bench/scenes/benchmark_meshes.h"
#include "tools/bench/scenes/benchmark_scenes.h"

namespace brume {
namespace {

constexpr double next_to_nothing = 1e-9;

Surface surface_of(MeshBuilder& builder) {
  Surface surface;
  surface.mesh = builder.finish();
  return surface;
}

// Fills the view: any fog hides what is endlessly far.
void add_wall(MeshBuilder& builder) {
  builder.grid(12, 12, false,
               [](double u, double v) { return glm::dvec3(12.0 * u - 6.0, 10.0 * v - 5.0, -2.0); });
}

Surface wall() {
  MeshBuilder builder;
  add_wall(builder);
  return surface_of(builder);
}

Surface ball_and_wall() {
  MeshBuilder builder;
  builder.ellipsoid({0.3, -0.4, 0.2}, glm::dvec3(0.5), 24);
  add_wall(builder);
  return surface_of(builder);
}

// A triangle that no view or light ray hits.
Surface far_triangle() {
  MeshBuilder builder;
  builder.grid(2, 2, false,
               [](double u, double v) { return glm::dvec3(1e3 + u, 1e3 + v, 1e3 + u + v); });
  return surface_of(builder);
}

Medium homogeneous(double density) {
  Medium medium;
  medium.set_homogeneous_density(density);
  return medium;
}

std::shared_ptr<const TransferStore> transfers_of(const Scene& scene) {
  auto transfers = std::make_shared<TransferStore>();
  transfers->make(needed_transfers(scene), {});
  return transfers;
}

Settings settings_of(AirlightMethod method) {
  Settings settings;
  settings.airlight = method;
  return settings;
}

// The scene after a change.
template <class Change>
Scene with(Scene scene, Change change) {
  change(scene);
  return scene;
}

}  // namespace

std::vector<PlanDecision> plan_decisions() {
  using Method = AirlightMethod;
  Scene fog = cloud(30, 1.0);
  Scene solid = fog;
  solid.surfaces.push_back(ball_and_wall());
  Scene walled = fog;
  walled.surfaces.push_back(wall());
  Scene clear = solid;
  clear.medium = Medium();
  Scene shadowed = clear;
  shadowed.surfaces[0].transfer = Surface::Transfer::shadow;
  const Scene dark = with(solid, [](Scene& s) { s.lights.clear(); });
  const Scene haze = with(fog, [](Scene& s) { s.medium = homogeneous(0.1); });

  const auto light = [](double intensity) {
    return [intensity](Scene& s) {
      s.lights.push_back({{-2.0, 2.0, 1.0}, glm::dvec3(intensity), {}});
    };
  };
  const auto sky = [](double intensity) {
    return [intensity](Scene& s) {
      s.environment.emplace().map = gradient_sky();
      s.environment->intensity = intensity;
    };
  };
  const auto homogeneous_fog = [](double density) {
    return [density](Scene& s) { s.medium.set_homogeneous_density(density); };
  };
  const auto gaussian = [](double density) {
    return [density](Scene& s) { s.medium.append({{0.1, 0.2, 0.0}, 0.6, density}); };
  };
  const auto noise = [](double amplitude) {
    return [amplitude](Scene& s) {
      s.optics.noise.amplitude = amplitude;
      s.optics.noise.frequency = 4.0;
    };
  };
  const auto surface = [](const Surface& added) {
    return [added](Scene& s) { s.surfaces.push_back(added); };
  };
  const auto decision = [](Stage stage, Reason why, Method method, const Scene& scene,
                           const auto& made, const auto& needed) {
    return PlanDecision{stage, to_string(why, 1), method,
                        scene, with(scene, made), with(scene, needed)};
  };

  constexpr double little = next_to_nothing;
  std::vector<PlanDecision> all;
  for (const Stage stage : {Stage::visibility, Stage::shadow_map}) {
    all.push_back(decision(stage, Reason::no_surfaces, Method::sliced, fog, surface(far_triangle()),
                           surface(ball_and_wall())));
  }
  all.push_back(decision(Stage::surfaces, Reason::no_light, Method::sliced, dark, light(little),
                         light(10.0)));
  all.push_back(decision(Stage::transfer, Reason::only_direct_light, Method::sliced, shadowed,
                         homogeneous_fog(little), sky(1.0)));
  all.push_back(decision(Stage::surface_scattering, Reason::no_medium, Method::sliced, clear,
                         homogeneous_fog(little), homogeneous_fog(0.2)));
  all.push_back(decision(Stage::environment, Reason::no_environment, Method::sliced, solid,
                         sky(little), sky(1.0)));
  for (const Stage stage : {Stage::light_depth, Stage::eye_depth}) {
    all.push_back(decision(stage, Reason::no_gaussians, Method::paper, haze, gaussian(little),
                           gaussian(1.0)));
  }
  all.push_back(decision(Stage::light_table, Reason::no_gaussians, Method::sliced, haze,
                         gaussian(little), gaussian(1.0)));
  all.push_back(decision(Stage::homogeneous, Reason::no_homogeneous_density, Method::sliced, walled,
                         homogeneous_fog(little), homogeneous_fog(0.2)));
  all.push_back(
      decision(Stage::noise, Reason::no_noise, Method::sliced, fog, noise(little), noise(0.5)));
  all.push_back(decision(Stage::airlight, Reason::no_medium, Method::sliced, clear,
                         gaussian(little), gaussian(1.0)));
  const Scene off = with(with(solid, light(10.0)), [](Scene& s) { s.lights.back().on = false; });
  const auto switched_on = [](double intensity) {
    return [intensity](Scene& s) {
      s.lights.back().on = true;
      s.lights.back().intensity = glm::dvec3(intensity);
    };
  };
  all.push_back(decision(Stage::lights, Reason::lights_off, Method::sliced, off,
                         switched_on(little), switched_on(10.0)));
  return all;
}

Frame render_planned(const Scene& scene, AirlightMethod method) {
  Renderer renderer(transfers_of(scene));
  return render_frame(renderer, scene, settings_of(method));
}

double max_change(const Frame& a, const Frame& b, const Frame& scale) {
  const auto change = [&](const std::vector<float> Frame::*layer) {
    double difference = 0.0;
    double max_level = 0.0;
    for (std::size_t i = 0; i < (a.*layer).size(); ++i) {
      difference =
          std::max(difference, std::abs(static_cast<double>((a.*layer)[i]) - (b.*layer)[i]));
      max_level = std::max(max_level, static_cast<double>(std::abs((scale.*layer)[i])));
    }
    return max_level > 0.0 ? difference / max_level : difference;
  };
  return std::max(
      {change(&Frame::beauty), change(&Frame::airlight), change(&Frame::transmittance)});
}

PlanSaving measure_saving(const PlanDecision& decision, int frames) {
  const Settings settings = settings_of(decision.method);
  const auto cost = [&](const Scene& scene) {
    Renderer renderer(transfers_of(scene));
    static_cast<void>(renderer.render(scene, scene.camera, scene.film, settings));
    return moved_frames(renderer, scene, settings, frames).cpu_milliseconds;
  };
  const auto frame = [&](const Scene& scene) { return render_planned(scene, decision.method); };
  return {decision.stage, decision.why, cost(decision.left_out), cost(decision.made),
          max_change(frame(decision.left_out), frame(decision.made), frame(decision.needed))};
}

}  // namespace brume
