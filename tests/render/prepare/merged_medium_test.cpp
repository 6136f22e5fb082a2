#include "render/prepare/merged_medium.h"

#include <gtest/gtest.h>

#include <cmath>

#include "brume/edits.h"
#include "brume/render.h"
#include "tests/fog_bank.h"
#include "tests/render/test_scenes.h"

namespace brume {
namespace {

constexpr std::size_t bank_size = 24'000;
constexpr MergedMedium::Limits following{0.05, 1.0, 0.125};

std::vector<Gaussian> gaussians_of(const Medium& medium) {
  std::vector<Gaussian> all;
  for (std::size_t i = 0; i < medium.size(); ++i) all.push_back(medium.gaussian(i));
  return all;
}

// These do not touch: merging does not pay.
Medium far_apart() {
  Medium medium;
  for (std::size_t i = 0; i < bank_size; ++i) {
    medium.append({{static_cast<double>(i), 0.0, 0.0}, 0.1, 1.0});
  }
  return medium;
}

void expect_stands_for(const MergedMedium& merged, const Medium& medium, double max_error) {
  const double mass = mass_of(gaussians_of(medium));
  EXPECT_NEAR(mass_of(gaussians_of(merged.medium())), mass, 1e-9 * mass);
  EXPECT_LT(depth_error(gaussians_of(medium), gaussians_of(merged.medium()), 60), 1.5 * max_error);
  EXPECT_EQ(merged.medium().homogeneous_density(), medium.homogeneous_density());
}

TEST(MergedMedium, FollowsEdits) {
  constexpr double max_error = following.error;
  Medium medium = medium_of(fog_bank(bank_size, 1.0, 1));
  MergedMedium merged;
  ASSERT_TRUE(merged.update(medium, following, {}));
  ASSERT_TRUE(merged.is_merged());
  const std::size_t at_first = merged.medium().size();
  EXPECT_LT(at_first, bank_size / 4);

  Random random(2);
  std::vector<MediumEdit> edits;
  for (int step = 0; step < 12; ++step) {
    SCOPED_TRACE(step);
    std::vector<GaussianId> ids;
    std::vector<Gaussian> after;
    const double edge = random.uniform(-0.9, 0.9);
    for (std::size_t i = 0; i < medium.size(); ++i) {
      if (std::abs(medium.centers()[i].x - edge) > 0.01) continue;
      ids.push_back(medium.ids()[i]);
      after.push_back(medium.gaussian(i));
      after.back().density *= 0.5;
      after.back().center.y += 0.02;
    }
    edits.push_back(step % 3 == 0   ? MediumEdit::remove(medium, ids)
                    : step % 3 == 1 ? MediumEdit::change(medium, ids, after)
                                    : MediumEdit::add(medium, after));
    edits.back().apply(medium);
    ASSERT_TRUE(merged.update(medium, following, {}));
    if (step >= 9) expect_stands_for(merged, medium, max_error);  // once for each kind
    EXPECT_LT(merged.medium().size(), at_first + at_first / 2);
  }
  while (!edits.empty()) {
    edits.back().inverted().apply(medium);
    edits.pop_back();
    ASSERT_TRUE(merged.update(medium, following, {}));
  }
  expect_stands_for(merged, medium, max_error);
  medium.set_homogeneous_density(0.1);
  ASSERT_TRUE(merged.update(medium, following, {}));
  expect_stands_for(merged, medium, max_error);
}

// They are merged to balls, for what they are; other shapes alone are an edit.
TEST(MergedMedium, FollowsShapes) {
  constexpr double max_error = following.error;
  std::vector<Gaussian> bank = fog_bank(bank_size, 1.0, 1);
  for (std::size_t i = 0; i < bank.size(); i += 8) {
    bank[i].set_radii(bank[i].radius * glm::dvec3(2.0, 1.0, 0.5), glm::dquat(1, 0, 0, 0));
  }
  Medium medium = medium_of(bank);
  MergedMedium merged;
  ASSERT_TRUE(merged.update(medium, following, {}));
  ASSERT_TRUE(merged.is_merged());
  expect_stands_for(merged, medium, max_error);
  std::vector<GaussianId> ids;
  std::vector<Gaussian> after;
  for (std::size_t i = 0; i < bank.size(); i += 16) {
    ids.push_back(medium.ids()[i]);
    after.push_back(bank[i]);
    after.back().shape.stretch = {0.1, 0.5, 1.0};
  }
  MediumEdit::change(medium, ids, after).apply(medium);
  ASSERT_TRUE(merged.update(medium, following, {}));
  expect_stands_for(merged, medium, max_error);
}

TEST(MergedMedium, AsItIsWhereMergingDoesNotPay) {
  const Medium few = medium_of(fog_bank(500, 1.0, 1));
  Medium apart = far_apart();
  MergedMedium merged;
  for (const Medium& medium : {few, apart}) {
    ASSERT_TRUE(merged.update(medium, {0.05, 0.8}, {}));
    EXPECT_FALSE(merged.is_merged());
    EXPECT_EQ(merged.medium().revision(), medium.revision());
  }
  MediumEdit::remove(apart, std::vector{apart.ids()[7]}).apply(apart);
  ASSERT_TRUE(merged.update(apart, {0.05, 0.8}, {}));
  EXPECT_EQ(merged.medium().revision(), apart.revision());
  const Medium bank = medium_of(fog_bank(bank_size, 1.0, 1));
  ASSERT_TRUE(merged.update(bank, {0.0}, {}));
  EXPECT_FALSE(merged.is_merged());
}

// Frames at rest, and of a farm in any order, are equal.
TEST(MergedMedium, DependsOnTheMediumAlone) {
  const Medium bank = medium_of(fog_bank(bank_size, 1.0, 1));
  Medium edited = bank;
  MediumEdit::remove(edited, edited.ids().subspan(100, 50)).apply(edited);
  MergedMedium used;
  for (const Medium& medium : {bank, edited, far_apart(), bank}) {
    ASSERT_TRUE(used.update(medium, {0.05, 0.8}, {}));
    MergedMedium fresh;
    ASSERT_TRUE(fresh.update(medium, {0.05, 0.8}, {}));
    EXPECT_EQ(gaussians_of(used.medium()), gaussians_of(fresh.medium()));
  }
}

// Where edits are followed, the next medium of a sequence is taken for one like the last; one that
// is seen again is not.
TEST(MergedMedium, FindsOutWhetherItPaysForWhatIsSeenAgain) {
  const Medium bank = medium_of(fog_bank(bank_size, 1.0, 1));
  const Medium apart = far_apart();
  MergedMedium merged;
  for (const Medium& medium : {apart, bank, apart}) {
    ASSERT_TRUE(merged.update(medium, {0.05, 0.8, 0.125}, {}));
    ASSERT_TRUE(merged.update(medium, {0.05, 0.8, 0.125}, {}));
    EXPECT_EQ(merged.is_merged(), medium == bank);
    expect_stands_for(merged, medium, 0.05);
  }
}

TEST(MergedMedium, GoesOnAfterAStop) {
  Medium medium = medium_of(fog_bank(bank_size, 1.0, 1));
  std::stop_source stop;
  stop.request_stop();
  MergedMedium merged;
  EXPECT_FALSE(merged.update(medium, following, stop.get_token()));
  ASSERT_TRUE(merged.update(medium, following, {}));
  MediumEdit::remove(medium, medium.ids().subspan(100, 50)).apply(medium);
  EXPECT_FALSE(merged.update(medium, following, stop.get_token()));
  ASSERT_TRUE(merged.update(medium, following, {}));
  expect_stands_for(merged, medium, 0.05);
}

// Emission is held on the grid of scattered light by the merged Gaussians.
TEST(MergedMedium, MayShineAndScatter) {
  Scene scene;
  scene.camera.eye = {0.0, 0.0, 5.0};
  std::vector<Gaussian> bank = fog_bank(bank_size, 1.0, 1);
  for (Gaussian& g : bank) g.optics.emission = glm::dvec3(g.center.x > 0.0 ? 1.0 : 0.2);
  scene.medium = medium_of(bank);
  scene.film = {24, 18};
  Settings settings = all_orders(8);
  settings.optical_depth_table = {16, 8};  // of many lights
  const auto mean = [&] {
    const Frame frame = render_frame(scene, settings);
    EXPECT_EQ(frame.statistics.gaussians_merged > 0, settings.merge_error > 0.0);
    return mean_airlight(frame);
  };
  settings.merge_error = 0.02;
  const double merged = mean();
  settings.merge_error = 0.0;
  const double exact = mean();
  EXPECT_NEAR(merged, exact, 0.03 * exact);
}

}  // namespace
}  // namespace brume
