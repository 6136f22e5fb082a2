// A surface with copies is as good as that many surfaces.

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "brume/primitive.h"
#include "core/scene/copies.h"
#include "core/scene/lights/emitting_surfaces.h"
#include "core/scene/lights/point_lights.h"
#include "core/scene/placement.h"
#include "render/paths/emitter_sampler.h"
#include "render/visibility/exact_occlusion.h"
#include "render/visibility/ray_caster.h"
#include "tests/random.h"
#include "tests/render/coverage_scenes.h"
#include "tests/render/test_scenes.h"

namespace brume {
namespace {

// Placed at random, a few beyond one another.
Surface with_copies(Surface surface, std::size_t count, double scale = 0.4) {
  Random random(7);
  CopyPlacements placements(count);
  for (CopyPlacement& copy : placements) {
    copy.translate = random.point(1.0);
    copy.rotate = glm::angleAxis(random.uniform(-3.0, 3.0), glm::normalize(random.point(1.0)));
    copy.scale = random.uniform(0.5, 1.0) * scale;
  }
  surface.copies =
      Copies{.placements = std::make_shared<const CopyPlacements>(std::move(placements))};
  return with_placed_copies({surface})[0];
}

std::vector<Surface> apart(const Surface& surface) {
  std::vector<Surface> all;
  for (std::size_t copy = 0; copy < placement_count(surface); ++copy) {
    const Placement placement = placement_of(surface, copy);
    Surface& one = all.emplace_back(surface);
    one.placed_copies.reset();
    one.translate = placement.translate;
    one.rotate = placement.rotate;
    one.scale = placement.scale;
  }
  return all;
}

Surface box_with_copies() {
  Surface box = placed(Primitive::Shape::box, {1.0, 1.5, 0.7}, {0.3, -0.2, 0.1});
  box.rotate = glm::angleAxis(0.4, glm::normalize(glm::dvec3(1.0, 2.0, 0.5)));
  box.scale = 0.5;
  return with_copies(box, 20);
}

// Above a floor in fog, lit from above.
Scene scene_of(const std::vector<Surface>& surfaces) {
  Scene scene = on_film(in_fog(cloud_scene(10, 0.5), 0.05), {32, 24});
  scene.surfaces = {placed(Primitive::Shape::box, {8.0, 0.1, 8.0}, {0.0, -1.5, 0.0})};
  scene.surfaces.insert(scene.surfaces.end(), surfaces.begin(), surfaces.end());
  return scene;
}

TEST(CopiesFrames, AreThoseOfAsManySurfaces) {
  const Surface box = box_with_copies();
  const Scene scene = scene_of({box});
  const Scene other = scene_of(apart(box));
  struct Case {
    Settings settings;
    double max_rmse;
  };
  // Roundings, which paths follow elsewhere.
  for (const auto& [settings, max_rmse] :
       {Case{sliced(24), 1e-4}, Case{all_orders(24), 1e-4}, Case{reference_settings(1e-3), 1e-4},
        Case{path_traced(8), 2e-2}}) {
    const Frame frame = render_frame(scene, settings);
    const Frame truth = render_frame(other, settings);
    EXPECT_LT(rel_rmse(frame.beauty, truth.beauty), max_rmse);
    EXPECT_LT(rel_rmse(frame.airlight, truth.airlight), max_rmse);
  }
  // Without them it is another frame.
  const Frame alone = render_frame(scene_of({apart(box)[0]}), sliced(24));
  EXPECT_GT(rel_rmse(alone.beauty, render_frame(other, sliced(24)).beauty), 0.005);
}

TEST(CopiesFrames, OfTexturedMetalAreThoseOfAsManySurfaces) {
  Surface box = box_with_copies();
  box.material = metallic_roughness(glm::dvec3(1.0), 0.8, 0.3);
  const Frame frame = render_frame(scene_of({box}), sliced(24));
  const Frame truth = render_frame(scene_of(apart(box)), sliced(24));
  EXPECT_LT(rel_rmse(frame.beauty, truth.beauty), 1e-3);
}

TEST(CopiesFrames, OfEmittersLightFog) {
  Surface box = box_with_copies();
  box.material = metallic_roughness(glm::dvec3(1.0), 1.0, 1.0, glm::dvec3(5.0));
  const std::vector<Surface> boxes = apart(box);
  EXPECT_EQ(emitting_triangles(std::span(&box, 1)).size(), emitting_triangles(boxes).size());
  const std::vector<PointLight> lights = emitting_points(std::span(&box, 1), 21);
  const std::vector<PointLight> others = emitting_points(boxes, 21);
  ASSERT_EQ(lights.size(), others.size());
  for (std::size_t i = 0; i < lights.size(); ++i) {
    EXPECT_LT(glm::distance(lights[i].position, others[i].position), 1e-9);
    EXPECT_LT(glm::distance(lights[i].intensity, others[i].intensity), 1e-9);
  }
  const Frame frame = render_frame(scene_of({box}), path_traced(16));
  const Frame truth = render_frame(scene_of(boxes), path_traced(16));
  EXPECT_LT(rel_rmse(frame.airlight, truth.airlight), 2e-2);
}

TEST(CopiesRays, HitWhatSurfacesDo) {
  const std::vector<Surface> copied{box_with_copies()};
  const std::vector<Surface> surfaces = apart(copied[0]);
  const RayCaster caster(copied);
  const RayCaster other(surfaces);
  EXPECT_EQ(caster.bounds(), other.bounds());
  EXPECT_EQ(caster.center(), other.center());
  EXPECT_EQ(caster.radius(), other.radius());
  const ExactOcclusion exact(copied);
  const ExactOcclusion other_exact(surfaces);
  Random random(5);
  const glm::dvec3 eye(0.2, 0.1, 3.0);
  std::vector<glm::dvec3> directions;
  for (int k = 0; k < 200; ++k) directions.push_back(glm::normalize(random.point(1.2) - eye));
  std::vector<SurfaceHit> packet(directions.size());
  caster.first_hits(eye, directions, packet);
  int copies_hit = 0;
  for (std::size_t k = 0; k < directions.size(); ++k) {
    const SurfaceHit hit = caster.first_hit(eye, directions[k]);
    const SurfaceHit wanted = other.first_hit(eye, directions[k]);
    ASSERT_EQ(static_cast<bool>(hit), static_cast<bool>(wanted));
    ASSERT_EQ(static_cast<bool>(packet[k]), static_cast<bool>(wanted));
    const glm::dvec3 light = random.point(2.0);
    if (wanted) {
      copies_hit += hit.copy > 0;
      EXPECT_EQ(hit.copy, static_cast<std::uint32_t>(wanted.surface));
      EXPECT_EQ(packet[k].copy, hit.copy);
      EXPECT_EQ(hit.triangle, wanted.triangle);
      EXPECT_NEAR(hit.distance, wanted.distance, 1e-5);
      const SurfacePoint point = caster.point(hit, eye, directions[k], copied);
      const SurfacePoint same = other.point(wanted, eye, directions[k], surfaces);
      EXPECT_LT(glm::distance(point.position, same.position), 1e-5);
      EXPECT_LT(glm::distance(point.normal, same.normal), 1e-5);
      EXPECT_EQ(caster.occluded(point.shadow_origin, light),
                other.occluded(same.shadow_origin, light));
    }
    const auto lit = exact.lit(light, eye, directions[k], 6.0);
    const auto truth = other_exact.lit(light, eye, directions[k], 6.0);
    ASSERT_EQ(lit.size(), truth.size());
    for (std::size_t i = 0; i < lit.size(); ++i) {
      EXPECT_NEAR(lit[i].first, truth[i].first, 1e-9);
      EXPECT_NEAR(lit[i].second, truth[i].second, 1e-9);
    }
  }
  EXPECT_GT(copies_hit, 20);
}

TEST(CopiesRays, PassHolesAndPanes) {
  Surface clear = pane(AlphaMode::blend, 0.4, glm::dvec3(0.0));
  for (const Surface& surface : {with_copies(checkered_leaf(), 15), with_copies(clear, 15)}) {
    const std::vector<Surface> copied{surface};
    const std::vector<Surface> surfaces = apart(surface);
    const RayCaster caster(copied);
    const RayCaster other(surfaces);
    Random random(3);
    for (int k = 0; k < 300; ++k) {
      const glm::dvec3 start = random.point(2.0);
      const glm::dvec3 end = random.point(2.0);
      EXPECT_NEAR(caster.transmittance(start, end), other.transmittance(start, end), 1e-6);
      const glm::dvec3 way = glm::normalize(end - start);
      const HitsOnRay hits = caster.hits_on_ray(start, way);
      const HitsOnRay wanted = other.hits_on_ray(start, way);
      ASSERT_EQ(hits.panes.size(), wanted.panes.size());
      for (std::size_t i = 0; i < hits.panes.size(); ++i) {
        EXPECT_EQ(hits.panes[i].hit.copy, static_cast<std::uint32_t>(wanted.panes[i].hit.surface));
      }
    }
  }
}

}  // namespace
}  // namespace brume
