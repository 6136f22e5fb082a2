// Frames of the device against those of the CPU with the same settings.

#include "render/gl/gl_renderer.h"

#include <filesystem>
#include <glm/geometric.hpp>

#include "core/io/scene_file.h"
#include "render/compare.h"
#include "render/renderer.h"
#include "tests/render/gl/gl_test.h"
#include "tests/render/random_scene.h"

namespace brume::gl {
namespace {

// What the backends may differ by.
constexpr double bound = 2e-3;

double rel_rmse(std::span<const float> a, std::span<const float> b) {
  const ChannelPair pair{a, b};
  const Comparison difference = compare(std::span(&pair, 1));
  return difference.incomparable > 0 ? std::numeric_limits<double>::infinity()
                                     : difference.rel_rmse;
}

// How far two frames' layers are from each other.
struct LayerErrors {
  double airlight, transmittance, beauty, depth;

  LayerErrors(const Frame& a, const Frame& b)
      : airlight(rel_rmse(a.airlight, b.airlight)),
        transmittance(rel_rmse(a.transmittance, b.transmittance)),
        beauty(rel_rmse(a.beauty, b.beauty)),
        depth(rel_rmse(a.depth, b.depth)) {}
  [[nodiscard]] double greatest() const {
    return std::max({airlight, transmittance, beauty, depth});
  }
};

void expect_within(const LayerErrors& error, double most, const std::string& what) {
  EXPECT_LE(error.airlight, most) << what;
  EXPECT_LE(error.transmittance, most) << what;
  EXPECT_LE(error.beauty, most) << what;
  EXPECT_LE(error.depth, most) << what;
}

Frame on_cpu(const Scene& scene, const Settings& settings) {
  return *Renderer().render(scene, scene.camera, scene.film, settings);
}

// The scene as single precision may see it: lights and view are off by a rounding of their distance
// to the eye.
Scene rounded(Scene scene) {
  constexpr double rounding = 1e-7;
  const auto move = [&](glm::dvec3& p) {
    p += rounding * glm::length(p - scene.camera.eye) * glm::dvec3(0.6, -0.48, 0.64);
  };
  for (PointLight& light : scene.lights) move(light.position);
  move(scene.camera.target);
  return scene;
}

// A renderer whose driver's messages are failures.
class GlFrames : public testing::Test {
 protected:
  void SetUp() override {
    std::string problem;
    objects_ = live_objects();
    gl_ = GlRenderer::create(nullptr, problem, true);
    ASSERT_TRUE(gl_) << problem;
    ASSERT_TRUE(gl_->context().make_current());
    messages_ = std::make_unique<Messages>();
    gl_->context().done_current();
  }
  void TearDown() override {
    failures() = {};
    if (!gl_) return;
    ASSERT_TRUE(gl_->context().make_current());
    for (const std::string& message : messages_->take()) ADD_FAILURE() << message;
    messages_.reset();
    gl_.reset();
    EXPECT_EQ(live_objects(), objects_) << "objects were left over";
  }
  Frame render(const Scene& scene, const Settings& settings) {
    return *gl_->render(scene, scene.camera, scene.film, settings);
  }
  // A frame that the device has made.
  Frame render_on_device(const Scene& scene, const Settings& settings, const std::string& what) {
    Frame frame = render(scene, settings);
    EXPECT_EQ(frame.statistics.backend, "gl") << what;
    for (const SkippedStage& stage : frame.statistics.on_cpu) {
      EXPECT_NE(stage.stage, "frame") << what << ": " << stage.why;
    }
    return frame;
  }

  std::unique_ptr<GlRenderer> gl_;
  std::unique_ptr<Messages> messages_;
  std::size_t objects_ = 0;
};

TEST_F(GlFrames, SampleScenes) {
  for (const auto& entry : std::filesystem::directory_iterator(BRUME_SCENES)) {
    if (entry.path().extension() != ".brume") continue;
    const std::string name = entry.path().filename();
    std::vector<std::string> warnings;
    Scene scene = load_scene(entry.path(), &warnings);
    scene.film = {80, 60};
    const Settings settings = sliced_settings({}, 12);
    expect_within({render_on_device(scene, settings, name), on_cpu(scene, settings)}, bound, name);
  }
}

TEST_F(GlFrames, RandomScenes) {
  int unstable = 0;
  for (unsigned seed = 1; seed <= 100; ++seed) {
    const std::string name = "seed " + std::to_string(seed);
    const Scene scene = random_scene(seed);
    Settings settings = sliced_settings({}, 12);
    settings.source_grid = {200, 12};
    if (scene.environment && scene.optics.anisotropy != 0.0) {
      EXPECT_EQ(render(scene, settings).statistics.backend, "cpu") << name;
      continue;
    }
    const Frame cpu = on_cpu(scene, settings);
    const LayerErrors error(render_on_device(scene, settings, name), cpu);
    if (error.greatest() <= bound) continue;
    // Some scenes are too much for single precision: the CPU's own frame is as far off.
    ++unstable;
    const double own = LayerErrors(on_cpu(rounded(scene), settings), cpu).greatest();
    expect_within(error, 3.0 * own, name);
  }
  EXPECT_LE(unstable, 3);
}

}  // namespace
}  // namespace brume::gl
