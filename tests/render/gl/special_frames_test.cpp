// Scenes of one special thing each, by light scattered once and any number of times: the device
// renders them as the CPU does.

#include <gtest/gtest.h>

#include "core/scene/fields/light_fields.h"
#include "tests/pictures.h"
#include "tests/random.h"
#include "tests/render/fog_ball_frames.h"
#include "tests/render/gl/gl_frames.h"
#include "tests/render/test_scenes.h"
#include "tools/bench/scenes/benchmark_scenes.h"

namespace brume::gl {
namespace {

struct SpecialScene {
  std::string name;
  Scene scene;
  bool once = true, all_orders = true;  // which light is compared
};

Scene before_a_wall(Scene scene, double z = -0.8, double side = 1.5) {
  scene.surfaces.push_back(wall(z, side));
  return scene;
}

const Light spot{{0.9, 1.4, 0.6}, glm::dvec3(6.0), light::Spot{{-0.9, -1.4, -0.9}, 25.0, 40.0}};

// Gaussians, of which some have an albedo and some an emission.
Scene with_optics(Scene scene, std::size_t albedo_every, std::size_t emission_every) {
  std::size_t index = 0;
  scene.medium = scene.medium.changed(scene.medium.homogeneous_density(), [&](Gaussian g) {
    if (index % albedo_every == 0) g.optics.albedo = {0.9, 0.3, 0.2};
    if (index++ % emission_every == 0) g.optics.emission = {3.0, 1.0, 0.2};
    return g;
  });
  return scene;
}

Scene in_parallel(Scene scene) {
  scene = on_film(in_fog(scene, 0.02), {32, 24});
  scene.camera.eye = {1.5, 2.0, 4.0};
  scene.camera.target = {0.1, 0.0, 0.0};
  scene.camera.height = 2.6;
  return scene;
}

// Most memory of a work group is asked for by ellipsoids with optics of their own.
void add_ellipsoids(std::vector<SpecialScene>& all) {
  const Scene thin = on_film(in_fog(ellipsoid_scene(20, 2.0, 12.0), 0.02), {32, 24});
  all.push_back({"ellipsoids", before_a_wall(thin, -0.6, 1.2)});
  const Scene parallel = with_optics(in_parallel(ellipsoid_scene(20, 2.0, 8.0)), 2, 2);
  all.push_back({"ellipsoids with optics in parallel", before_a_wall(parallel, -0.6, 1.2)});
}

void add_orthographic_cameras(std::vector<SpecialScene>& all) {
  const Scene cloud = in_parallel(cloud_scene(20, 2.0));
  all.push_back({"in parallel", before_a_wall(cloud, -0.6, 1.2)});
  // Rays begin at the plane of the eye, in the middle of all.
  Scene within = cloud;
  within.camera.eye = cloud.camera.target + 0.05 * (cloud.camera.eye - cloud.camera.target);
  all.push_back({"in parallel, from within", within, true, false});
  Scene noisy = cloud;
  noisy.optics.noise = {.amplitude = 0.4, .frequency = 2.0};
  all.push_back({"noise in parallel", noisy, true, false});
  for (const double anisotropy : {0.6, -0.4}) {
    Scene below_sky = before_a_wall(cloud, -0.6, 1.2);
    below_sky.environment = even_sky(0.3f);
    below_sky.optics.anisotropy = anisotropy;
    below_sky.lights.push_back(spot);
    all.push_back({"in parallel under a sky", below_sky, false, true});
  }
}

// Seen from outside and from within, with walls before it, in it and behind it; and among Gaussians
// under a sky, whose light on surfaces goes through the average depth or the grid.
void add_balls(std::vector<SpecialScene>& all) {
  for (const bool is_within : {false, true}) {
    Scene scene = is_within ? fog_ball_scene({0.2, 0.3, 0.5}) : fog_ball_between_walls();
    scene.optics.anisotropy = 0.4;
    scene.lights = {{{1.5, 2.0, 0.5}, {10, 10, 10}, {}},
                    {{}, {6, 6, 6}, light::Directional{{-0.9, -1.4, -0.6}}}};
    all.push_back({is_within ? "a ball from within" : "a ball between walls", scene});
  }
  Scene scene = in_fog(on_film(cloud_scene(10, 0.5), {32, 24}), 0.5);
  scene.optics.extent = 1.2;
  scene.optics.anisotropy = 0.6;
  scene.environment.emplace().map = constant_sky(1.0f);
  all.push_back({"a ball under a sky", before_a_wall(scene, -1.0, 0.5)});
}

// A sky's light that the forward lobe scatters: in fog along view rays, beside surfaces as nodes
// hold it; and light of all orders without a sky.
void add_phase_functions(std::vector<SpecialScene>& all) {
  for (const double anisotropy : {-0.6, 0.6, 0.9}) {
    Scene scene = on_film(in_fog(cloud_scene(10, 2.0), 0.05), {16, 12});
    scene.optics.anisotropy = anisotropy;
    scene.environment.emplace().map = smooth_sky();
    const std::string name = "a sky, g = " + std::to_string(anisotropy);
    all.push_back({name, scene});
    all.push_back({name + ", before a wall", before_a_wall(scene)});
  }
  for (const double anisotropy : {0.0, 0.6, 0.85}) {
    Scene scene = on_film(cloud_scene(10, 3.0), {16, 12});
    scene.optics.anisotropy = anisotropy;
    scene.optics.albedo = glm::dvec3(0.9);
    all.push_back({"a cloud, g = " + std::to_string(anisotropy), scene, false, true});
  }
}

// Beams in the medium and on surfaces, lights with profiles, a picture in a beam.
void add_beams(std::vector<SpecialScene>& all) {
  std::vector<Light> profiles{spot,
                              {{-0.3, 1.0, 0.7}, {2.0, 3.0, 4.0}},
                              {{0.5, 0.5, 1.5}, glm::dvec3(1.0)},
                              {{0.6, 1.0, 0.0}, glm::dvec3(1.0)}};
  *profile_member(profiles[0]) = lobed_profile(70.0);
  *profile_member(profiles[1]) = cosine_profile();
  *profile_member(profiles[3]) = *profile_member(profiles[1]);
  std::vector<Light> picture{profiles[0], profiles[1]};
  *profile_member(picture[0]) = {};
  picture[0].as<light::Spot>()->texture = {
      .file = "a.png", .content = quadrants_picture(), .rotation = 30.0};
  const std::vector<Light> spots{
      {{0.9, 1.4, 0.6}, glm::dvec3(6.0), light::Spot{{-0.9, -1.4, -0.9}, 5.0, 20.0}},
      {{-1.0, 0.4, 1.0}, glm::dvec3(2.0), light::Spot{{1.0, -0.3, -1.2}, 9.8, 10.0}},
      {{0.0, -1.0, 0.5}, glm::dvec3(1.0), light::Spot{{0.0, 1.0, 0.0}, 60.0, 130.0}},
      {{1.0, 0.4, 1.0}, glm::dvec3(9.0), light::Spot{{-1.0, -0.3, -1.2}, 0.5, 1.0}},
      {{0.5, 0.5, 1.5}, glm::dvec3(1.0), {}}};
  for (const auto& [name, lights] :
       {std::pair("spots", spots), {"profiles", profiles}, {"a picture and a profile", picture}}) {
    Scene scene = before_a_wall(on_film(in_fog(cloud_scene(10, 2.0), 0.02), {24, 18}));
    scene.lights = lights;
    all.push_back({name, scene});
  }
}

void add_suns_and_areas(std::vector<SpecialScene>& all) {
  for (const double b0 : {0.0, 0.05}) {
    const Scene alone = before_a_wall(on_film(in_fog(cloud_scene(10, 2.0), b0), {24, 18}));
    Scene with_optics_of_its_own = with_optics(alone, 3, 4);
    with_optics_of_its_own.optics.anisotropy = 0.5;
    with_optics_of_its_own.lights.push_back(spot);
    all.push_back({"Gaussians with optics", with_optics_of_its_own});
    // One wall shades the medium and the other.
    Scene scene = before_a_wall(alone, 0.0, 0.4);
    scene.surfaces[1].translate = {0.5, 1.0, 0.3};
    scene.lights = {
        {.intensity = {3.0, 2.0, 1.0}, .kind = light::Directional{{-0.9, -1.4, -0.9}}},
        {.intensity = glm::dvec3(0.5), .kind = light::Directional{{1.0, 0.2, -0.4}, 3.0}},
        {{0.5, 0.5, 1.5}, glm::dvec3(1.0)}};
    all.push_back({"suns", scene});
    scene.surfaces[1].holdout = true;
    scene.optics.albedo = {1.0, 0.8, 0.5};
    all.push_back({"a wall that is held out", scene, true, false});
    // Two at a time: a software device ends shaders that go through some 900 lights and slices.
    const Light disk{{-1.5, 0.5, 0.5}, glm::dvec3(2.0), light::Disk{{1.0, 0.1, -0.3}, 0.3, true}};
    const Light sphere{{0.0, -1.0, 0.5}, glm::dvec3(1.0), light::Sphere()};
    scene.lights = {disk, sphere};
    all.push_back({"a disk and a sphere", scene, true, false});
    scene.lights[0] = {
        {1.5, 1.5, 1.0}, {3.0, 2.0, 1.0}, light::Rectangle{.direction = {-1.0, -1.0, -0.7}}};
    all.push_back({"a rectangle and a sphere", scene, false, true});
  }
}

TEST_F(GlFrames, SpecialScenes) {
  std::vector<SpecialScene> all;
  add_ellipsoids(all);
  add_orthographic_cameras(all);
  add_balls(all);
  add_phase_functions(all);
  add_beams(all);
  add_suns_and_areas(all);
  for (const SpecialScene& special : all) {
    SCOPED_TRACE(special.name);
    const Scene scene = on_film(special.scene, {20, 15});  // two by two tiles
    if (special.once) expect_backends_agree(scene, Scattering::single);
    if (special.all_orders) expect_backends_agree(scene, Scattering::multiple);
  }
}

// Ellipsoids with noise, in parallel too, with improvements and without; a ball of fog under a sky.
TEST_F(GlFrames, SpecialScenesByThePaper) {
  for (const bool is_improved : {false, true}) {
    Scene scene = on_film(ellipsoid_scene(20, 2.0, 12.0, 2), {32, 24});
    scene.optics.noise = {.amplitude = 0.4, .frequency = 2.0};
    Settings settings = paper_settings;
    settings.paper = {is_improved, is_improved};
    for (const Scene& seen : {scene, in_parallel(scene)}) {
      const Frame cpu = render_frame(seen, settings);
      EXPECT_LE(rel_rmse(render_on_device(seen, settings, "paper").airlight, cpu.airlight), 1e-3);
    }
  }
  std::vector<SpecialScene> balls;
  add_balls(balls);
  const Scene& below_sky = balls.back().scene;
  const Frame cpu = render_frame(below_sky, paper_settings);
  EXPECT_LE(rel_rmse(render_on_device(below_sky, paper_settings, "ball").beauty, cpu.beauty), 2e-3);
}

TEST_F(GlFrames, FogInABallIsThePlainIntegral) {
  for (const bool is_within : {false, true}) {
    Scene scene = is_within ? fog_ball_scene({0.2, 0.3, 0.5}) : fog_ball_scene();
    scene.lights = {{{1.5, 2.0, 0.5}, {10, 10, 10}, {}}, {{0.2, 0.4, -0.3}, {5, 5, 5}, {}}};
    const Frame frame =
        render_on_device(scene, is_within ? quick_slices() : paper_settings, "ball");
    EXPECT_LT(scattered_once_error(scene, frame), is_within ? 0.01 : 0.003);
    EXPECT_LT(fog_transmittance_error(scene, frame), 1e-4);
  }
}

// The eye and the light among needles and discs.
TEST_F(GlFrames, EllipsoidsAllAround) {
  Scene scene = on_film(ellipsoid_scene(16, 2.0, 200.0, 3), {32, 24});
  scene.camera.eye = {0.2, 0.1, 0.6};
  scene.lights[0].position = {-0.3, 0.2, -0.4};
  const Frame cpu = render_frame(scene, quick_slices());
  // Needles of less than a pixel differ by the rounding of single precision.
  const Frame gl = render_on_device(scene, quick_slices(), "among them");
  EXPECT_LE(rel_rmse(gl.airlight, cpu.airlight), 1e-2);
}

// Ellipsoids as thin as may be: nothing is cut off where the lists of tiles end, and what is deep
// along the disc only is light in the middle of no slice but where it lies.
TEST_F(GlFrames, ThinDiscs) {
  Scene scene = cloud_scene(1, 1.0);
  Medium discs;
  Random random(4);
  for (int i = 0; i < 12; ++i) {
    Gaussian g{random.point(0.6), 1.0, 0.0};
    const glm::dvec3 q = random.point(1.0);
    const double thin = random.power(-4.0, -3.0);
    g.set_radii({0.4, 0.4, 0.4 * thin}, glm::dquat(random.uniform(-1.0, 1.0), q.x, q.y, q.z));
    g.density = 0.05 / (0.4 * thin);
    discs.append(g);
  }
  scene.medium = discs;
  scene.film = {96, 72};
  const Frame cpu = render_frame(scene, quick_slices());
  const Frame gl = render_on_device(scene, quick_slices(), "thin discs");
  // Single precision knows the thinnest that are seen edge-on, or lit so, to a part in a thousand.
  EXPECT_LE(rel_rmse(gl.airlight, cpu.airlight), 2e-2);
  EXPECT_LE(rel_rmse(gl.transmittance, cpu.transmittance), 5e-4);
}

}  // namespace
}  // namespace brume::gl
