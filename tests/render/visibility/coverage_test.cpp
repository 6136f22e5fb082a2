// Holes and panes, as rays meet them.

#include "core/scene/materials/coverage.h"

#include <gtest/gtest.h>

#include <array>
#include <glm/geometric.hpp>

#include "brume/primitive.h"
#include "render/visibility/ray_caster.h"
#include "tests/render/coverage_scenes.h"

namespace brume {
namespace {

constexpr glm::dvec3 down(0.0, -1.0, 0.0);

// A ray down onto a square of 2 u around the origin, at x and z.
SurfaceHit hit_from_above(const RayCaster& caster, double x, double z) {
  return caster.first_hit({x, 1.0, z}, down);
}

TEST(Coverage, RaysPassHoles) {
  const std::vector<Surface> leaf{checkered_leaf()};
  const RayCaster caster(leaf);
  std::vector<glm::dvec3> directions;
  std::vector<bool> are_there;
  int holes = 0;
  for (int z = 0; z < 8; ++z) {
    for (int x = 0; x < 8; ++x) {
      const double px = -0.875 + 0.25 * x;
      const double pz = -0.875 + 0.25 * z;
      const bool is_there = is_leaf_there(px, pz);
      holes += !is_there;
      EXPECT_EQ(static_cast<bool>(hit_from_above(caster, px, pz)), is_there) << px << ' ' << pz;
      EXPECT_EQ(caster.transmittance({px, 1, pz}, {px, -1, pz}), is_there ? 0.0 : 1.0);
      EXPECT_EQ(caster.occluded({px, 1, pz}, {px, -1, pz}), is_there);
      directions.push_back(glm::normalize(glm::dvec3(px, 0.0, pz) - glm::dvec3(0, 1, 0)));
      are_there.push_back(is_there);
    }
  }
  EXPECT_EQ(holes, 32);
  std::vector<SurfaceHit> hits(directions.size());  // in packets
  caster.first_hits({0, 1, 0}, directions, hits);
  for (std::size_t i = 0; i < hits.size(); ++i) {
    EXPECT_EQ(static_cast<bool>(hits[i]), are_there[i]) << i;
  }
}

TEST(Coverage, CutoffAndOpacityMoveTheEdgesOfHoles) {
  Surface leaf = checkered_leaf();
  MetallicRoughness& material = leaf.material.metallic_roughness;
  const auto is_there = [&] {
    return static_cast<bool>(hit_from_above(RayCaster(std::span(&leaf, 1)), 0.25, 0.75));
  };
  ASSERT_TRUE(is_there());
  material.opacity = 0.4;
  EXPECT_FALSE(is_there());
  material.alpha_cutoff = 0.4;
  EXPECT_TRUE(is_there());
  material.opacity = 0.0;
  material.alpha = AlphaMode::opaque;
  EXPECT_TRUE(is_there());
}

TEST(Coverage, RayCastersAreOfTheirHolesAndPanes) {
  const std::vector<Surface> before{checkered_leaf()};
  const RayCaster caster(before);
  EXPECT_TRUE(caster.shows(before));
  const auto shows_with = [&](auto&& change) {
    std::vector<Surface> surfaces = before;
    change(surfaces[0].material.metallic_roughness);
    return caster.shows(surfaces);
  };
  EXPECT_TRUE(shows_with([](MetallicRoughness& m) { m.base_color = glm::dvec3(0.1); }));
  EXPECT_FALSE(shows_with([](MetallicRoughness& m) { m.alpha = AlphaMode::opaque; }));
  EXPECT_FALSE(shows_with([](MetallicRoughness& m) { m.alpha_cutoff = 0.1; }));
  EXPECT_FALSE(shows_with([](MetallicRoughness& m) { m.opacity = 0.1; }));
  EXPECT_FALSE(shows_with([](MetallicRoughness& m) { m.transmission.x = 0.1; }));
  EXPECT_FALSE(shows_with([](MetallicRoughness& m) { m.base_color_texture = {}; }));
}

TEST(Coverage, PanesAttenuate) {
  // From above: a quarter covered, half and all of red transmitted, an opaque floor.
  std::vector<Surface> panes{pane(AlphaMode::blend, 0.25, glm::dvec3(0.0)),
                             pane(AlphaMode::opaque, 1.0, {1.0, 0.5, 0.0}), checkered_leaf()};
  panes[2].material.metallic_roughness.alpha = AlphaMode::opaque;
  panes[0].translate.y = 2.0;
  panes[1].translate.y = 1.0;
  const glm::dvec3 start(0.3, 3.0, 0.1);
  const std::array<double, 3> second{1.0, 0.5, 0.0};
  for (int c = 0; c < 3; ++c) {
    glm::dvec3 channel(0.0);
    channel[c] = 1.0;
    const RayCaster caster(panes, channel);
    EXPECT_TRUE(caster.has_panes());
    const double both = 0.75 * second[static_cast<std::size_t>(c)];
    EXPECT_FLOAT_EQ(caster.transmittance(start, {0.3, 0.5, 0.1}), both);
    EXPECT_NEAR(caster.transmittance(start, down, 2.5), both, 1e-7);
    EXPECT_EQ(caster.transmittance(start, down, 3.5), 0.0);
    const HitsOnRay hits = caster.hits_on_ray(start, down);
    ASSERT_EQ(hits.panes.size(), 2u);
    EXPECT_EQ(hits.panes[0].hit.surface, 0);
    EXPECT_EQ(hits.panes[1].hit.surface, 1);
    EXPECT_EQ(hits.end.surface, 2);
    EXPECT_NEAR(hits.passing(1.5), 0.75, 1e-12);
    EXPECT_EQ(caster.next_hit(start, down, hits.panes[0].hit).surface, 1);
    EXPECT_EQ(caster.next_hit(start, down, hits.panes[1].hit).surface, 2);
    std::array<SurfaceHit, 1> opaque;
    caster.opaque_hits(start, std::array{down}, opaque, 0.0);
    EXPECT_EQ(opaque[0].surface, 2);
    // Rays stopped by chance: as many as light.
    double draw = 0.0;
    int stopped = 0;
    for (int k = 0; k < 100; ++k) {
      draw = (k + 0.5) / 100.0;
      stopped += caster.first_hit_by_chance(start, down, [&] { return draw; }).surface == 0;
    }
    EXPECT_EQ(stopped, 25);
  }
  EXPECT_EQ(RayCaster(panes).pane(RayCaster(panes).first_hit(start, down), 0.0).opaque, 0.25);
  EXPECT_FALSE(RayCaster(panes).shows(panes, {1, 0, 0}));
}

TEST(Coverage, IsOfMetallicRoughnessAlone) {
  Surface surface = checkered_leaf();
  surface.material.type = Material::Type::diffuse;
  EXPECT_TRUE(Coverage(surface.material).is_opaque());
  EXPECT_FALSE(has_holes(std::span(&surface, 1)));
  surface.material.type = Material::Type::metallic_roughness;
  EXPECT_TRUE(has_holes(std::span(&surface, 1)));
}

}  // namespace
}  // namespace brume
