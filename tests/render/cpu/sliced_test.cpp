#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <ostream>
#include <string>
#include <vector>

#include "render/quality/auto_quality.h"
#include "render/renderer.h"
#include "tests/render/test_scenes.h"

namespace brume {
namespace {

Settings sliced(int slices) {
  return sliced_settings({}, slices);
}

struct KindOfScene {
  std::string name;
  Scene scene;
  double coarse;  // bound of the relative RMSE with the default settings
  double fine;    // and with the finest
};

void PrintTo(const KindOfScene& row, std::ostream* out) {
  *out << row.name;
}

Scene with_light_at(Scene scene, const glm::dvec3& position) {
  scene.lights[0].position = position;
  return scene;
}

Scene scattering(Scene scene, double anisotropy) {
  scene.optics.anisotropy = anisotropy;
  return scene;
}

Scene absorbing(Scene scene) {
  scene.optics.albedo = {0.4, 0.7, 0.7};
  return scene;
}

Scene shaft() {
  Scene scene = in_fog(cloud_scene(20, 0.5), 0.02);
  scene.lights[0].position = {0.2, 0.1, -4.0};
  scene.surfaces.push_back(wall(-2.0, 0.4));
  return scene;
}

Scene two_dense() {
  Scene scene = cloud_scene(1, 1e-9);
  scene.medium.append({{0.0, 0.1, 0.3}, 0.4, 7.0});
  scene.medium.append({{0.2, 0.0, -0.3}, 0.4, 7.0});
  return scene;
}

// Small and dense, a tenth of the cloud's radius, in haze.
Scene hard_blobs() {
  Scene scene = cloud_scene(20, 0.1);
  const Scene places = cloud_scene(40, 1.0, 7);
  for (std::size_t i = 0; i < places.medium.size(); ++i) {
    scene.medium.append({places.medium.gaussian(i).center, 0.1, 8.0});
  }
  return scene;
}

std::vector<KindOfScene> make_rows() {
  constexpr double cloud = 0.01;
  constexpr double hard = 0.03;
  constexpr double finest = 0.003;
  std::vector<KindOfScene> rows{
      {"30 Gaussians, depth 0.3", cloud_scene(30, 0.3), cloud, finest},
      {"30 Gaussians, depth 3", cloud_scene(30, 3.0), cloud, finest},
      {"30 Gaussians, depth 10", cloud_scene(30, 10.0), cloud, finest},
      {"300 Gaussians, depth 0.3", cloud_scene(300, 0.3), cloud, finest},
      {"300 Gaussians, depth 3", cloud_scene(300, 3.0), cloud, finest},
      {"300 Gaussians, depth 10", cloud_scene(300, 10.0), cloud, finest},
      {"1,000 Gaussians, depth 10", cloud_scene(1000, 10.0), cloud, finest},
      {"light inside, depth 1", with_light_at(cloud_scene(300, 1.0), {0.2, 0.1, 0.3}), hard,
       finest},
      {"light inside, depth 3", with_light_at(cloud_scene(300, 3.0), {0.2, 0.1, 0.3}), hard,
       finest},
      {"eye inside", eye_inside(), hard, finest},
      {"cut by a surface", cut_by_a_surface(), hard, finest},
      {"two dense ones overlapping", two_dense(), hard, finest},
      {"hard small blobs in haze", hard_blobs(), hard, finest},
      {"fog alone", in_fog(cloud_scene(1, 1e-12), 0.1), hard, finest},
      {"cloud in fog", in_fog(cloud_scene(300, 1.0), 0.02), hard, finest},
      {"cloud in thick fog", in_fog(cloud_scene(300, 1.0), 0.2), hard, finest},
      {"light inside fog", in_fog(with_light_at(cloud_scene(30, 0.5), {0.2, 0.3, 0.1}), 0.1), hard,
       finest},
      {"forward scattering", scattering(in_fog(cloud_scene(100, 1.0), 0.02), 0.7), hard, finest},
      {"backward scattering", scattering(cloud_scene(100, 1.0), -0.5), hard, finest},
      {"absorbing", absorbing(cloud_scene(100, 1.0)), hard, finest},
      {"shaft", shaft(), hard, 0.05},
  };
  // Three times as many pixels as auto samples.
  for (KindOfScene& row : rows) row.scene.film = {24, 18};
  return rows;
}

// A kind of scene and its reference, made once for all that is checked on it.
class KindsOfScenes : public testing::TestWithParam<KindOfScene> {
 protected:
  const Scene& scene() const { return GetParam().scene; }
  double error_of(const Frame& frame) const { return rel_rmse(frame.airlight, truth_.airlight); }

  Frame truth_ = render_frame(GetParam().scene, {.airlight = AirlightMethod::reference});
};

TEST_P(KindsOfScenes, SlicedAndAutoKeepTheirBounds) {
  EXPECT_LT(error_of(render_frame(scene(), sliced(Settings{}.slices))), GetParam().coarse);

  // With more slices and finer tables the error falls, down to what depth_error leaves.
  constexpr double floor = 5e-4;
  double error = 1.0;
  for (const int slices : {8, 32, 128}) {
    SCOPED_TRACE(slices);
    const double before = error;
    const Frame frame = render_frame(scene(), sliced(slices));
    error = error_of(frame);
    EXPECT_LT(error, std::max(before, floor));
    for (std::size_t i = 0; i < frame.transmittance.size(); ++i) {
      ASSERT_NEAR(frame.transmittance[i], truth_.transmittance[i], 1e-3);
    }
  }
  EXPECT_LT(error, GetParam().fine);

  // The bound holds for the whole frame, of which auto sees a sample.
  for (const int scale : {1, 4}) {
    SCOPED_TRACE(scale);
    Settings settings;
    settings.airlight_scale = scale;
    Renderer renderer;
    const auto result = render_requested(renderer, scene(), scene().camera, scene().film, settings);
    ASSERT_TRUE(result);
    EXPECT_LE(result->error->airlight.high, 0.02);
    EXPECT_LE(error_of(result->frame), 0.02);
  }
}

std::string kind_name(const testing::TestParamInfo<KindOfScene>& info) {
  std::string name = info.param.name;
  std::erase(name, ',');
  std::replace_if(
      name.begin(), name.end(), [](char c) { return std::isalnum(c) == 0; }, '_');
  return name;
}

INSTANTIATE_TEST_SUITE_P(All, KindsOfScenes, testing::ValuesIn(make_rows()), kind_name);

}  // namespace
}  // namespace brume
