// Smooth surfaces mirror what is around them.

#include <gtest/gtest.h>

#include <glm/gtc/quaternion.hpp>
#include <utility>

#include "brume/frame.h"
#include "brume/render.h"
#include "render/layers/light_layers.h"
#include "tests/pictures.h"
#include "tests/render/test_scenes.h"

namespace brume {
namespace {

void make_metal(Surface& surface, double base_color, double roughness) {
  surface.material = metallic_roughness(glm::dvec3(base_color), 1.0, roughness);
}

// Boxes on a floor, lit from above.
Scene boxes_on_a_floor() {
  Scene scene =
      seen_by({.eye = {0.0, 1.0, 4.0}, .target = {0.0, 0.2, 0.0}, .vertical_fov = 50.0}, {48, 36});
  scene.surfaces = {placed(Primitive::Shape::plane, {12.0, 1.0, 12.0}, {0.0, 0.0, 0.0}),
                    placed(Primitive::Shape::box, {0.8, 1.0, 0.8}, {-0.8, 0.6, -0.5}),
                    placed(Primitive::Shape::box, {0.8, 1.6, 0.8}, {0.8, 0.9, -1.0})};
  scene.surfaces[1].material.reflectance = {0.8, 0.1, 0.1};
  scene.surfaces[2].material.reflectance = {0.1, 0.2, 0.8};
  Light light;
  light.position = {2.0, 3.0, 2.0};
  light.intensity = glm::dvec3(40.0);
  scene.lights = {light};
  return scene;
}

glm::vec3 pixel(const Frame& frame, int x, int y) {
  const auto i = 4 * static_cast<std::size_t>(y * frame.film.width + x);
  return {frame.beauty[i], frame.beauty[i + 1], frame.beauty[i + 2]};
}

// A white mirror shows what an eye below it sees where it is away.
TEST(Mirrors, ShowWhatAMirroredEyeSees) {
  Scene scene = boxes_on_a_floor();
  make_metal(scene.surfaces[0], 1.0, 0.0);
  const Frame mirrored = render_frame(scene, sliced(8));
  scene.surfaces[0].translate.y = -20.0;
  scene.surfaces[0].material.metallic_roughness.base_color = glm::dvec3(0.0);
  scene.camera.eye.y *= -1.0;
  scene.camera.target.y *= -1.0;
  const Frame from_below = render_frame(scene, sliced(8));
  int boxes = 0;
  for (int y = 24; y < 36; ++y) {
    for (int x = 0; x < 48; ++x) {
      const glm::vec3 seen = pixel(from_below, x, 35 - y);
      const glm::vec3 shown = pixel(mirrored, x, y);
      if (!(seen.x + seen.z > 0.05f) || !(shown.x + shown.z > 0.05f)) continue;
      ++boxes;
      EXPECT_NEAR(shown.x, seen.x, 0.01f * seen.x + 1e-4f) << x << " " << y;
      EXPECT_NEAR(shown.z, seen.z, 0.01f * seen.z + 1e-4f) << x << " " << y;
    }
  }
  EXPECT_GT(boxes, 40);
}

double mean_difference(const Frame& a, const Frame& b, int first_row) {
  double difference = 0.0;
  double sum = 0.0;
  for (int y = first_row; y < a.film.height; ++y) {
    for (int x = 0; x < a.film.width; ++x) {
      difference += static_cast<double>(pixel(a, x, y).x - pixel(b, x, y).x);
      sum += static_cast<double>(pixel(b, x, y).x);
    }
  }
  return difference / sum;
}

// Narrower highlights of a point light are rare, bright paths. With a roughness of 0.2 this is 3.2%
// too bright at any number of nodes (300,000: 3.2%, 20,000: 3.5%); border nodes that were too dark
// hid a half of it.
TEST(Mirrors, AreAsBrightInFogAsPathsHaveThem) {
  for (const double roughness : {0.2, 0.45}) {
    Scene scene = in_fog(boxes_on_a_floor(), 0.05);
    scene.optics.albedo = glm::dvec3(0.7);
    make_metal(scene.surfaces[0], 0.8, roughness);
    const Frame mirrored = render_frame(scene, all_orders(24, {.nodes = 20'000}));
    const Frame paths = render_frame(scene, path_traced(48));
    EXPECT_NEAR(mean_difference(mirrored, paths, 22), 0.0, 0.04) << roughness;
  }
}

// A glowing wall and a gray sky around what is mirrored.
Scene glowing_wall(Surface mirror, double roughness) {
  Scene scene =
      seen_by({.eye = {0.0, 1.2, 4.0}, .target = {0.0, 0.3, 0.0}, .vertical_fov = 40.0}, {32, 24});
  scene.surfaces = {std::move(mirror),
                    placed(Primitive::Shape::box, {1.5, 3.0, 0.1}, {0.3, 1.6, -1.5})};
  make_metal(scene.surfaces[0], 0.9, roughness);
  make_metal(scene.surfaces[1], 0.0, 1.0);
  scene.surfaces[1].material.metallic_roughness.emissive = glm::dvec3(2.0);
  scene.environment = even_sky(0.3f);
  return scene;
}

double error_beside_paths(const Scene& scene, int samples) {
  Settings settings = sliced(8);
  Settings paths = path_traced(512);
  settings.samples = paths.samples = samples;
  return rel_rmse(render_frame(scene, settings).beauty, render_frame(scene, paths).beauty);
}

// Neighbours share the rays of wide highlights, not what they reflect: textures stay sharp.
TEST(Mirrors, KeepTheTexturesOfMetals) {
  Scene scene =
      glowing_wall(placed(Primitive::Shape::plane, {4.0, 1.0, 4.0}, {0.0, 0.0, 0.0}), 0.3);
  scene.surfaces[0].material.metallic_roughness.base_color_texture = {
      "a.png", picture(8, [](int x, int y) { return (x + y) % 2 == 0 ? 0xffffffu : 0x202020u; })};
  scene.film = {64, 48};  // blocks of 4 x 4 pixels widen the image of the wall less
  EXPECT_LT(error_beside_paths(scene, 1), 0.07);
}

// The faces of one mesh mirror different parts of the scene, also where samples of a pixel see
// both.
TEST(Mirrors, KeepTheEdgesOfAMesh) {
  Surface box = placed(Primitive::Shape::box, {1.6, 1.0, 1.6}, {0.0, 0.3, 0.6});
  box.rotate = glm::angleAxis(0.6, glm::dvec3(0.0, 1.0, 0.0));
  EXPECT_LT(error_beside_paths(glowing_wall(box, 0.3), 16), 0.06);
}

// A surface that curves within a few pixels has few neighbours to share with.
TEST(Mirrors, AreSharpOnSmallBalls) {
  const Surface ball = placed(Primitive::Shape::sphere, glm::dvec3(1.4), {0.0, 0.5, 0.8});
  EXPECT_LT(error_beside_paths(glowing_wall(ball, 0.17), 1), 0.12);
}

// A surface that emits is seen in them, and makes no highlights beside that.
TEST(Mirrors, ShowWhatEmitsOnce) {
  Scene scene = boxes_on_a_floor();
  scene.lights.clear();
  make_metal(scene.surfaces[0], 0.8, 0.1);
  make_metal(scene.surfaces[1], 0.0, 1.0);
  scene.surfaces[1].material.metallic_roughness.emissive = glm::dvec3(3.0);
  const Frame mirrored = render_frame(scene, all_orders(8));
  const Frame paths = render_frame(scene, path_traced(256));
  EXPECT_NEAR(mean_difference(mirrored, paths, 20), 0.0, 0.03);
}

TEST(Mirrors, OfEachOtherEnd) {
  Scene scene = in_fog(boxes_on_a_floor(), 0.05);
  for (Surface& surface : scene.surfaces) make_metal(surface, 1.0, 0.0);
  expect_finite(render_frame(scene, all_orders(8)));
}

// A mirror adds as much to the airlight as paths have it.
TEST(Mirrors, SendLightIntoTheFog) {
  Scene scene = on_film(in_fog(boxes_on_a_floor(), 0.02), {24, 18});
  scene.optics.albedo = glm::dvec3(0.8);  // paths end sooner
  scene.surfaces.resize(1);
  scene.camera = {.eye = {0.0, 2.0, 4.0}, .target = {0.0, 2.0, 0.0}, .vertical_fov = 30.0};
  const auto airlight = [&](double base_color, const Settings& settings) {
    make_metal(scene.surfaces[0], base_color, 0.2);
    return mean_airlight(scene, settings);
  };
  const auto added = [&](const Settings& settings) {
    return airlight(1.0, settings) - airlight(0.0, settings);
  };
  EXPECT_NEAR(added(sliced(24, Scattering::multiple)) / added(path_traced(64)), 1.0, 0.05);
}

Frame with_reflection(const Scene& scene, RenderRequest request) {
  request.layers.reflection = true;
  return render(scene, request).value();
}

RenderRequest sliced_once(int samples) {
  RenderRequest request;
  request.airlight = AirlightMethod::sliced;
  request.slices = 8;
  request.scattering = Scattering::single;
  request.samples = samples;
  return request;
}

const std::vector<float>& reflection(const Frame& frame, const char* channel = "R") {
  return frame.layers.channels.at(std::string("reflection.") + channel);
}

double mean_reflection(const Frame& frame) {
  double sum = 0.0;
  for (const float value : reflection(frame)) sum += static_cast<double>(value);
  return sum / static_cast<double>(frame.depth.size());
}

// A smooth floor that is not only a mirror, which shows boxes above the picture.
Scene floor_before_boxes() {
  Scene scene = boxes_on_a_floor();
  scene.camera.target = {0.0, 0.0, 2.5};
  scene.camera.vertical_fov = 30.0;
  make_metal(scene.surfaces[0], 0.5, 0.1);
  scene.surfaces[0].material.metallic_roughness.metallic = 0.3;
  return scene;
}

// The picture is the layer and what is left where all that is mirrored is black.
TEST(ReflectionLayer, IsWhatMirrorsAddToThePicture) {
  for (const int samples : {1, 16}) {
    Scene scene = floor_before_boxes();
    const Frame whole = with_reflection(scene, sliced_once(samples));
    EXPECT_EQ(whole.beauty, render(scene, sliced_once(samples)).value().beauty);
    for (const std::size_t box : {1u, 2u}) scene.surfaces[box].material.reflectance *= 0.0;
    const Frame without = with_reflection(scene, sliced_once(samples));
    double sum = 0.0;
    double largest = 0.0;
    double error = 0.0;
    for (std::size_t i = 0; i < whole.depth.size(); ++i) {
      ASSERT_TRUE(std::isfinite(whole.depth[i]));
      EXPECT_EQ(reflection(without)[i], 0.0f);
      const double picture = whole.beauty[4 * i];
      const double made = without.beauty[4 * i] + reflection(whole)[i];
      error = std::max(error, std::abs(made - picture));
      largest = std::max(largest, picture);
      sum += static_cast<double>(reflection(whole)[i]);
    }
    // Each frame takes several samples where it has edges.
    EXPECT_LT(error, (samples == 1 ? 1e-6 : 0.02) * largest) << samples;
    EXPECT_GT(sum, 10.0 * error) << samples;
  }
}

// Not what else is seen: rough surfaces, the sky behind all, a light.
TEST(ReflectionLayer, IsBlackButOnSmoothSurfaces) {
  Scene scene = boxes_on_a_floor();
  scene.environment = even_sky(0.3f);
  Light ball;
  ball.kind = light::Sphere{.radius = 0.2, .visible = true};
  ball.position = {0.0, 1.0, 0.0};
  ball.intensity = glm::dvec3(5.0);
  scene.lights.push_back(ball);
  make_metal(scene.surfaces[0], 0.8, 0.1);
  const Frame smooth = with_reflection(scene, sliced_once(1));
  int black = 0;
  int floor = 0;
  for (int y = 0; y < 36; ++y) {
    for (int x = 0; x < 48; ++x) {
      const auto i = static_cast<std::size_t>(48 * y + x);
      const bool is_above = y < 12;  // boxes, the ball and the sky
      if (is_above) {
        EXPECT_EQ(reflection(smooth)[i], 0.0f) << x << " " << y;
      }
      black += is_above && smooth.beauty[4 * i] > 0.1f;
      floor += y > 30 && reflection(smooth, "B")[i] > 0.1f;
    }
  }
  EXPECT_GT(black, 300);
  EXPECT_GT(floor, 200);

  make_metal(scene.surfaces[0], 0.8, 0.51);
  OutputLayers layers;
  layers.reflection = true;
  EXPECT_EQ(mean_reflection(with_reflection(scene, sliced_once(1))), 0.0);
  EXPECT_EQ(light_layer_frames(scene, sliced(8), layers), 0u);
  EXPECT_EQ(light_layer_frames(scene, path_traced(8), layers), 0u);
  make_metal(scene.surfaces[0], 0.8, 0.49);
  EXPECT_EQ(light_layer_frames(scene, sliced(8), layers), 1u);
  EXPECT_EQ(light_layer_frames(scene, path_traced(8), layers), 1u);
  EXPECT_EQ(light_layer_frames(scene, reference_settings(), layers), 0u);
}

// Through fog and a pane, and of the same light in both methods.
TEST(ReflectionLayer, IsThatOfPaths) {
  Scene scene = in_fog(
      glowing_wall(placed(Primitive::Shape::plane, {4.0, 1.0, 4.0}, {0.0, 0.0, 0.0}), 0.3), 0.1);
  scene.optics.albedo = glm::dvec3(0.5);
  scene.surfaces[0].material.metallic_roughness.metallic = 0.5;
  RenderRequest sliced = sliced_once(1);
  sliced.slices = 24;
  sliced.scattering = Scattering::multiple;
  RenderRequest paths;
  paths.airlight = AirlightMethod::path;
  paths.paths = 64;
  paths.samples = 1;
  const auto mean = [&](const RenderRequest& request) {
    return mean_reflection(with_reflection(scene, request));
  };
  EXPECT_NEAR(mean(sliced) / mean(paths), 1.0, 0.03);

  // The pane is before the eye: it takes a half of what is seen, and shows nothing itself. In fog
  // the grid of its light sees the pane, too.
  scene.medium = {};
  Surface pane = wall(0.0, 0.2);
  pane.translate = {0.0, 1.2, 3.8};
  make_metal(pane, 0.0, 1.0);
  pane.material.metallic_roughness.alpha = AlphaMode::blend;
  pane.material.metallic_roughness.opacity = 0.5;
  scene.surfaces[0].material.metallic_roughness.roughness = 0.1;  // one ray a pixel
  for (const RenderRequest& request : {sliced, paths}) {
    const double open = mean(request);
    scene.surfaces.push_back(pane);
    EXPECT_NEAR(mean(request) / open, 0.5, 0.01);
    scene.surfaces.pop_back();
  }
}

}  // namespace
}  // namespace brume
