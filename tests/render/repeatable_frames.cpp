#include "tests/render/repeatable_frames.h"

#include <gtest/gtest.h>

#include <cstring>
#include <glm/vec3.hpp>
#include <string>

#include "brume/at_time.h"
#include "brume/edits.h"
#include "tests/fog_bank.h"
#include "tests/render/test_scenes.h"

namespace brume {
namespace {

constexpr int frame_count = 5;

// A few Gaussians of many move, as in an edit, so that a renderer could patch what it has.
Scene scene_at(int frame) {
  Scene scene = on_film(cloud_scene(60, 2.0), {37, 29});
  scene.camera.eye += glm::dvec3(0.3 * frame, 0.1 * frame, -0.05 * frame);
  scene.medium.set_homogeneous_density(0.02);
  scene.environment = even_sky(0.3f);
  Light light;
  light.position = {-1.5 + 0.2 * (frame / 2), 1.2, 1.4};
  light.intensity = {3.0, 4.0, 5.0};
  scene.lights.push_back(light);
  scene.surfaces.push_back(wall(-1.0, 2.0));
  scene.surfaces.push_back(ball_surface(16, 0.4, {0.1 * (frame / 3), -0.5, 0.3}));
  const std::vector<GaussianId> ids{scene.medium.ids()[2], scene.medium.ids()[30]};
  std::vector<Gaussian> moved{scene.medium.gaussian(2), scene.medium.gaussian(30)};
  moved[0].center.x += 0.07 * frame;
  moved[1].density *= 1.0 + 0.2 * frame;
  MediumEdit::change(scene.medium, ids, moved).apply(scene.medium);
  return scene;
}

bool are_same_bits(const std::vector<float>& a, const std::vector<float>& b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(float)) == 0;
}

void expect_same_bits(const Frame& a, const Frame& b, const std::string& what) {
  EXPECT_TRUE(are_same_bits(a.beauty, b.beauty)) << what << ": beauty";
  EXPECT_TRUE(are_same_bits(a.airlight, b.airlight)) << what << ": airlight";
  EXPECT_TRUE(are_same_bits(a.transmittance, b.transmittance)) << what << ": transmittance";
  EXPECT_TRUE(are_same_bits(a.depth, b.depth)) << what << ": depth";
}

// Two frames of Gaussians that drift and thin out.
MediumSequence drifting_sequence() {
  std::vector<SequenceFrame> frames(2);
  frames[0].gaussians = fog_bank(3'000, 0.3, 2);
  for (std::size_t i = 0; i < frames[0].gaussians.size(); ++i) {
    frames[0].ids.push_back(static_cast<GaussianNumber>(i));
  }
  frames[1] = frames[0];
  for (Gaussian& gaussian : frames[1].gaussians) {
    gaussian.center.x += 0.2;
    gaussian.density *= 0.5;
  }
  MediumSequence sequence;
  sequence.last = 1;
  sequence.frames_per_second = 1.0;
  sequence.frames = sequence_frames(std::move(frames));
  return sequence;
}

}  // namespace

std::vector<Scene> moving_scenes() {
  std::vector<Scene> scenes;
  for (int i = 0; i < frame_count; ++i) scenes.push_back(scene_at(i));
  return scenes;
}

std::vector<Scene> crowded_scenes() {
  Scene scene;
  scene.film = {32, 24};
  scene.camera.eye = {0.0, 0.0, 5.0};
  scene.medium = medium_of(fog_bank(40'000, 1.0, 1));
  scene.lights.push_back({.position = {2.0, 2.0, 1.0}, .intensity = glm::dvec3(20.0)});
  Emitter& emitter = scene.emitters.emplace_back();
  emitter.rate = 40.0;
  scene.sequences.push_back(drifting_sequence());
  std::vector<Scene> scenes;
  for (int i = 0; i < frame_count; ++i) scenes.push_back(evaluate_at(scene, 0.2 * i));
  return scenes;
}

void expect_repeatable(const std::function<std::unique_ptr<FrameRenderer>()>& create_renderer,
                       Settings settings, const std::vector<Scene>& scenes) {
  const auto render = [&](FrameRenderer& renderer, int i) {
    const Scene& scene = scenes[static_cast<std::size_t>(i)];
    return render_frame(renderer, scene, settings);
  };
  std::vector<Frame> forwards;
  const auto expect_same = [&](FrameRenderer& renderer, int i, const char* order) {
    expect_same_bits(render(renderer, i), forwards[static_cast<std::size_t>(i)],
                     order + (", frame " + std::to_string(i)));
  };

  const auto first = create_renderer();
  for (int i = 0; i < frame_count; ++i) forwards.push_back(render(*first, i));
  for (int i = frame_count - 1; i >= 0; --i) expect_same(*first, i, "backwards");
  const auto other = create_renderer();
  for (int i = 3; i < frame_count; ++i) expect_same(*other, i, "second piece");
  for (int i = 0; i < 3; ++i) expect_same(*other, i, "first piece");
  for (int repeat = 0; repeat < 4; ++repeat) expect_same(*other, 2, "again");
  settings.threads = 1;
  const auto single = create_renderer();
  for (int i = 0; i < frame_count; i += 2) expect_same(*single, i, "one thread");
}

}  // namespace brume
