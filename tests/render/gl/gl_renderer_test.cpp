// Frames of the device against those of the CPU with the same settings.

#include "render/gl_renderer.h"

#include <algorithm>
#include <filesystem>
#include <glm/geometric.hpp>

#include "brume/at_time.h"
#include "core/io/disk/installed_files.h"
#include "core/io/scene/scene_file.h"
#include "core/scene/lights/radiance_map.h"
#include "core/scene/materials/coverage.h"
#include "core/scene/materials/measured_brdf.h"
#include "render/render_plan.h"
#include "render/renderer.h"
#include "tests/contains.h"
#include "tests/random.h"
#include "tests/render/gl/gl_frames.h"
#include "tests/render/random_scene.h"
#include "tests/render/test_scenes.h"
#include "tools/bench/scenes/benchmark_scenes.h"

namespace brume::gl {
namespace {

// The backends may differ by this.
constexpr double bound = 2e-3;

// How far two frames' layers are from each other.
struct LayerErrors {
  double airlight, transmittance, beauty, depth;

  LayerErrors(const Frame& a, const Frame& b)
      : airlight(rel_rmse(a.airlight, b.airlight)),
        transmittance(rel_rmse(a.transmittance, b.transmittance)),
        beauty(rel_rmse(a.beauty, b.beauty)),
        depth(rel_rmse(a.depth, b.depth)) {}
  [[nodiscard]] double max_value() const {
    return std::max({airlight, transmittance, beauty, depth});
  }
};

void expect_within(const LayerErrors& error, double limit, const std::string& what) {
  EXPECT_LE(error.airlight, limit) << what;
  EXPECT_LE(error.transmittance, limit) << what;
  EXPECT_LE(error.beauty, limit) << what;
  EXPECT_LE(error.depth, limit) << what;
}

// The scene as single precision may see it: lights and view are off by a rounding of their distance
// to the eye.
Scene rounded(Scene scene) {
  constexpr double rounding = 1e-7;
  const auto move = [&](glm::dvec3& p) {
    p += rounding * glm::length(p - scene.camera.eye) * glm::dvec3(0.6, -0.48, 0.64);
  };
  for (Light& light : scene.lights) move(light.position);
  move(scene.camera.target);
  return scene;
}

TEST_F(GlFrames, SampleScenes) {
  Settings paper = paper_settings;
  paper.paper = {true, true};
  Settings scaled = quick_slices();
  scaled.airlight_scale = 4;
  for (const auto& entry : std::filesystem::directory_iterator(resources_folder() / "scenes")) {
    if (entry.path().extension() != ".brume") continue;
    std::vector<std::string> warnings;
    Scene scene = evaluate_at(load_scene(entry.path(), &warnings), 0.0);
    // The CPU renders these, and says why.
    const auto has_copies = [](const Surface& surface) { return surface.placed_copies != nullptr; };
    if (has_panes(scene.surfaces) || std::ranges::any_of(scene.surfaces, has_copies)) continue;
    scene.film = {45, 23};
    // Tests of surfaces hold it: it takes longer to make than all frames.
    for (Surface& surface : scene.surfaces) surface.transfer = Surface::Transfer::none;
    Renderer renderer;
    // Other combinations are those of random scenes.
    for (const Settings& settings : {paper, scaled}) {
      const std::string name = entry.path().filename().string() + ", " + airlight_name(settings) +
                               ", scale " + std::to_string(settings.airlight_scale);
      const Frame gl = render_on_device(scene, settings, name);
      const Frame cpu = render_frame(renderer, scene, settings);
      // Distances from a far light are floats, off by up to a 4000th of the scene: between leaves
      // that decides which of a few rays of sunbeams are lit (measured: 0.7%).
      const bool is_far = std::ranges::any_of(scene.lights, [](const Light& light) {
        return light.as<light::Directional>() != nullptr;
      });
      const LayerErrors error(gl, cpu);
      EXPECT_LE(std::max(error.transmittance, error.depth), bound) << name;
      EXPECT_LE(std::max(error.airlight, error.beauty), is_far ? 0.01 : bound) << name;
      // The same pixels are upsampled, but where a sample is at the limit, which is decisive for
      // four cells of 16 pixels: in one of these frames two such cells differ.
      EXPECT_NEAR(gl.statistics.exact_pixels, cpu.statistics.exact_pixels, 64.0) << name;
      // One of sunrise touches the edge of the view but for rounding.
      EXPECT_NEAR(gl.statistics.gaussians_used, cpu.statistics.gaussians_used, 1.0) << name;
    }
  }
}

TEST_F(GlFrames, RandomScenes) {
  std::vector<std::string> unstable;
  const unsigned scenes = random_cases(16);
  for (unsigned seed = 1; seed <= scenes; ++seed) {
    const Scene scene = random_scene(seed);
    Settings sliced = quick_slices();
    sliced.airlight_scale = seed % 4 == 0 ? 2 : 1;
    Settings paper = paper_settings;
    paper.paper = {seed % 2 == 1, seed % 4 > 1};
    for (const Settings& settings : {sliced, paper}) {
      const std::string name = "seed " + std::to_string(seed) + ", " + airlight_name(settings);
      const Frame cpu = render_frame(scene, settings);
      const LayerErrors error(render_on_device(scene, settings, name), cpu);
      if (error.max_value() <= bound) continue;
      // Some scenes are too much for single precision: the CPU's own frame is as far off.
      unstable.push_back(name + ", error " + std::to_string(error.max_value()));
      const double own = LayerErrors(render_frame(rounded(scene), settings), cpu).max_value();
      expect_within(error, 3.0 * own, name);
    }
  }
  // One of these 16 is: seed 15, by 0.25%.
  EXPECT_LE(unstable.size(), scenes / 16) << testing::PrintToString(unstable);
}

// Light from all around, scattered alike all around, forward and back, in fog and without.
TEST_F(GlFrames, Environments) {
  for (const double anisotropy : {0.0, 0.7, -0.5}) {
    for (const double b0 : {0.0, 0.2}) {
      Scene scene = on_film(cloud_scene(10, 2.0), {16, 12});
      scene.lights.clear();
      scene.environment.emplace();
      scene.environment->map = smooth_sky();
      scene.environment->rotation = 40.0;
      scene.environment->intensity = 2.0;
      scene.optics.anisotropy = anisotropy;
      scene.medium.set_homogeneous_density(b0);
      if (b0 > 0.0) scene.surfaces.push_back(wall(-0.5, 0.7));
      for (Settings settings : {paper_settings, quick_slices()}) {
        const std::string name = airlight_name(settings) + ", g = " + std::to_string(anisotropy) +
                                 ", b0 = " + std::to_string(b0);
        settings.source_grid = {1000, 24};
        const Frame cpu = render_frame(scene, settings);
        expect_within({render_on_device(scene, settings, name), cpu}, bound, name);
      }
    }
  }
}

// A surface close to the eye in a large Gaussian, with a light next to it: rays are short, and
// where on them light is taken counts.
TEST_F(GlFrames, ShortRaysInALargeGaussian) {
  Scene scene;
  scene.film = {16, 12};
  scene.camera.eye = {0.0, 0.0, 0.0};
  scene.camera.target = {0.0, 0.0, -1.0};
  scene.medium.append({{0.4, 0.2, -1.5}, 1.5, 0.8});
  scene.lights.emplace_back().position = {0.03, 0.08, -0.2};
  scene.surfaces.push_back(wall(-0.4, 1.0));
  Settings mean = paper_settings;
  mean.paper.at_mean = true;
  for (const Settings& settings : {paper_settings, mean, quick_slices()}) {
    const std::string name = airlight_name(settings);
    const Frame cpu = render_frame(scene, settings);
    expect_within({render_on_device(scene, settings, name), cpu}, bound, name);
  }
}

// A ball over a floor that shadow each other and themselves, lit by two lights.
class GlSurfaces : public GlFrames {
 protected:
  GlSurfaces() {
    scene_ = cloud_scene(10, 4.0);
    scene_.film = {48, 36};
    scene_.camera.eye = {2.5, -4.0, 2.5};
    scene_.camera.target = {0.0, 0.0, 0.3};
    scene_.camera.up = {0.0, 0.0, 1.0};
    MeshArrays ball;
    add_ball(ball, 12, {0.0, 0.0, 0.9}, 0.7, 3.0, false);
    MeshArrays floor;
    add_floor(floor, 4, 3.0);
    for (const auto& mesh : {ball, floor}) {
      Surface& surface = scene_.surfaces.emplace_back();
      surface.mesh = to_mesh(mesh);
      surface.material.reflectance = {0.7, 0.5, 0.3};
    }
    scene_.lights.assign(2, {});
    scene_.lights[0].position = {2.0, 1.0, 3.0};
    scene_.lights[1].position = {-1.5, -2.0, 2.0};
    scene_.lights[1].intensity = {0.5, 2.0, 1.0};
  }
  // Light from behind the medium, without the airlight.
  static std::vector<float> through_medium(const Frame& frame) {
    std::vector<float> values = frame.airlight;
    for (std::size_t i = 0; i < values.size(); ++i) {
      values[i] = frame.beauty[i / 3 * 4 + i % 3] - values[i];
    }
    return values;
  }
  void make_glossy() {
    for (Surface& surface : scene_.surfaces) {
      surface.material.type = Material::Type::phong;
      surface.material.specular = {0.3, 0.4, 0.2};
      surface.material.exponent = 20.0;
    }
  }
  void expect_same(Settings settings, const std::string& what) {
    const std::string name = what + ", " + airlight_name(settings);
    const Frame gl = render_on_device(scene_, settings, name);
    for (const SkippedStage& stage : gl.statistics.on_cpu) {
      EXPECT_NE(stage.stage, Stage::surfaces) << name << ": " << stage.why;
    }
    const Frame cpu = render_frame(scene_, settings);
    expect_within({gl, cpu}, bound, name);
    EXPECT_LE(rel_rmse(through_medium(gl), through_medium(cpu)), 2e-4) << name;
    if (settings.airlight == AirlightMethod::paper && !scene_.medium.empty()) {
      EXPECT_GT(gl.statistics.light_pairs, 0u);
    }
  }

