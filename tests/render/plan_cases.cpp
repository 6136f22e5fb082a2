#include "tests/render/plan_cases.h"

#include <gtest/gtest.h>

#include "tests/render/test_scenes.h"

namespace brume {
namespace {

using Part = PlanCase::Part;

const Surface& small_wall() {
  static const Surface surface = wall(-0.5, 1.0);
  return surface;
}

const std::shared_ptr<const RadianceMap>& small_sky() {
  static const std::shared_ptr<const RadianceMap> sky = constant_sky(1.0f);
  return sky;
}

// Each case with each value of the member.
template <class Value>
std::vector<PlanCase> varied(const std::vector<PlanCase>& cases, Value PlanCase::*member,
                             const std::vector<Value>& values) {
  std::vector<PlanCase> result;
  for (PlanCase each : cases) {
    for (const Value& value : values) {
      each.*member = value;
      result.push_back(each);
    }
  }
  return result;
}

// Without surfaces, and with ones that request each kind of transfer.
std::vector<PlanCase> with_surfaces() {
  using Transfer = Surface::Transfer;
  PlanCase walled;
  walled.surfaces = true;
  std::vector<PlanCase> cases = varied<Transfer>(
      {walled}, &PlanCase::transfer, {Transfer::none, Transfer::shadow, Transfer::interreflection});
  cases.emplace_back();
  return cases;
}

}  // namespace

Scene PlanCase::scene() const {
  Scene scene = seen_by({{0, 0, 4}, {0, 0, 0}, {0, 1, 0}, 40.0}, {16, 12});
  if (lights != Part::none) {
    scene.lights = {{{1, 2, 2}, {8, 8, 8}, {}}, {{-1, 2, 2}, {4, 4, 4}, {}}};
    if (lights == Part::idle) {
      scene.lights[0].on = false;
      scene.lights[1].intensity = glm::dvec3(0.0);
    }
  }
  if (sky != Part::none) {
    scene.environment.emplace().map = small_sky();
    if (sky == Part::idle) scene.environment->intensity = 0.0;
  }
  if (gaussians != Part::none) {
    const double density = gaussians == Part::active ? 0.5 : 0.0;
    scene.medium.append({{0.2, 0.1, 0.0}, 0.5, density});
    scene.medium.append({{-0.3, 0.0, 0.4}, 0.4, density});
  }
  if (fog) scene.medium.set_homogeneous_density(0.05);
  if (noise) scene.optics.noise.amplitude = 0.3;
  if (surfaces) {
    scene.surfaces = {small_wall()};
    scene.surfaces[0].transfer = transfer;
  }
  return scene;
}

Settings PlanCase::settings() const {
  Settings settings;
  settings.airlight = method;
  settings.airlight_scale = scale;
  settings.scattering = scattering;
  settings.slices = 8;
  settings.paths = 2;
  settings.reference_tolerance = 0.1;
  settings.optical_depth_table = {16, 8};
  settings.shadow_cells = 32;
  settings.source_grid = {300, 16};
  return settings;
}

std::string PlanCase::name() const {
  const auto part = [](const char* what, Part has) {
    return has == Part::none ? std::string()
                             : (has == Part::idle ? " idle " : " ") + std::string(what);
  };
  return to_string(method) + (scale > 1 ? " scale " + std::to_string(scale) : std::string()) +
         part("lights", lights) + part("sky", sky) + part("Gaussians", gaussians) +
         (scattering == Scattering::multiple ? " multiple" : "") + (fog ? " fog" : "") +
         (noise ? " noise" : "") + (surfaces ? " surfaces" : "") +
         (transfer != Surface::Transfer::none ? " transfer" : "");
}

std::vector<PlanCase> few_plan_cases(const std::vector<AirlightMethod>& methods) {
  const std::vector<Part> parts{Part::none, Part::active};
  std::vector<PlanCase> cases = with_surfaces();
  for (Part PlanCase::*part : {&PlanCase::lights, &PlanCase::sky, &PlanCase::gaussians}) {
    cases = varied(cases, part, parts);
  }
  cases = varied(cases, &PlanCase::fog, {false, true});
  cases = varied(cases, &PlanCase::scale, {4});
  cases = varied(cases, &PlanCase::scattering, {Scattering::multiple});
  return varied(cases, &PlanCase::method, methods);
}

std::string in_words(const std::vector<SkippedStage>& stages) {
  std::string words;
  for (const SkippedStage& skipped : stages) {
    words += std::string(to_string(skipped.stage)) + ": " + skipped.why + '\n';
  }
  return words;
}

void expect_planned(const FrameStatistics& statistics, const RenderPlan& plan,
                    const std::string& name) {
  StageSet ran;
  for (const StageTime& stage : statistics.stages) {
    EXPECT_FALSE(ran.has(stage.stage)) << to_string(stage.stage) << " twice, " << name;
    ran.add(stage.stage);
  }
  EXPECT_EQ(to_string(ran), to_string(plan.stages)) << name;
  EXPECT_EQ(in_words(statistics.skipped), in_words(plan.skipped)) << name;
  EXPECT_EQ(in_words(statistics.on_cpu), in_words(plan.on_cpu)) << name;
}

}  // namespace brume
