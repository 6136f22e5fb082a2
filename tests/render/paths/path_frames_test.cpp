// Frames of `path`: the same however they are made, what they say of their noise, and walls.

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <optional>
#include <stop_token>

#include "render/renderer.h"
#include "tests/render/golden_rays.h"
#include "tests/render/paths/traced_scene.h"
#include "tests/render/test_scenes.h"

namespace brume {
namespace {

// A little of everything.
Scene small_scene() {
  Scene scene = in_fog(on_film(cloud_scene(12, 2.0), {21, 13}), 0.05);
  scene.environment = even_sky(0.3f);
  scene.surfaces = {wall(-0.4, 0.7)};
  return scene;
}

void expect_same(const Frame& a, const Frame& b) {
  EXPECT_EQ(a.beauty, b.beauty);
  EXPECT_EQ(a.airlight, b.airlight);
  EXPECT_EQ(a.transmittance, b.transmittance);
  EXPECT_EQ(a.depth, b.depth);
  ASSERT_TRUE(a.statistics.path_noise && b.statistics.path_noise);
  EXPECT_EQ(a.statistics.path_noise->airlight_variance, b.statistics.path_noise->airlight_variance);
  EXPECT_EQ(a.statistics.path_noise->surface_variance, b.statistics.path_noise->surface_variance);
}

TEST(PathFrames, GoOnWhereTheyStopped) {
  for (const glm::dvec3& albedo : {glm::dvec3(1.0), glm::dvec3(0.9, 0.5, 0.9)}) {
    Scene scene = small_scene();
    scene.optics.albedo = albedo;
    const Frame at_once = render_frame(scene, path_traced(21));
    Renderer renderer;
    for (const int paths : {1, 3, 8, 17}) {
      ASSERT_TRUE(renderer.render(scene, scene.camera, scene.film, path_traced(paths)));
    }
    expect_same(render_frame(renderer, scene, path_traced(21)), at_once);
    // Nothing is left to do, and fewer begin anew.
    expect_same(render_frame(renderer, scene, path_traced(21)), at_once);
    expect_same(render_frame(renderer, scene, path_traced(5)), render_frame(scene, path_traced(5)));
  }
}

TEST(PathFrames, ForgetOtherPictures) {
  const Scene scene = small_scene();
  Scene changed = scene;
  changed.lights[0].intensity *= 2.0;
  Scene turned = scene;
  turned.camera.eye.x += 0.1;
  Scene painted = scene;
  painted.surfaces[0].material.reflectance = glm::dvec3(0.1);
  Scene foggier = scene;
  foggier.medium.set_homogeneous_density(0.1);
  Renderer renderer;
  for (const Scene* other :
       std::initializer_list<const Scene*>{&scene, &changed, &turned, &painted, &foggier}) {
    expect_same(*renderer.render(*other, other->camera, other->film, path_traced(4)),
                render_frame(*other, path_traced(4)));
  }
  Settings seeded = path_traced(4);
  seeded.path_seed = 1;
  const Frame frame = render_frame(renderer, foggier, seeded);
  expect_same(frame, render_frame(foggier, seeded));
  EXPECT_NE(frame.airlight, render_frame(foggier, path_traced(4)).airlight);
}

TEST(PathFrames, StopWithoutATrace) {
  const Scene scene = small_scene();
  Renderer renderer;
  std::stop_source stop;
  const auto stopped = renderer.render(scene, scene.camera, scene.film, path_traced(30),
                                       stop.get_token(), [&](double done) {
                                         if (done > 0.4) stop.request_stop();
                                       });
  EXPECT_FALSE(stopped);
  expect_same(render_frame(renderer, scene, path_traced(30)), render_frame(scene, path_traced(30)));
}

// Channels of one albedo are traced together; each is what it would be alone.
TEST(PathFrames, MatchTheirChannelsAlone) {
  Scene scene = small_scene();
  scene.optics.albedo = {0.9, 0.5, 0.9};
  const Frame frame = render_frame(scene, path_traced(4));
  for (const std::size_t c : {0u, 1u, 2u}) {
    scene.optics.albedo = glm::dvec3(c == 1 ? 0.5 : 0.9);
    const Frame alone = render_frame(scene, path_traced(4));
    for (std::size_t i = 0; i < frame.depth.size(); ++i) {
      ASSERT_EQ(frame.airlight[3 * i + c], alone.airlight[3 * i + c]);
      ASSERT_EQ(frame.beauty[4 * i + c], alone.beauty[4 * i + c]);
    }
  }
}

TEST(PathFrames, AClosedRoomKeepsTheSkyOut) {
  Scene scene = on_film(cloud_scene(12, 2.0), {12, 12});
  scene.lights.clear();
  scene.medium.set_homogeneous_density(0.1);
  scene.environment = even_sky(100.0f);
  scene.surfaces = {ball_surface(16, 6.0)};
  const Frame frame = render_frame(scene, path_traced(16));
  for (const float x : frame.airlight) EXPECT_EQ(x, 0.0f);
  for (std::size_t i = 0; i < frame.depth.size(); ++i) EXPECT_EQ(frame.beauty[4 * i], 0.0f);
}

// A frame's standard error is that of frames of other seeds.
TEST(PathFrames, TellTheirNoise) {
  Scene scene = small_scene();
  scene.optics.albedo = {0.95, 0.6, 0.95};
  constexpr int seeds = 24;
  std::vector<Frame> frames;
  double airlight = 0.0;
  double picture = 0.0;
  for (int seed = 0; seed < seeds; ++seed) {
    Settings settings = path_traced(32);
    settings.path_seed = static_cast<std::uint64_t>(seed);
    frames.push_back(render_frame(scene, settings));
    const std::optional<RelativeNoise> noise = relative_noise(frames.back());
    ASSERT_TRUE(noise);
    EXPECT_EQ(noise->paths, 32);
    airlight += noise->airlight * noise->airlight / seeds;
    picture += noise->picture * noise->picture / seeds;
  }
  const auto scatter = [&](const std::vector<float> Frame::*layer, std::size_t stride) {
    double variance = 0.0;
    double square = 0.0;
    for (std::size_t i = 0; i < (frames[0].*layer).size(); ++i) {
      if (i % stride == 3) continue;
      double sum = 0.0;
      double squares = 0.0;
      for (const Frame& frame : frames) {
        const double x = (frame.*layer)[i];
        sum += x / seeds;
        squares += x * x / seeds;
      }
      variance += (squares - sum * sum) * seeds / (seeds - 1);
      square += squares;
    }
    return variance / square;
  };
  // 273 pixels in 24 frames tell it to a few percent.
  EXPECT_NEAR(airlight / scatter(&Frame::airlight, 3), 1.0, 0.12);
  EXPECT_NEAR(picture / scatter(&Frame::beauty, 4), 1.0, 0.12);
}

TEST(PathFrames, OnePathKnowsNoNoise) {
  const Scene scene = small_scene();
  EXPECT_FALSE(relative_noise(render_frame(scene, path_traced(1))));
  EXPECT_TRUE(relative_noise(render_frame(scene, path_traced(2))));
  EXPECT_FALSE(relative_noise(render_frame(scene, paper_settings)));
}

// Radiances along single rays by orders of scattering, against those of an independent program
// (tests/golden/multiple_scattering.json).

// The golden errors of order 1 are up to 0.2%, of weak orders up to 3%: more paths would tell
// nothing more within the time of a test. BRUME_MORE_PATHS multiplies them, and prints a table.
TEST(GoldenOrders, MatchThePathTracer) {
  const char* more = std::getenv("BRUME_MORE_PATHS");
  const int paths = 32'768 * (more ? std::max(1, std::atoi(more)) : 1);
  double chi_square = 0.0;
  int comparisons = 0;
  int seed = 0;
  for (const GoldenRay& ray : golden_rays()) {
    const TracedScene scene(ray.scene, ray.albedo);
    // Seeds of their own: chi square takes the rays for independent.
    const Camera& camera = ray.scene.camera;
    const TracedScene::Estimate got =
        scene.airlight(camera.eye, camera.target, paths, static_cast<std::uint64_t>(++seed));
    const auto compare = [&](const char* order, const PathEstimate& ours, double theirs,
                             double standard_error, double bound) {
      const double error = std::hypot(ours.error.x, standard_error);
      const double z = (ours.mean.x - theirs) / error;
      EXPECT_LT(std::abs(z), bound) << ray.name << ' ' << order << ": " << ours.mean.x << " +- "
                                    << ours.error.x << ", golden " << theirs;
      if (more) {
        std::printf("%-30s %-15s %.6g +- %.2g golden %.6g z %+.2f\n", ray.name.c_str(), order,
                    ours.mean.x, ours.error.x, theirs, z);
      }
      return z;
    };
    constexpr const char* orders[] = {"order 1", "order 2", "order 3 and up"};
    for (std::size_t i = 0; i < 3; ++i) {
      // One in 16,000 is farther off.
      const double z = compare(orders[i], got.orders[i], ray.orders[i], ray.order_errors[i], 4.0);
      chi_square += z * z;
      ++comparisons;
    }
    compare("all", got.sum, ray.radiance, ray.standard_error, 3.0);
  }
  ASSERT_EQ(comparisons, 60);
  // 60 expected, with a standard deviation of 11.
  EXPECT_LT(chi_square, 60.0 + 3.0 * std::sqrt(2.0 * 60.0));
  if (more) std::printf("chi square of %d orders: %.1f\n", comparisons, chi_square);
}

}  // namespace

}  // namespace brume
