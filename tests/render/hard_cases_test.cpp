// Scenes that break careless arithmetic: each must come out finite, and right where the right
// answer is known: `paper` in SIMD as in plain double, and close to the reference where the
// paper's approximation is good.

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "tests/render/test_scenes.h"

namespace brume {
namespace {

// What is known of the airlight: `dark` for none that float could tell from 0, `far_off` where the
// paper's approximation fails by its nature (math, section 3), else the most that `paper` is off.
constexpr double dark = -1.0;
constexpr double far_off = 1e9;

struct HardCase {
  const char* name;
  double paper_error;  // relative RMSE against the reference, about 1.5 times what is measured
  std::function<Scene()> make;
};

Scene base() {
  Scene scene = cloud_scene(20, 1.0);
  scene.film = {24, 24};
  scene.surfaces.push_back(wall(-0.5, 1.0));
  return scene;
}

const HardCase cases[] = {
    {"radius 1e-4", 0.12,
     [] {
       Scene s = base();
       s.medium.append({{0.0, 0.0, 0.5}, 1e-4, 1e4});
       return s;
     }},
    {"radius 1e4", far_off,
     [] {
       Scene s = base();
       s.medium.append({{0.0, 0.0, 0.5}, 1e4, 1e-2});
       return s;
     }},
    {"density 0", 0.12,
     [] {
       Scene s = base();
       s.medium.append({{0.0, 0.0, 0.5}, 0.5, 0.0});
       return s;
     }},
    {"density 1e6", far_off,
     [] {
       Scene s = base();
       s.medium.append({{0.3, 0.0, 0.5}, 0.3, 1e6});
       return s;
     }},
    {"density 1e6 and radius 1e4", dark,
     [] {
       Scene s = base();
       s.medium.append({{0.0, 0.0, -3e4}, 1e4, 1e6});
       return s;
     }},
    {"eye at a centre", 0.08,
     [] {
       Scene s = base();
       s.medium.append({s.camera.eye, 0.5, 1.0});
       return s;
     }},
    {"light at a centre", 0.12,
     [] {
       Scene s = base();
       s.medium.append({s.lights[0].position, 0.5, 1.0});
       return s;
     }},
    {"eye and light at one dense centre", far_off,
     [] {
       Scene s = base();
       s.lights[0].position = s.camera.eye;
       s.medium.append({s.camera.eye, 0.5, 20.0});
       return s;
     }},
    {"two equal Gaussians", 0.6,
     [] {
       Scene s = base();
       s.medium.append({{0.1, 0.2, 0.3}, 0.5, 1.0});
       s.medium.append({{0.1, 0.2, 0.3}, 0.5, 1.0});
       return s;
     }},
    {"a surface through a centre", 0.25,
     [] {
       Scene s = base();
       s.medium.append({{0.0, 0.0, -0.5}, 0.4, 2.0});
       return s;
     }},
    {"a view ray through the light", far_off,
     [] {
       Scene s = base();
       s.film = {25, 25};  // the middle pixel's ray goes to the target
       s.lights[0].position = {0, 0, 1};
       s.medium.set_homogeneous_density(0.1);
       return s;
     }},
    {"no lights", dark,
     [] {
       Scene s = base();
       s.lights.clear();
       return s;
     }},
    {"no Gaussians", dark,
     [] {
       Scene s = base();
       s.medium = Medium();
       return s;
     }},
    {"nothing at all", dark, [] { return Scene{}; }},
    {"homogeneous fog alone, very dense", dark,
     [] {
       Scene s = base();
       s.medium = Medium();
       s.medium.set_homogeneous_density(1e4);
       return s;
     }},
    {"light in the wall", far_off,
     [] {
       Scene s = base();
       s.lights[0].position = {0.1, 0.1, -0.5};
       return s;
     }},
    {"light of enormous intensity", 0.12,
     [] {
       Scene s = base();
       s.lights[0].intensity = glm::dvec3(1e20);  // the most that a scene file may say
       return s;
     }},
    {"a pinprick of a view", 0.12,
     [] {
       Scene s = base();
       s.camera.vertical_fov = 1e-3;
       return s;
     }},
    {"a view of nearly 180 degrees", dark,
     [] {
       Scene s = base();
       s.camera.vertical_fov = 179.9;
       return s;
     }},
    {"camera looking along its up", 0.12,
     [] {
       Scene s = base();
       s.camera.up = {0, 0, 1};
       return s;
     }},
};

class HardCases : public testing::TestWithParam<HardCase> {};

TEST_P(HardCases, AreFiniteAndRight) {
  const Scene scene = GetParam().make();
  Settings settings;
  const Frame fast = render_frame(scene, settings);
  expect_finite(fast);
  settings.arithmetic = Settings::Arithmetic::plain_double;
  const Frame plain = render_frame(scene, settings);
  expect_finite(plain);
  settings.airlight = AirlightMethod::reference;
  const Frame reference = render_frame(scene, settings);
  expect_finite(reference);

  settings.airlight = AirlightMethod::sliced;
  const Frame sliced = render_frame(scene, settings);
  expect_finite(sliced);

  // What is right for every method: the depth of each ray.
  double most = 0.0;
  for (std::size_t i = 0; i < fast.transmittance.size(); ++i) {
    ASSERT_NEAR(fast.transmittance[i], reference.transmittance[i], 2e-3) << i / 3;
    ASSERT_NEAR(sliced.transmittance[i], reference.transmittance[i], 2e-3) << i / 3;
    most = std::max(most, static_cast<double>(plain.airlight[i]));
  }
  if (GetParam().paper_error == dark) {
    EXPECT_EQ(most, 0.0);
  } else {
    EXPECT_GT(most, 0.0);
    EXPECT_LT(difference(fast.airlight, reference.airlight).relative_rmse, GetParam().paper_error);
  }
  for (std::size_t i = 0; i < fast.airlight.size(); ++i) {
    ASSERT_NEAR(fast.airlight[i], plain.airlight[i], 1e-3 * most) << "pixel " << i / 3;
  }
}

INSTANTIATE_TEST_SUITE_P(All, HardCases, testing::ValuesIn(cases), [](const auto& instance) {
  std::string name = instance.param.name;
  for (char& c : name) {
    if (!std::isalnum(static_cast<unsigned char>(c))) c = '_';
  }
  return name;
});

// The same scene moved 1e6 u away looks the same.
TEST(HardCase, FarFromTheOriginIsTheSamePicture) {
  const Scene near = base();
  Scene far = base();
  const glm::dvec3 offset(1e6, -1e6, 1e6);
  far.camera.eye += offset;
  far.camera.target += offset;
  far.lights[0].position += offset;
  far.surfaces[0].translate += offset;
  Medium moved;
  for (std::size_t i = 0; i < far.medium.size(); ++i) {
    Gaussian g = far.medium.gaussian(i);
    g.center += offset;
    moved.append(g);
  }
  far.medium = moved;
  EXPECT_LT(difference(render_frame(far, {}).beauty, render_frame(near, {}).beauty).relative_rmse,
            1e-4);
}

// One Gaussian alone, seen from outside and thin, is what the paper is good at.
TEST(HardCase, OneThinGaussianIsNearTheReference) {
  Scene scene;
  scene.film = {24, 24};
  scene.camera = {{0, 0, 4}, {0, 0, 0}, {0, 1, 0}, 40.0};
  scene.lights.push_back({{2, 3, 2}, {10, 10, 10}, {}});
  scene.medium.append({{0, 0, 0}, 0.5, 0.1});
  Settings reference;
  reference.airlight = AirlightMethod::reference;
  EXPECT_LT(difference(render_frame(scene, {}).airlight, render_frame(scene, reference).airlight)
                .relative_rmse,
            0.03);
}

}  // namespace
}  // namespace brume
