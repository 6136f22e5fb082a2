#include "core/scene/group_effects.h"

#include <gtest/gtest.h>

#include "brume/at_time.h"
#include "core/number_domain.h"

namespace brume {
namespace {

// A Gaussian in no group, one in group 1, one in group 2, which is in group 1, and one in group 3.
Scene grouped_scene() {
  Scene scene;
  scene.optics.albedo = {0.8, 0.8, 0.4};
  scene.groups = {
      {.id = 1, .name = "a"}, {.id = 2, .name = "b", .parent = 1}, {.id = 3, .name = "c"}};
  for (GroupId group = 0; group < 4; ++group) {
    scene.medium.append({glm::dvec3(group), 2.0, 1.0, {}, group});
  }
  return scene;
}

Medium seen(const Scene& scene, double time = 0.0) {
  const Scene shown = evaluate_at(scene, time);
  EXPECT_TRUE(shown.groups.empty());
  return shown.medium;
}

TEST(Groups, WithoutEffectsChangeNothing) {
  const Scene scene = grouped_scene();
  EXPECT_EQ(seen(scene).revision(), scene.medium.revision());
  EXPECT_FALSE(is_animated(scene));
}

TEST(Groups, MultiplyAndOffset) {
  Scene scene = grouped_scene();
  scene.groups[2].density_factor = 3.0;
  scene.groups[2].density_offset = 0.5;
  scene.groups[2].radius_factor = 0.5;
  scene.groups[2].radius_offset = 0.25;
  scene.groups[2].albedo_factor = glm::dvec3(0.5);
  scene.groups[2].albedo_offset = {0.1, 0.0, 0.9};
  const Medium medium = seen(scene);
  for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(medium.gaussian(i), scene.medium.gaussian(i));
  EXPECT_EQ(medium.densities()[3], 3.5);
  EXPECT_EQ(medium.radii()[3], 1.25);
  EXPECT_EQ(medium.centers()[3], scene.medium.centers()[3]);
  EXPECT_EQ(medium.optics(3).albedo, glm::dvec3(0.5, 0.4, 1.0));
}

TEST(Groups, StartFromAnAlbedoOfItsOwn) {
  Scene scene;
  scene.optics.albedo = glm::dvec3(0.9);
  scene.groups = {{.id = 1, .name = "a", .albedo_factor = glm::dvec3(0.5)}};
  scene.medium.append({{}, 1.0, 1.0, {glm::dvec3(0.4)}, 1});
  EXPECT_EQ(seen(scene).optics(0).albedo, glm::dvec3(0.2));
}

// The group's first, then the parent's.
TEST(Groups, AreNestedOnce) {
  Scene scene = grouped_scene();
  scene.groups[0].density_factor = 2.0;
  scene.groups[0].density_offset = 1.0;
  scene.groups[1].density_factor = 3.0;
  scene.groups[1].density_offset = 0.5;
  const Medium medium = seen(scene);
  EXPECT_EQ(medium.densities()[1], 2.0 * 1.0 + 1.0);
  EXPECT_EQ(medium.densities()[2], 2.0 * (3.0 * 1.0 + 0.5) + 1.0);
  EXPECT_EQ(medium.densities()[3], 1.0);
}

TEST(Groups, StayWithinTheDomains) {
  Scene scene = grouped_scene();
  scene.groups[0].density_offset = -5.0;
  scene.groups[0].radius_offset = -5.0;
  scene.groups[0].albedo_offset = glm::dvec3(-1.0);
  scene.groups[2].density_factor = 1e12;
  scene.groups[2].density_offset = 1e12;
  const Medium medium = seen(scene);
  EXPECT_EQ(medium.densities()[1], 0.0);
  EXPECT_GT(medium.radii()[1], 0.0);
  EXPECT_GT(medium.optics(1).albedo->x, 0.0);
  EXPECT_EQ(medium.densities()[3], domain::density.max_value);
}

TEST(Groups, HiddenOnesAreInNoFrame) {
  Scene scene = grouped_scene();
  scene.groups[1].visible = false;
  Medium medium = seen(scene);
  ASSERT_EQ(medium.size(), 3u);
  EXPECT_EQ(medium.centers()[2], glm::dvec3(3.0));
  scene.groups[1].visible = true;
  scene.groups[0].visible = false;  // with the group in it
  medium = seen(scene);
  ASSERT_EQ(medium.size(), 2u);
  EXPECT_EQ(medium.centers()[1], glm::dvec3(3.0));
  const GroupEffects effects(scene.groups);
  EXPECT_EQ(hidden_by_groups(scene.medium, effects), (std::vector<GaussianId>{2, 3}));
  EXPECT_TRUE(locked_by_groups(scene.medium, effects).empty());
}

TEST(Groups, AppliedBeforehandGiveTheSameMedium) {
  Scene scene = grouped_scene();
  scene.groups[0].radius_factor = 3.0;
  scene.groups[2].visible = false;
  EXPECT_TRUE(has_constant_groups(scene));
  Scene applied = scene;
  apply_groups(applied);
  EXPECT_EQ(seen(applied), seen(scene));
  EXPECT_EQ(seen(applied).revision(), applied.medium.revision());
}

TEST(Groups, HaveKeys) {
  Scene scene = grouped_scene();
  scene.groups[0].keys.density_factor = {{.time = 0.0, .value = 1.0}, {.time = 2.0, .value = 3.0}};
  scene.groups[0].keys.albedo_factor = {{.time = 0.0, .value = glm::dvec3(1.0)},
                                        {.time = 2.0, .value = glm::dvec3(0.5)}};
  // The values that it multiplies have keys, too.
  scene.optics.keys.albedo = {{.time = 0.0, .value = glm::dvec3(0.4)},
                              {.time = 2.0, .value = glm::dvec3(0.8)}};
  EXPECT_TRUE(is_animated(scene));
  EXPECT_FALSE(has_constant_groups(scene));
  EXPECT_EQ(last_moment(scene), 2.0);
  EXPECT_DOUBLE_EQ(seen(scene, 1.0).densities()[1], 2.0);
  EXPECT_DOUBLE_EQ(seen(scene, 2.0).densities()[1], 3.0);
  EXPECT_DOUBLE_EQ(seen(scene, 1.0).optics(1).albedo->x, 0.75 * 0.6);
  EXPECT_EQ(seen(scene, 1.0).optics(0).albedo, std::nullopt);
}

}  // namespace
}  // namespace brume
