// Random scenes: whatever the scene and the method, every value of every layer keeps the frame's
// promise. A failure names its seed; BRUME_FUZZ_SEED=n runs that scene alone. The renderer shows a
// sum that is not a number as black and asserts that there is none: only with assertions (presets
// debug and sanitize) does this test see those.

#include <gtest/gtest.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <bit>
#include <cstdlib>
#include <glm/gtc/quaternion.hpp>
#include <mutex>

#include "render/renderer.h"
#include "tests/random.h"
#include "tests/render/random_scene.h"
#include "tests/render/test_scenes.h"
#include "tools/bench/measure/hard_cases.h"

namespace brume {
namespace {

// By its bits, whatever the compiler makes of comparisons with NaN.
bool is_finite(float x) {
  return (std::bit_cast<std::uint32_t>(x) & 0x7f800000u) != 0x7f800000u;
}

bool is_distance(float x) {
  return std::bit_cast<std::uint32_t>(x) == 0x7f800000u || (is_finite(x) && x >= 0.0f);
}

std::string value_at(const char* layer, std::size_t i, float x) {
  return std::string(layer) + "[" + std::to_string(i) + "] = " + std::to_string(x);
}

// The first promise that the frame breaks, or nothing.
std::string broken_promise(const Frame& frame) {
  for (std::size_t i = 0; i < frame.beauty.size(); ++i) {
    const float x = frame.beauty[i];
    const float max_x = i % 4 == 3 ? 1.0f : std::numeric_limits<float>::max();
    if (!is_finite(x) || !(x >= 0.0f && x <= max_x)) return value_at("beauty", i, x);
  }
  for (std::size_t i = 0; i < frame.airlight.size(); ++i) {
    const float x = frame.airlight[i];
    if (!is_finite(x) || !(x >= 0.0f)) return value_at("airlight", i, x);
  }
  for (std::size_t i = 0; i < frame.transmittance.size(); ++i) {
    const float x = frame.transmittance[i];
    if (!is_finite(x) || !(x >= 0.0f && x <= 1.0f)) return value_at("transmittance", i, x);
  }
  for (std::size_t i = 0; i < frame.depth.size(); ++i) {
    if (!is_distance(frame.depth[i])) return value_at("depth", i, frame.depth[i]);
  }
  return {};
}

Settings on_one_thread(AirlightMethod method) {
  Settings settings;
  settings.airlight = method;
  settings.threads = 1;  // scenes run side by side
  settings.source_grid = {200, 12};
  return settings;
}

// These take a fraction of a millisecond on a scene of a few pixels.
std::vector<Settings> fast_methods(unsigned seed) {
  const Settings paper = on_one_thread(AirlightMethod::paper);
  Settings improved = paper;
  improved.paper = {.at_mean = true, .conserve_energy = true};
  Settings sliced = on_one_thread(AirlightMethod::sliced);
  sliced.slices = 4 + static_cast<int>(seed % 13);
  sliced.optical_depth_table = {8, 4};
  sliced.shadow_cells = 16;
  Settings coarse = seed % 2 == 0 ? sliced : improved;
  coarse.airlight_scale = seed % 4 < 2 ? 2 : 4;
  Settings multiple = sliced;
  multiple.scattering = Scattering::multiple;
  multiple.scattering_limits = {.degree = 3, .light_degree = 5, .sweeps = 4};
  std::vector<Settings> methods{paper, improved, sliced, coarse};
  if (seed % 16 == 0) methods.push_back(multiple);  // slower than all the others
  return methods;
}

// These take adaptive quadrature.
std::vector<Settings> slow_methods(unsigned seed) {
  Settings plain = on_one_thread(AirlightMethod::paper);
  plain.precision = Settings::Precision::plain_double;
  if (seed % 2 == 0) plain.paper = {.at_mean = true, .conserve_energy = true};
  return {plain, on_one_thread(AirlightMethod::reference)};
}

// In opaque media that absorb nothing a path takes milliseconds.
std::vector<Settings> path_methods(unsigned) {
  Settings path = on_one_thread(AirlightMethod::path);
  path.paths = 1;
  return {path};
}

// Every third scene has needles and flat layers, some of them as hot, or as dark, as they may be.
Scene fuzzed_scene(unsigned seed) {
  Scene scene = random_scene(seed);
  if (seed % 3 != 0) return scene;
  Random random(seed);
  scene.medium =
      scene.medium.changed(scene.medium.homogeneous_density(), [&random](Gaussian gaussian) {
        const glm::dvec3 q = random.point(1.0);
        gaussian.set_radii(
            gaussian.radius * glm::dvec3(1.0, random.power(-4.0, 0.0), random.power(-4.0, 0.0)),
            glm::normalize(glm::dquat(1.0, q.x, q.y, q.z)));
        if (random.uniform(0.0, 1.0) < 0.1) gaussian.optics.emission = glm::dvec3(1e20);
        if (random.uniform(0.0, 1.0) < 0.1) gaussian.optics.albedo = glm::dvec3(1e-6);
        return gaussian;
      });
  return scene;
}

std::string broken_promise(unsigned seed, std::span<const Settings> methods) {
  const Scene scene = fuzzed_scene(seed);
  Renderer renderer;  // what materials need is prepared once for all methods
  for (const Settings& settings : methods) {
    const std::string broken = broken_promise(render_frame(renderer, scene, settings));
    if (!broken.empty()) {
      return "BRUME_FUZZ_SEED=" + std::to_string(seed) + " " + airlight_name(settings) +
             (settings.precision == Settings::Precision::plain_double ? " in double" : "") + ": " +
             broken;
    }
  }
  return {};
}

template <class MethodsOf>
void run_scenes(unsigned first, unsigned count, MethodsOf methods_of) {
  if (const char* one = std::getenv("BRUME_FUZZ_SEED")) {
    first = static_cast<unsigned>(std::stoul(one));
    count = 1;
  }
  std::mutex mutex;
  std::vector<std::string> failures;
  tbb::parallel_for(first, first + count, [&](unsigned seed) {
    const std::string broken = broken_promise(seed, methods_of(seed));
    if (broken.empty()) return;
    const std::scoped_lock lock(mutex);
    failures.push_back(broken);
  });
  std::sort(failures.begin(), failures.end());
  for (const std::string& failure : failures) ADD_FAILURE() << failure;
}

TEST(Fuzz, FramesAreFiniteAndInTheirBounds) {
  run_scenes(1, random_cases(500), fast_methods);
}

TEST(Fuzz, FramesInDoubleAreFiniteAndInTheirBounds) {
  run_scenes(100'001, random_cases(16), slow_methods);
}

TEST(Fuzz, PathTracedFramesAreFiniteAndInTheirBounds) {
  run_scenes(200'001, random_cases(10), path_methods);
}

// The hard cases of resources/hard_cases, on the CPU, against what their pixels are, which was
// computed elsewhere to eleven digits.

const std::vector<HardCase>& hard_cases() {
  static const std::vector<HardCase> cases = load_hard_cases();
  return cases;
}

class HardCases : public testing::TestWithParam<HardCase> {};

TEST_P(HardCases, MatchTheGoldenValues) {
  const HardCase& hard_case = GetParam();
  const HardCaseErrors errors = measure_hard_case(hard_case);
  EXPECT_LE(errors.reference.airlight, hard_case_reference_bound);
  EXPECT_LE(errors.sliced.airlight, hard_case.bound);
  EXPECT_LE(errors.paper, hard_case_paper_bound);
  EXPECT_TRUE(errors.automatic.airlight <= hard_case_max_error || errors.automatic.is_told)
      << "auto is off by " << errors.automatic.airlight << " and does not tell";
  EXPECT_LE(errors.reference.transmittance, hard_case_transmittance_bound);
  EXPECT_LE(errors.sliced.transmittance, hard_case_transmittance_bound);
}

TEST_P(HardCases, AreFiniteInEveryLayer) {
  for (const AirlightMethod method : {AirlightMethod::paper, AirlightMethod::sliced,
                                      AirlightMethod::reference, AirlightMethod::path}) {
    for (const int scale : {1, 4}) {
      Settings settings;
      settings.airlight = method;
      settings.paths = 2;
      settings.airlight_scale = scale;
      expect_finite(render_frame(GetParam().scene, settings));
    }
  }
}

INSTANTIATE_TEST_SUITE_P(All, HardCases, testing::ValuesIn(hard_cases()), [](const auto& instance) {
  std::string name = instance.param.name;
  std::ranges::replace(name, '.', '_');
  return name;
});

TEST(HardCase, BoundsAboveOnePercentHaveAReason) {
  EXPECT_GE(hard_cases().size(), 40u);
  for (const HardCase& hard_case : hard_cases()) {
    EXPECT_EQ(hard_case.bound > 0.01, !hard_case.why.empty()) << hard_case.name;
    EXPECT_FALSE(hard_case.breaks.empty() || hard_case.remedy.empty()) << hard_case.name;
  }
}

}  // namespace

}  // namespace brume