  Scene scene_;
};

TEST_F(GlSurfaces, MatchTheCpuUnderLights) {
  const Scene in_fog = scene_;
  Settings of_the_paper = quick_slices();
  of_the_paper.paper_spread = true;
  for (const Settings& settings : {paper_settings, quick_slices(), of_the_paper}) {
    make_glossy();
    expect_same(settings, "Gaussians, glossy");
    scene_.surfaces.back().material.type = Material::Type::diffuse;
    expect_same(settings, "Gaussians, glossy and diffuse");
    scene_ = in_fog;
    expect_same(settings, "Gaussians");
    scene_.medium.set_homogeneous_density(0.5);
    scene_.optics.albedo = glm::dvec3(0.6);
    expect_same(settings, "Gaussians and fog");
    scene_.medium = Medium();
    expect_same(settings, "clear air");
    make_glossy();
    expect_same(settings, "clear air, glossy");
    scene_ = in_fog;
  }
}

// There are two tables, one with cells that were not measured.
TEST_F(GlSurfaces, MatchTheCpuWithMeasuredMaterials) {
  for (std::size_t i = 0; i < scene_.surfaces.size(); ++i) {
    std::vector<glm::vec3> values(MeasuredBrdf::samples);
    for (std::size_t k = 0; k < values.size(); ++k) {
      const auto h =
          static_cast<float>(k / (MeasuredBrdf::theta_d_cells * MeasuredBrdf::phi_d_cells));
      const auto d =
          static_cast<float>(k / MeasuredBrdf::phi_d_cells % MeasuredBrdf::theta_d_cells);
      const auto p = static_cast<float>(k % MeasuredBrdf::phi_d_cells);
      values[k] = {std::exp(-0.1f * h), 0.2f + 0.002f * d, 0.3f + 0.1f * std::sin(0.035f * p)};
      if (i == 0 && k % 7 == 0) values[k] = glm::vec3(-1.0f);
    }
    Material& material = scene_.surfaces[i].material;
    material.type = Material::Type::measured;
    material.measured = std::make_shared<const MeasuredBrdf>(std::move(values));
  }
  scene_.surfaces.push_back(wall(-0.5, 1.0));
  expect_same(quick_slices(), "measured");
  expect_same({}, "measured");
  std::swap(scene_.surfaces[0].material, scene_.surfaces[1].material);
  expect_same(quick_slices(), "measured, the other way round");
  scene_.medium = Medium();
  expect_same(quick_slices(), "measured, in clear air");
}

TEST_F(GlSurfaces, MatchTheCpuWithRadianceTransfer) {
  scene_.surfaces[0].transfer = Surface::Transfer::shadow;
  scene_.surfaces[1].transfer = Surface::Transfer::interreflection;
  scene_.surfaces[0].rotate = glm::dquat(0.8, 0.36, 0.0, 0.48);
  scene_.surfaces.push_back(wall(-0.5, 1.0));  // without
  for (const bool glossy : {false, true}) {
    const std::string what = glossy ? "glossy" : "diffuse";
    if (glossy) make_glossy();
    expect_same(quick_slices(), what);
    // Caches follow from frame to frame.
    scene_.lights[0].position.x += 1.0;
    expect_same(quick_slices(), what + ", another lamp");
    expect_same({}, what);
    scene_.surfaces[1].material.reflectance = {0.2, 0.9, 0.9};
    expect_same(quick_slices(), what + ", another colour");
  }
}

TEST_F(GlSurfaces, MatchTheCpuUnderAnEnvironment) {
  scene_.environment.emplace();
  auto sky = std::make_shared<RadianceMap>(*smooth_sky());
  // A small bright part, which all bands see.
  std::fill_n(sky->pixels.begin() + 10 * sky->width + 20, 6, glm::vec3(600.0f, 400.0f, 100.0f));
  scene_.environment->map = sky;
  scene_.environment->rotation = 40.0;
  scene_.environment->intensity = 2.0;
  expect_same(quick_slices(), "Gaussians");
  expect_same({}, "Gaussians");
  const Scene diffuse = scene_;
  scene_.medium.set_homogeneous_density(0.2);
  make_glossy();
  expect_same({}, "Gaussians and fog, glossy");
  expect_same(quick_slices(), "Gaussians and fog, glossy");
  scene_.medium.set_homogeneous_density(0.0);
  expect_same(quick_slices(), "Gaussians, glossy");
  scene_.surfaces[0].transfer = Surface::Transfer::shadow;
  expect_same(quick_slices(), "Gaussians, glossy, with transfer");
  scene_.medium = Medium();
  expect_same(quick_slices(), "clear air, glossy, with transfer");
  scene_.surfaces[0].transfer = Surface::Transfer::none;
  expect_same(quick_slices(), "clear air, glossy");
  scene_ = diffuse;
  scene_.lights.clear();
  scene_.medium.set_homogeneous_density(0.2);
  expect_same(quick_slices(), "Gaussians and fog");
  scene_.medium = Medium();
  scene_.medium.set_homogeneous_density(0.2);
  expect_same(quick_slices(), "fog");
  expect_same({}, "fog");
  scene_.medium = Medium();
  expect_same(quick_slices(), "clear air");
}

// Everything that may change from frame to frame, a little, one thing at a time: no message, and
// nothing that stays behind.
TEST_F(GlFrames, ManyChangesLeakNoObjects) {
  Random random(1);
  Scene scene = on_film(cloud_scene(8, 2.0), {20, 15});
  Settings settings = sliced_settings({}, 4);
  settings.optical_depth_table = {16, 8};
  settings.shadow_cells = 16;
  settings.source_grid = {64, 6};
  std::size_t limit = 0;
  for (int i = 0; i < 150; ++i) {
    const auto in = [&](int from, int to) {
      return from + static_cast<int>(random.uniform(0.0, to - from + 1));
    };
    switch (in(0, 9)) {
      case 0:
        scene.camera.eye += random.point(0.1);
        break;
      case 1:
        scene.lights[0].position += random.point(0.2);
        break;
      case 2: {
        Medium medium;
        for (std::size_t k = 0; k < scene.medium.size(); ++k) {
          Gaussian g = scene.medium.gaussian(k);
          g.center += random.point(0.02);
          medium.append(g);
        }
        medium.set_homogeneous_density(in(0, 1) * 0.1);
        scene.medium = medium;
        break;
      }
      case 3:
        scene.film = {in(1, 40), in(1, 30)};
        break;
      case 4:
        settings.airlight_scale = 1 << in(0, 2);
        break;
      case 5:
        settings.airlight = in(0, 3) == 0 ? AirlightMethod::paper : AirlightMethod::sliced;
        settings.slices = in(2, 8);
        break;
      case 6:
        scene.optics.noise.amplitude = in(0, 1) * 0.3;
        scene.optics.anisotropy = in(0, 1) * 0.5;
        break;
      case 7:
        scene.optics.albedo = in(0, 2) == 0 ? glm::dvec3(0.9, 0.8, 0.9) : glm::dvec3(1.0);
        break;
      case 8:
        scene.lights.resize(static_cast<std::size_t>(in(1, 3)), scene.lights[0]);
        scene.lights.back().position = random.point(3.0);
        break;
      case 9:
        scene.surfaces.clear();
        if (in(0, 1) == 0) scene.surfaces.push_back(wall(-0.5, 1.0));
        break;
    }
    const Frame frame = render(scene, settings);
    ASSERT_EQ(frame.statistics.backend, "gl") << i << ": " << frame.statistics.on_cpu[0].why;
    ASSERT_NO_FATAL_FAILURE(expect_finite(frame)) << i;
    // All that there can be has been there after some hundred frames.
    if (i < 200) limit = std::max(limit, live_objects());
    ASSERT_LE(live_objects(), limit) << i;
  }
}

// A moved camera makes no table, a moved light one, a changed medium all.
TEST_F(GlFrames, ReusesUnchangedData) {
  Scene scene = on_film(cloud_scene(10, 2.0), {16, 12});
  scene.lights.push_back(scene.lights[0]);
  scene.lights[1].position.x += 1.0;
  const Settings settings = quick_slices();
  const auto pairs = [&] { return render(scene, settings).statistics.light_pairs; };
  const std::uint64_t both = pairs();
  EXPECT_GT(both, 0u);
  EXPECT_EQ(pairs(), 0u);
  scene.camera.eye.x += 0.1;
  EXPECT_EQ(pairs(), 0u);
  scene.lights[1].position.y += 0.1;
  const std::uint64_t one = pairs();
  EXPECT_GT(one, 0u);
  EXPECT_LT(one, both);
  scene.medium.set_homogeneous_density(0.1);
  EXPECT_GT(pairs(), one);
  // The cached data is right.
  expect_within({render(scene, settings), render_frame(scene, settings)}, bound, "kept");
}

TEST_F(GlFrames, StopsOnRequest) {
  const Scene scene = cloud_scene(3, 1.0);
  std::stop_source stop;
  stop.request_stop();
  EXPECT_FALSE(gl_->render(scene, scene.camera, {8, 6}, quick_slices(), stop.get_token()));
  EXPECT_TRUE(gl_->render(scene, scene.camera, {8, 6}, quick_slices()));
}

TEST(MakeRenderer, UsesNoSoftwareRendererUnlessRequested) {
  const Scene scene = cloud_scene(3, 1.0);
  std::string problem;
  for (const Backend backend : {Backend::auto_, Backend::cpu, Backend::gl}) {
    const auto renderer = make_renderer(backend, nullptr, problem);
    const Frame frame = *renderer->render(scene, scene.camera, {8, 6}, quick_slices());
    if (backend == Backend::auto_) {
      EXPECT_FALSE(is_software_renderer(frame.statistics.device));
    } else {
      EXPECT_EQ(frame.statistics.backend, backend == Backend::gl ? "gl" : "cpu") << problem;
    }
  }
  EXPECT_EQ(problem, "");
}

class GlFailures : public GlFrames {
 protected:
  // The frame is the CPU's, with that reason.
  void expect_cpu(const char* why) {
    const Frame frame = render(scene_, settings_);
    EXPECT_EQ(frame.statistics.backend, "cpu");
    ASSERT_FALSE(frame.statistics.on_cpu.empty());
    EXPECT_EQ(frame.statistics.on_cpu[0].stage, Stage::frame);
    EXPECT_TRUE(contains(frame.statistics.on_cpu[0].why, why));
    EXPECT_EQ(frame.beauty, render_frame(scene_, settings_).beauty);
    messages_->collect();  // the driver may speak of what was made to fail
  }
  void expect_gl() { EXPECT_EQ(render(scene_, settings_).statistics.backend, "gl"); }

  Scene scene_ = [] {
    Scene scene = on_film(cloud_scene(3, 1.0), {8, 6});
    return scene;
  }();
  Settings settings_ = sliced_settings({}, 4);
};

TEST_F(GlFailures, OutOfMemoryFallsBackToTheCpuForOneFrame) {
  expect_gl();
  failures().memory = true;
  scene_.film = {9, 7};
  expect_cpu("out of device memory");
  failures() = {};
  expect_gl();
}

TEST_F(GlFailures, AfterALostContextAllIsTheCpus) {
  expect_gl();
  failures().context = true;
  expect_cpu("lost");
  failures() = {};
  expect_cpu("lost");
}

TEST_F(GlFailures, ABrokenShaderFallsBackToTheCpu) {
  failures().shader = true;
  expect_cpu("rejects shader");
  failures() = {};
  expect_cpu("rejects shader");
}

TEST_F(GlFailures, UnsupportedSettingsFallBackToTheCpu) {
  settings_.airlight = AirlightMethod::reference;
  expect_cpu("reference");
  settings_ = sliced_settings({}, 300);
  settings_.optical_depth_table = {16, 8};
  expect_cpu("slices");
}

}  // namespace
}  // namespace brume::gl
