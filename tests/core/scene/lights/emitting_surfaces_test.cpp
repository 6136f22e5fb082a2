#include "core/scene/lights/emitting_surfaces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <memory>
#include <numbers>

#include "brume/primitive.h"
#include "core/math/basis.h"
#include "core/scene/lights/area_lights.h"
#include "core/scene/lights/point_lights.h"
#include "core/scene/materials/texture.h"

namespace brume {
namespace {

Surface emitting(const Primitive& primitive, const glm::dvec3& radiance) {
  Surface surface;
  surface.primitive = primitive;
  surface.mesh = mesh_of(primitive);
  surface.material.type = Material::Type::metallic_roughness;
  surface.material.metallic_roughness.emissive = radiance;
  return surface;
}

glm::dvec3 total(const std::vector<PointLight>& lights) {
  glm::dvec3 sum(0.0);
  for (const PointLight& light : lights) sum += light.intensity;
  return sum;
}

TEST(EmittingSurfaces, PointsOfABoxSendAsMuchAsItsSides) {
  const std::vector<Surface> box{
      emitting({.shape = Primitive::Shape::box, .size = {2.0, 1.0, 0.5}}, {3.0, 2.0, 1.0})};
  const double area = 2.0 * (2.0 * 1.0 + 1.0 * 0.5 + 2.0 * 0.5);
  for (const int count : {1, 6, 34, 200}) {
    const std::vector<PointLight> lights = emitting_points(box, count);
    EXPECT_LE(static_cast<int>(lights.size()), count);
    EXPECT_NEAR(glm::distance(total(lights), area * glm::dvec3(3.0, 2.0, 1.0)), 0.0, 1e-9) << count;
  }
}

// It is closed: its points lie on its sides and shine outwards.
TEST(EmittingSurfaces, PointsOfABoxShineOutwards) {
  const std::vector<Surface> box{
      emitting({.shape = Primitive::Shape::box, .size = {2.0, 1.0, 0.5}}, glm::dvec3(1.0))};
  for (const PointLight& light : emitting_points(box, 60)) {
    EXPECT_EQ(light.falloff.shape(), LightFalloff::Shape::cosine);
    const glm::dvec3 outside = light.position + 0.01 * light.falloff.axis();
    EXPECT_TRUE(std::abs(outside.x) > 1.0 || std::abs(outside.y) > 0.5 ||
                std::abs(outside.z) > 0.25);
  }
}

TEST(EmittingSurfaces, AnOpenOneShinesToBothSides) {
  const std::vector<Surface> plane{
      emitting({.shape = Primitive::Shape::plane, .size = {1.0, 1.0, 1.0}}, glm::dvec3(1.0))};
  const std::vector<PointLight> lights = emitting_points(plane, 21);
  EXPECT_EQ(lights.size(), 21u);
  for (const PointLight& light : lights) {
    EXPECT_EQ(light.falloff.shape(), LightFalloff::Shape::two_cosines);
  }
}

// Points stand for rectangles that are as much of the sides as they are, so that a floor next to
// them is lit as in closed form.
TEST(EmittingSurfaces, PointsFillTheSidesOfABoxWithRectangles) {
  Surface bar =
      emitting({.shape = Primitive::Shape::box, .size = {2.0, 0.1, 0.1}}, glm::dvec3(1.0));
  const double turn = 0.3;  // about the upright, half of it
  bar.rotate = {std::cos(turn), 0.0, std::sin(turn), 0.0};
  const std::vector<PointLight> lights = emitting_points(std::span(&bar, 1), 34);
  double area = 0.0;
  for (const PointLight& light : lights) {
    ASSERT_TRUE(light.area);
    area += area_of_point(light);
  }
  EXPECT_NEAR(area, 4.0 * 2.0 * 0.1 + 2.0 * 0.1 * 0.1, 1e-7);  // meshes are floats
  const glm::dmat3 turned = glm::mat3_cast(bar.rotate);
  for (const double along : {0.0, 0.45, 0.9}) {
    for (const double below : {0.06, 0.1, 0.5}) {
      const glm::dvec3 floor = turned * glm::dvec3(along, -below, 0.02);
      double whole = 0.0;
      for (int axis = 0; axis < 3; ++axis) {
        for (const double side : {-1.0, 1.0}) {
          glm::dvec3 normal(0.0), up(0.0);
          normal[axis] = side;
          up[(axis + 2) % 3] = 1.0;
          const light::Rectangle face{.direction = turned * normal,
                                      .up = turned * up,
                                      .width = bar.primitive->size[(axis + 1) % 3],
                                      .height = bar.primitive->size[(axis + 2) % 3]};
          const glm::dvec3 middle = turned * (0.5 * bar.primitive->size * normal);
          whole += area_irradiance(face, middle, floor, {0.0, 1.0, 0.0});
        }
      }
      double sum = 0.0;
      for (const PointLight& light : lights) {
        sum += area_irradiance(*light.area, light.area_center, floor, {0.0, 1.0, 0.0});
      }
      EXPECT_NEAR(sum / whole, 1.0, 0.01) << along << " " << below;
    }
  }
}

// Points that stand for what is no rectangle stay points.
TEST(EmittingSurfaces, ScatteredPiecesAreNoRectangle) {
  std::vector<Surface> plates;
  for (int i = 0; i < 8; ++i) {
    plates.push_back(
        emitting({.shape = Primitive::Shape::plane, .size = {0.1, 1.0, 0.1}}, glm::dvec3(1.0)));
    plates.back().translate = {i, 0.0, 0.3 * i * i};
  }
  for (const PointLight& light : emitting_points(plates, 1)) EXPECT_FALSE(light.area);
  for (const PointLight& light : emitting_points(plates, 8)) EXPECT_TRUE(light.area);
}

// A screen whose left half is black.
TEST(EmittingSurfaces, PointsAreWhereTheTextureShines) {
  Surface screen =
      emitting({.shape = Primitive::Shape::plane, .size = {1.0, 1.0, 1.0}}, glm::dvec3(2.0));
  std::vector<glm::vec3> texels;
  for (int y = 0; y < 64; ++y) {
    for (int x = 0; x < 64; ++x) texels.emplace_back(x < 32 ? 0.0f : 1.0f);
  }
  screen.material.metallic_roughness.emissive_texture.content =
      std::make_shared<Texture>(64, 64, texels);
  const std::vector<PointLight> lights = emitting_points(std::span(&screen, 1), 40);
  EXPECT_NEAR(total(lights).x, 1.0, 0.02);
  for (const PointLight& light : lights) EXPECT_GT(light.position.x, -0.05);
}

TEST(EmittingSurfaces, PanesSendAsMuchAsTheyCover) {
  Surface pane =
      emitting({.shape = Primitive::Shape::plane, .size = {1.0, 1.0, 1.0}}, glm::dvec3(2.0));
  pane.material.metallic_roughness.alpha = AlphaMode::blend;
  pane.material.metallic_roughness.opacity = 0.1;
  EXPECT_NEAR(total(emitting_points(std::span(&pane, 1), 20)).x, 0.2, 1e-9);
}

TEST(EmittingSurfaces, BrightOnesGetTheirShareOfPoints) {
  std::vector<Surface> boxes{
      emitting({.shape = Primitive::Shape::box, .size = {1.0, 1.0, 1.0}}, glm::dvec3(100.0)),
      emitting({.shape = Primitive::Shape::box, .size = {1.0, 1.0, 1.0}}, glm::dvec3(0.01))};
  boxes[1].translate = {5.0, 0.0, 0.0};
  const std::vector<PointLight> lights = emitting_points(boxes, 60);
  EXPECT_GT(std::ranges::count_if(lights, [](const auto& l) { return l.position.x < 2.0; }), 48);
}

TEST(EmittingSurfaces, AreAmongTheLightsOfAScene) {
  Scene scene;
  scene.surfaces.push_back(
      emitting({.shape = Primitive::Shape::box, .size = {1.0, 1.0, 1.0}}, glm::dvec3(1.0)));
  EXPECT_GT(point_lights(scene, LightPoints::few).size(), 6u);
  EXPECT_TRUE(point_lights(scene, LightPoints::drawn).empty());
}

// A street of signs was lit by as many points as one of them, most of which stood for several.
TEST(EmittingSurfaces, ManyGetPointsOfTheirOwn) {
  constexpr int count = 12;
  Scene scene;
  for (int i = 0; i < count; ++i) {
    Surface& sign = scene.surfaces.emplace_back(
        emitting({.shape = Primitive::Shape::box, .size = {0.1, 0.1, 1.0}}, glm::dvec3(1.0)));
    sign.translate.x = 10.0 * i;
  }
  for (const bool are_copies : {false, true}) {
    SCOPED_TRACE(are_copies);
    if (are_copies) {
      auto copies = std::make_shared<CopyPlacements>();
      for (int i = 1; i < count; ++i) copies->push_back({.translate = {10.0 * i, 0.0, 0.0}});
      scene.surfaces.resize(1);
      scene.surfaces[0].placed_copies = copies;
    }
    std::array<int, count> points{};
    for (const PointLight& light : point_lights(scene, LightPoints::few)) {
      const double sign = light.position.x / 10.0;
      EXPECT_NEAR(sign, std::round(sign), 0.01);
      ++points[static_cast<std::size_t>(std::lround(sign))];
    }
    EXPECT_GE(std::ranges::min(points), 4);  // one for each long side
  }
}

using std::numbers::pi;

const glm::dvec3 middle(0.3, 1.0, -0.2);

AreaLight rectangle(bool two_sided = false) {
  return light::Rectangle{.direction = {0.3, -1.0, 0.2},
                          .up = {0.1, 0.2, 1.0},
                          .width = 1.4,
                          .height = 0.6,
                          .two_sided = two_sided};
}
AreaLight disk(bool two_sided = false) {
  return light::Disk{{0.3, -1.0, 0.2}, 0.5, two_sided};
}
AreaLight ball(bool two_sided = false) {
  return light::Sphere{0.5, two_sided};
}

// The irradiance by rays from x, evenly over the solid angle.
double by_rays(const AreaLight& area, const glm::dvec3& x, const glm::dvec3& normal) {
  constexpr int ray_rows = 1500;
  const auto [u, v] = make_basis(normal);
  double sum = 0.0;
  for (int i = 0; i < ray_rows; ++i) {
    const double cosine = (i + 0.5) / ray_rows;
    const double sine = std::sqrt(1.0 - cosine * cosine);
    for (int k = 0; k < ray_rows; ++k) {
      const double turn = 2.0 * pi * (k + 0.5) / ray_rows;
      const glm::dvec3 w = sine * std::cos(turn) * u + sine * std::sin(turn) * v + cosine * normal;
      if (hit_area(area, middle, x, w)) sum += cosine;
    }
  }
  return 2.0 * pi * sum / (ray_rows * ray_rows);
}

struct Receiver {
  glm::dvec3 position, normal;
};
// Below it, beside it, behind it, and where the horizon cuts it.
const Receiver receivers[] = {
    {{0.2, 0.0, 0.1}, {0.1, 1.0, 0.2}},   {{1.5, 0.4, 0.3}, {-1.0, 0.1, 0.0}},
    {{0.3, 0.45, -0.2}, {1.0, 0.1, 0.3}}, {{0.4, 0.3, 0.2}, {0.9, 0.2, -0.4}},
    {{0.3, 2.0, 0.0}, {0.1, -1.0, 0.0}},  {{-0.6, 0.9, 0.5}, {0.2, -0.8, -0.6}}};

TEST(AreaLights, IrradianceIsThatOfRays) {
  for (const AreaLight& area : {rectangle(), disk(), ball(), rectangle(true), disk(true)}) {
    for (const auto& [position, direction] : receivers) {
      const glm::dvec3 normal = glm::normalize(direction);
      const double expected = by_rays(area, position, normal);
      EXPECT_NEAR(area_irradiance(area, middle, position, normal), expected, 1e-3 * expected + 3e-5)
          << "kind " << area.index() << " from " << position.x << ", " << position.y;
    }
  }
}

TEST(AreaLights, SpheresShineWithinWhereTwoSided) {
  const glm::dvec3 within = middle + glm::dvec3(0.1, 0.2, 0.0);
  EXPECT_EQ(area_irradiance(ball(), middle, within, {0, 1, 0}), 0.0);
  EXPECT_NEAR(area_irradiance(ball(true), middle, within, {0, 1, 0}), pi, 1e-12);
  EXPECT_FALSE(hit_area(ball(), middle, within, {0, 1, 0}));
  EXPECT_TRUE(hit_area(ball(true), middle, within, {0, 1, 0}));
}

TEST(AreaLights, BacksShineWhereTwoSided) {
  const glm::dvec3 above = middle + glm::dvec3(0.0, 1.0, 0.0);
  for (const auto& [one, both] :
       {std::pair(rectangle(), rectangle(true)), std::pair(disk(), disk(true))}) {
    EXPECT_EQ(area_irradiance(one, middle, above, {0, -1, 0}), 0.0);
    EXPECT_GT(area_irradiance(both, middle, above, {0, -1, 0}), 0.1);
    EXPECT_FALSE(hit_area(one, middle, above, {0, -1, 0}));
    EXPECT_NEAR(hit_area(both, middle, above, {0, -1, 0})->distance, 1.0, 1e-12);
  }
}

}  // namespace

}  // namespace brume
