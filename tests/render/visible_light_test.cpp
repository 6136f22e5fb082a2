// Lights whose shapes are seen.

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "brume/frame.h"
#include "core/scene/fields/light_fields.h"
#include "core/scene/lights/point_lights.h"
#include "render/layers/surface_layers.h"
#include "render/visibility/light_shapes.h"
#include "render/visibility/ray_caster.h"
#include "tests/render/coverage_scenes.h"
#include "tests/render/test_scenes.h"

namespace brume {
namespace {

const glm::dvec3 radiance(6.0, 3.0, 1.5);

Light light_of(const Light::Kind& kind, const glm::dvec3& position) {
  Light light{.position = position, .intensity = radiance, .kind = kind};
  *find_value<bool>(light, "visible") = true;
  return light;
}
Light panel() {
  return light_of(light::Rectangle{.direction = {0.0, -0.2, 1.0}, .width = 1.2, .height = 0.7},
                  {-0.7, 1.3, 0.0});
}
Light ball() {
  return light_of(light::Sphere{.radius = 0.35}, {0.9, 1.2, 0.2});
}

Material metal(double base_color, double roughness) {
  return metallic_roughness(glm::dvec3(base_color), 1.0, roughness);
}

// Both above a floor before a wall.
Scene lights_above_a_floor() {
  Scene scene =
      seen_by({.eye = {0.0, 1.0, 5.0}, .target = {0.0, 0.7, 0.0}, .vertical_fov = 42.0}, {64, 48});
  scene.surfaces = {placed(Primitive::Shape::plane, {12.0, 1.0, 12.0}, {0.0, 0.0, 0.0}),
                    placed(Primitive::Shape::box, {12.0, 8.0, 0.1}, {0.0, 4.0, -2.0})};
  scene.lights = {panel(), ball()};
  return scene;
}

Scene with_hidden(Scene scene) {
  for (Light& light : scene.lights) *find_value<bool>(light, "visible") = false;
  return scene;
}

glm::vec3 color(const std::vector<float>& layer, std::size_t pixel, std::size_t channels) {
  const float* const first = layer.data() + channels * pixel;
  return {first[0], first[1], first[2]};
}

// The light that a pixel sees; -1: none.
std::vector<int> seen_lights(const Scene& scene) {
  const LightShapes shapes(scene.lights);
  const RayCaster ray_caster(scene.surfaces);
  const CameraRays rays(scene.camera, scene.film);
  std::vector<int> seen;
  for (int y = 0; y < scene.film.height; ++y) {
    for (int x = 0; x < scene.film.width; ++x) {
      SurfaceHit hit = ray_caster.first_hit(rays, x + 0.5, y + 0.5);
      shapes.meet(rays.origin(x + 0.5, y + 0.5), rays.direction(x + 0.5, y + 0.5), hit);
      seen.push_back(hit.is_light() ? static_cast<int>(shapes.of(hit).light) : -1);
    }
  }
  return seen;
}

TEST(LightShapes, EndRaysWhereSomethingShines) {
  const std::vector<Light> lights{panel(), ball()};
  const LightShapes shapes(lights);
  const auto met = [&](const glm::dvec3& origin, const glm::dvec3& target, double surface) {
    SurfaceHit hit{.distance = surface, .surface = std::isfinite(surface) ? 3 : -1};
    shapes.meet(origin, glm::normalize(target - origin), hit);
    return hit;
  };
  const double infinite = std::numeric_limits<double>::infinity();
  const glm::dvec3 eye(0.0, 1.0, 5.0);
  const glm::dvec3 middle = lights[0].position;
  EXPECT_EQ(met(eye, middle, infinite).light(), 0u);
  EXPECT_NEAR(met(eye, middle, infinite).distance, glm::distance(eye, middle), 1e-12);
  EXPECT_EQ(met(eye, lights[1].position, infinite).light(), 1u);
  EXPECT_NEAR(met(eye, lights[1].position, infinite).distance,
              glm::distance(eye, lights[1].position) - 0.35, 1e-12);
  EXPECT_FALSE(met(eye, {0.0, 1.2, 0.0}, infinite)) << "between them";
  EXPECT_EQ(met(eye, middle, 4.0).surface, 3) << "a surface is nearer";
  EXPECT_TRUE(met(eye, middle, glm::distance(eye, middle)).is_light()) << "it lies on one";
  EXPECT_FALSE(met({-0.7, 1.0, -5.0}, middle, infinite)) << "its back";
  EXPECT_FALSE(met(lights[1].position, eye, infinite)) << "from within";

  std::vector<Light> others = lights;
  others[0].on = false;
  *find_value<bool>(others[1], "two_sided") = true;
  const LightShapes two_sided(others);
  SurfaceHit within;
  two_sided.meet(lights[1].position, {0.0, 0.0, 1.0}, within);
  EXPECT_NEAR(within.distance, 0.35, 1e-12);
  SurfaceHit off;
  two_sided.meet(eye, glm::normalize(middle - eye), off);
  EXPECT_FALSE(off);
}

// Rays of a tile together are those one by one, parallel ones too.
TEST(LightShapes, MeetTilesOfRays) {
  const LightShapes shapes(lights_above_a_floor().lights);
  for (const bool is_parallel : {false, true}) {
    Scene scene = lights_above_a_floor();
    if (is_parallel) scene.camera.height = 4.0;
    const CameraRays rays(scene.camera, scene.film);
    int met = 0;
    for (int y = 0; y < scene.film.height; ++y) {
      std::vector<glm::dvec3> directions, offsets;
      for (int x = 0; x < scene.film.width; ++x) {
        directions.push_back(rays.direction(x + 0.5, y + 0.5));
        if (is_parallel) offsets.push_back(rays.offset(x + 0.5, y + 0.5));
      }
      std::vector<SurfaceHit> hits(directions.size());
      shapes.meet(rays.eye(), directions, offsets, hits);
      for (std::size_t k = 0; k < hits.size(); ++k) {
        SurfaceHit alone;
        shapes.meet(is_parallel ? rays.eye() + offsets[k] : rays.eye(), directions[k], alone);
        EXPECT_EQ(hits[k].surface, alone.surface);
        if (hits[k]) ++met;
      }
    }
    EXPECT_GT(met, 100);
  }
}

// A mirror, and the eye itself, see them as they see surfaces that emit as much, before a wall that
// shines.
TEST(VisibleLights, LookLikeSurfacesThatEmit) {
  Scene scene = lights_above_a_floor();
  scene.surfaces[0].material = metal(1.0, 0.0);
  scene.surfaces[1].material = metal(0.0, 1.0);
  scene.surfaces[1].material.metallic_roughness.emissive = glm::dvec3(2.0);
  const std::vector<int> seen = seen_lights(scene);
  Settings settings = sliced(8);
  settings.samples = 1;
  const Frame frame = render_frame(scene, settings);

  Scene emitting = scene;
  emitting.lights.clear();
  Surface plane = placed(Primitive::Shape::plane, {1.2, 1.0, 0.7}, scene.lights[0].position);
  // From +y to the panel's normal, about x.
  const glm::dvec3 normal = glm::normalize(std::get<light::Rectangle>(panel().kind).direction);
  plane.rotate = glm::angleAxis(std::acos(normal.y), glm::dvec3(1.0, 0.0, 0.0));
  Surface sphere = placed(Primitive::Shape::sphere, glm::dvec3(0.7), scene.lights[1].position);
  for (Surface* surface : {&plane, &sphere}) {
    surface->material = metal(0.0, 1.0);
    surface->material.metallic_roughness.emissive = radiance;
    emitting.surfaces.push_back(*surface);
  }
  const Frame truth = render_frame(emitting, settings);

  // The rays of a highlight leave a percent of it to the light's points, which a mirror's narrow
  // lobe misses or meets.
  constexpr float share_of_points = 0.02f;
  const float brightest = glm::length(glm::vec3(radiance));
  int direct = 0, mirrored = 0, outlines = 0;
  for (std::size_t i = 0; i < seen.size(); ++i) {
    const glm::vec3 shown = color(frame.beauty, i, 4);
    const glm::vec3 expected = color(truth.beauty, i, 4);
    if (seen[i] >= 0) {
      EXPECT_EQ(shown, glm::vec3(radiance));
      ++direct;
    }
    if (glm::distance(shown, expected) > share_of_points * brightest) {
      ++outlines;
    } else if (seen[i] < 0 && glm::length(shown) > 0.9f * brightest) {
      ++mirrored;
    }
  }
  EXPECT_GT(direct, 200);
  EXPECT_GT(mirrored, 80);
  // The ball of triangles is a little smaller, and mirrored outlines are softer.
  EXPECT_LT(outlines, 40);
}

// All else is as it is without: what lights look like is no part of what they light.
TEST(VisibleLights, ChangeOnlyThePixelsThatSeeThem) {
  const Scene clear = on_film(lights_above_a_floor(), {20, 15});
  const Scene foggy = in_fog(clear, 0.2);
  const std::vector<int> seen = seen_lights(clear);
  Settings settings = all_orders(24, {.nodes = 2000, .directions = 32});
  settings.samples = 1;
  for (const auto& [scene, method] :
       {std::pair(clear, settings), {foggy, reference_settings()}, {foggy, path_traced(2)}}) {
    const Frame shown = render_frame(scene, method);
    const Frame hidden = render_frame(with_hidden(scene), method);
    int changed = 0;
    for (std::size_t i = 0; i < seen.size(); ++i) {
      if (seen[i] >= 0) {
        ++changed;
        EXPECT_LT(shown.depth[i], hidden.depth[i]);
        const float transmittance = shown.transmittance[3 * i];
        const glm::vec3 expected =
            color(shown.airlight, i, 3) + transmittance * glm::vec3(radiance);
        EXPECT_LT(glm::distance(color(shown.beauty, i, 4), expected), 1e-5f);
        continue;
      }
      ASSERT_EQ(shown.depth[i], hidden.depth[i]);
      ASSERT_EQ(color(shown.airlight, i, 3), color(hidden.airlight, i, 3));
      ASSERT_EQ(color(shown.beauty, i, 4), color(hidden.beauty, i, 4));
    }
    EXPECT_GT(changed, 15);
  }
  // Slices of a tile end where its pixels do, those of the tiles beside it follow.
  const Frame shown = render_frame(foggy, settings);
  const Frame hidden = render_frame(with_hidden(foggy), settings);
  for (std::size_t i = 0; i < seen.size(); ++i) {
    if (seen[i] >= 0) continue;
    EXPECT_LT(glm::distance(color(shown.beauty, i, 4), color(hidden.beauty, i, 4)),
              0.02f * glm::length(color(hidden.beauty, i, 4)));
  }
}

double mean(const Frame& frame, int first_row) {
  double sum = 0.0;
  const auto width = static_cast<std::size_t>(frame.film.width);
  for (std::size_t i = static_cast<std::size_t>(first_row) * width; i < frame.depth.size(); ++i) {
    sum += static_cast<double>(frame.beauty[4 * i]);
  }
  return sum / static_cast<double>(frame.depth.size());
}

// The lower half shows a floor, from a mirror to a lacquer of some color.
TEST(VisibleLights, AreInMirrorsAsPathsHaveThem) {
  for (const auto& [roughness, metallic] : {std::pair(0.0, 1.0), {0.3, 0.0}}) {
    Scene scene = on_film(in_fog(lights_above_a_floor(), 0.05), {24, 18});
    scene.optics.albedo = glm::dvec3(0.9);  // paths end sooner
    scene.surfaces[0].material = metal(0.5, roughness);
    scene.surfaces[0].material.metallic_roughness.metallic = metallic;
    Settings settings = all_orders(24);
    settings.samples = 1;
    const double shown = mean(render_frame(scene, settings), 10);
    const double truth = mean(render_frame(scene, path_traced(32)), 10);
    EXPECT_NEAR(shown, truth, 0.03 * truth) << roughness << " " << metallic;
  }
}

// A lacquer without blue and green keeps the red that it scatters below a light that is black
// there.
TEST(VisibleLights, HideWhatHighlightsMirrorAndNothingElse) {
  Scene scene = on_film(lights_above_a_floor(), {16, 12});
  scene.lights = {panel()};
  scene.lights[0].intensity = glm::dvec3(1e-3);
  scene.surfaces[0].material = metal(1.0, 0.3);
  scene.surfaces[0].material.metallic_roughness.metallic = 0.0;
  scene.surfaces[0].material.metallic_roughness.base_color = {1.0, 0.0, 0.0};
  scene.surfaces[1].material = metal(0.0, 1.0);
  scene.surfaces[1].material.metallic_roughness.emissive = glm::dvec3(1.0);
  const double seen = mean(render_frame(scene, path_traced(256)), 8);
  const double hidden = mean(render_frame(with_hidden(scene), path_traced(256)), 8);
  EXPECT_LT(seen, hidden);
  EXPECT_GT(seen, 0.85 * hidden);
}

TEST(VisibleLights, AreSeenThroughPanes) {
  Scene scene = lights_above_a_floor();
  const std::vector<int> seen = seen_lights(scene);
  Surface window = pane(AlphaMode::blend, 0.5, glm::dvec3(0.0));
  window.material.metallic_roughness.base_color = glm::dvec3(0.0);
  window.rotate = glm::angleAxis(0.5 * std::numbers::pi, glm::dvec3(1.0, 0.0, 0.0));
  window.scale = 2.0;
  Settings settings = sliced(8);
  settings.samples = 1;
  for (const double z : {2.0, -1.0}) {
    window.translate = {0.0, 1.0, z};
    scene.surfaces.resize(2);
    scene.surfaces.push_back(window);
    for (const Settings& method : {settings, path_traced(1)}) {
      const Frame frame = render_frame(scene, method);
      const float expected = (z > 0.0 ? 0.5f : 1.0f) * static_cast<float>(radiance.z);
      int count = 0;
      for (std::size_t i = 0; i < seen.size(); ++i) {
        if (seen[i] < 0) continue;
        EXPECT_NEAR(frame.beauty[4 * i + 2], expected, z > 0.0 ? 0.2f : 1e-6f);
        ++count;
      }
      EXPECT_GT(count, 200);
    }
  }
}

// Without any surface, in fog and without, with samples at their edges.
TEST(VisibleLights, AreSeenAlone) {
  Scene scene = lights_above_a_floor();
  scene.surfaces.clear();
  const std::vector<int> seen = seen_lights(scene);
  for (const double fog : {0.0, 0.1}) {
    const Scene alone = in_fog(scene, fog);
    Settings settings = all_orders(8);
    settings.samples = 4;
    for (const Settings& method : {settings, path_traced(2), paper_settings}) {
      const Frame frame = render_frame(alone, method);
      for (std::size_t i = 0; i < seen.size(); ++i) {
        EXPECT_EQ(std::isfinite(frame.depth[i]), seen[i] >= 0);
        if (seen[i] < 0) continue;
        EXPECT_GT(frame.beauty[4 * i + 3], 0.4f);
        EXPECT_GT(frame.beauty[4 * i], 0.3f * static_cast<float>(radiance.x));
      }
      expect_finite(frame);
    }
  }
}

TEST(VisibleLights, AreInLayers) {
  Scene scene = lights_above_a_floor();
  scene.lights[0].name = "window";
  scene.lights[0].id = 3;
  scene.lights[1].id = 4;
  EXPECT_EQ(object_mattes(scene.surfaces, scene.lights).names,
            (std::vector<std::string>{"Plane", "Box", "window", "Sphere"}));
  scene.lights[0].on = false;
  EXPECT_EQ(object_mattes(scene.surfaces, scene.lights).names,
            (std::vector<std::string>{"Plane", "Box", "Sphere"}));
  scene.lights[0].on = true;
  Scene next = scene;
  next.lights[1].position.x += 0.1;
  OutputLayers layers;
  layers.normal = layers.albedo = layers.position = layers.motion = layers.objects = true;
  ImageLayers image;
  add_surface_layers(scene, scene.camera, scene.film, layers, &next, next.camera, {}, image);
  const std::vector<int> seen = seen_lights(scene);
  int count = 0;
  for (std::size_t i = 0; i < seen.size(); ++i) {
    if (seen[i] < 0) continue;
    ++count;
    const glm::vec3 normal(image.channels.at("normal.X")[i], image.channels.at("normal.Y")[i],
                           image.channels.at("normal.Z")[i]);
    const glm::vec3 position(image.channels.at("position.X")[i], image.channels.at("position.Y")[i],
                             image.channels.at("position.Z")[i]);
    const glm::vec3 offset =
        position - glm::vec3(scene.lights[static_cast<std::size_t>(seen[i])].position);
    EXPECT_NEAR(glm::length(normal), 1.0f, 1e-5f);
    EXPECT_NEAR(glm::dot(offset, normal), seen[i] == 1 ? 0.35f : 0.0f, 1e-4f);
    EXPECT_EQ(image.channels.at("albedo.R")[i], 0.0f);
    const float motion = image.channels.at("forward.u")[i];
    if (seen[i] == 1) {
      EXPECT_GT(motion, 0.5f);
    } else {
      EXPECT_NEAR(motion, 0.0f, 1e-3f);
    }
  }
  EXPECT_GT(count, 200);
}

}  // namespace
}  // namespace brume
