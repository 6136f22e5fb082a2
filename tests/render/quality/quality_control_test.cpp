#include "render/quality/quality_control.h"

#include <gtest/gtest.h>

#include <functional>

#include "render/quality/auto_quality.h"
#include "tests/render/test_scenes.h"

namespace brume {
namespace {

ErrorEstimate error_of(double high) {
  return {0.9 * high, 0.8 * high, high, 100};
}

// Frames with each step's settings would be measured to have these.
using ErrorOfStep = std::function<double(std::size_t)>;

double halving(std::size_t step, double first) {
  return first * std::pow(0.5, static_cast<double>(step));
}

// Renders and measures until nothing is due any more; the steps that were shown.
std::vector<std::size_t> steps_to_rest(QualityControl& control, const ErrorOfStep& error) {
  std::vector<std::size_t> shown;
  while (shown.size() < 100) {
    const std::size_t step = control.step();
    shown.push_back(step);
    control.record(Settings(control.settings()), error_of(error(step)), 10.0);
    if (control.step() == step) return shown;
  }
  ADD_FAILURE() << "it does not come to rest";
  return shown;
}

TEST(QualityControl, LadderIsOrderedByCost) {
  Settings settings;
  settings.reference_tolerance = 2e-4;
  const std::vector<Settings> ladder = quality_ladder(settings);
  const Scene scene = cloud_scene(100, 3.0);
  const Frame reference = render_frame(scene, [] {
    Settings exact;
    exact.airlight = AirlightMethod::reference;
    return exact;
  }());
  const auto error = [&](const Settings& tried) {
    return rel_rmse(render_frame(scene, tried).airlight, reference.airlight);
  };
  for (const Settings& step : ladder) EXPECT_EQ(step.reference_tolerance, 2e-4);
  EXPECT_LT(error(ladder.back()), 0.1 * error(ladder.front()));
}

TEST(QualityControl, RaisesQualityUntilTheBoundHolds) {
  QualityControl control;
  const std::size_t first = control.step();
  control.set_max_error(0.01);
  const std::vector<std::size_t> shown =
      steps_to_rest(control, [&](std::size_t step) { return halving(step - first, 0.07); });
  EXPECT_EQ(shown, (std::vector<std::size_t>{first, first + 1, first + 2, first + 3}));
  EXPECT_FALSE(control.is_exhausted());
}

TEST(QualityControl, LowersQualityWellBelowTheBound) {
  QualityControl control;
  const std::size_t first = control.step();
  control.set_max_error(0.05);
  EXPECT_EQ(steps_to_rest(control, [](std::size_t) { return 0.019; }).back(), 0u);
  control.reset();
  EXPECT_EQ(steps_to_rest(control, [](std::size_t) { return 0.021; }).back(), first);
}

// The step below was tried and broke the bound: not again.
TEST(QualityControl, DoesNotOscillate) {
  QualityControl control;
  const std::size_t first = control.step();
  control.set_max_error(0.1);
  const ErrorOfStep cliff = [&](std::size_t step) { return step < first ? 0.2 : 0.02; };
  EXPECT_EQ(steps_to_rest(control, cliff), (std::vector<std::size_t>{first, first - 1, first}));
  EXPECT_EQ(steps_to_rest(control, cliff), (std::vector<std::size_t>{first}));
}

// Whatever is measured, even nonsense.
TEST(QualityControl, ConvergesForAnyErrors) {
  const Scene scene = cloud_scene(10, 1.0);
  for (unsigned seed = 0; seed < 500; ++seed) {
    unsigned state = seed;
    QualityControl control;
    control.begin_frame(scene, scene.camera);
    for (int view = 0; view < 5; ++view) {
      Camera camera = scene.camera;
      camera.eye.x += view;
      control.begin_frame(scene, camera);
      std::vector<double> errors;
      for (std::size_t i = 0; i < control.trials().size(); ++i) {
        state = 1664525u * state + 1013904223u;
        errors.push_back(std::pow(10.0, -4.0 * state / 4294967296.0));
      }
      EXPECT_LE(steps_to_rest(control, [&](std::size_t step) { return errors[step]; }).size(),
                2 * errors.size());
    }
  }
}

TEST(QualityControl, ReportsAnUnreachableBound) {
  QualityControl control;
  control.set_max_error(0.01);
  EXPECT_EQ(steps_to_rest(control, [](std::size_t) { return 0.5; }).back(),
            control.trials().size() - 1);
  EXPECT_TRUE(control.is_exhausted());
  control.set_max_error(0.6);
  EXPECT_FALSE(control.is_exhausted());
}

// Where only the interval breaks the bound, and finer settings do not narrow it.
TEST(QualityControl, SettlesAtTheCheapestPossibleSettings) {
  QualityControl control;
  control.set_max_error(0.02);
  const std::size_t first = control.step();
  const auto record = [&] {
    const bool is_first = control.step() == first;
    control.record(Settings(control.settings()), {is_first ? 0.025 : 0.017, 0.011, 0.027, 96},
                   10.0);
  };
  for (int k = 0; k < 20; ++k) record();
  EXPECT_EQ(control.step(), first + 1);
  EXPECT_TRUE(control.is_exhausted());
  EXPECT_TRUE(control.may_keep_bound());
  record();
  EXPECT_EQ(control.step(), first + 1);
  control.set_max_error(0.03);
  EXPECT_FALSE(control.is_exhausted());
}

TEST(QualityControl, ANewBoundReusesMeasurements) {
  QualityControl control;
  control.set_max_error(0.01);
  const ErrorOfStep error = [](std::size_t step) { return halving(step, 0.3); };
  const std::size_t tight = steps_to_rest(control, error).back();
  control.set_max_error(0.1);
  EXPECT_LT(control.step(), tight);
  const std::size_t loose = steps_to_rest(control, error).back();
  EXPECT_LE(error(loose), 0.1);
  control.set_max_error(0.01);
  EXPECT_EQ(control.step(), tight);
}

TEST(QualityControl, RemembersWhileTheSceneChangesLittle) {
  QualityControl control;
  control.set_max_error(0.1);
  Scene scene = cloud_scene(30, 1.0);
  control.begin_frame(scene, scene.camera);
  const ErrorOfStep cliff = [](std::size_t step) { return step < 5 ? 0.2 : 0.02; };
  ASSERT_EQ(steps_to_rest(control, cliff).back(), 5u);

  scene.medium.append({{0.1, 0.2, 0.3}, 0.3, 0.1});
  control.begin_frame(scene, scene.camera);
  EXPECT_EQ(steps_to_rest(control, cliff).size(), 1u);

  // Much has changed: the choice is the start of a new search.
  const Scene denser = cloud_scene(60, 1.0);
  control.begin_frame(denser, denser.camera);
  EXPECT_EQ(control.step(), 5u);
  EXPECT_FALSE(control.trials()[4].error);
  EXPECT_LT(steps_to_rest(control, [](std::size_t) { return 0.001; }).back(), 5u);

  control.reset();
  EXPECT_EQ(control.settings(), QualityControl().settings());
}

TEST(QualityControl, NoticesLightsAndDensity) {
  const Scene scene = cloud_scene(30, 1.0);
  const auto forgets = [&](auto change) {
    QualityControl control;
    control.begin_frame(scene, scene.camera);
    control.record(control.settings(), error_of(0.02), 10.0);
    Scene changed = scene;
    change(changed);
    control.begin_frame(changed, changed.camera);
    return !control.trials()[control.step()].error;
  };
  EXPECT_FALSE(forgets([](Scene&) {}));
  EXPECT_FALSE(forgets([](Scene& s) { s.camera.eye.x += 1.0; }));
  EXPECT_TRUE(forgets([](Scene& s) { s.lights.push_back(s.lights[0]); }));
  EXPECT_TRUE(forgets([](Scene& s) { s.lights[0].on = false; }));
  EXPECT_TRUE(forgets([](Scene& s) { s.medium.set_homogeneous_density(0.1); }));
  EXPECT_TRUE(forgets([](Scene& s) { s.medium = cloud_scene(30, 2.0).medium; }));
}

// One view of much fog must not keep the settings costly for all others.
TEST(QualityControl, LowersQualityInAnEasierView) {
  QualityControl control;
  control.set_max_error(0.1);
  const Scene scene = cloud_scene(30, 1.0);
  control.begin_frame(scene, scene.camera);
  ASSERT_EQ(steps_to_rest(control, [](std::size_t step) { return step < 6 ? 0.2 : 0.05; }).back(),
            6u);
  const ErrorOfStep easy = [](std::size_t) { return 0.001; };
  EXPECT_EQ(steps_to_rest(control, easy).back(), 6u);
  Camera other = scene.camera;
  other.eye.z *= 2.0;
  control.begin_frame(scene, other);
  EXPECT_EQ(steps_to_rest(control, easy).back(), 0u);
}

TEST(QualityControl, IgnoresSettingsThatAreNotItsOwn) {
  QualityControl control;
  Settings paper;
  paper.airlight = AirlightMethod::paper;
  control.record(paper, error_of(0.9), 10.0);
  for (const QualityControl::Trial& trial : control.trials()) EXPECT_FALSE(trial.error);
}

}  // namespace
}  // namespace brume
