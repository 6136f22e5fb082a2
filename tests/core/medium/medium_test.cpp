#include <gtest/gtest.h>

#include <algorithm>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/matrix.hpp>
#include <random>
#include <vector>

#include "brume/edits.h"
#include "brume/shared_column.h"
#include "tests/random.h"

namespace brume {
namespace {

Medium make_medium(int count) {
  Medium medium;
  for (int i = 0; i < count; ++i) medium.append({{i, 2.0 * i, -i}, 1.0 + i, 0.5 * i});
  return medium;
}

TEST(Medium, FindsGaussiansById) {
  Medium medium = make_medium(3);
  const GaussianId id = medium.ids()[1];
  EXPECT_EQ(medium.index_of(id), 1u);
  MediumEdit::remove(medium, std::vector{id}).apply(medium);
  EXPECT_EQ(medium.index_of(id), std::nullopt);
  EXPECT_EQ(medium.size(), 2u);
}

TEST(Medium, NeverReusesAnId) {
  Medium medium = make_medium(2);
  const GaussianId last = medium.ids()[1];
  MediumEdit::remove(medium, std::vector{last}).apply(medium);
  EXPECT_GT(medium.append({}), last);
}

TEST(MediumEdit, ChangeThatChangesNothingIsEmpty) {
  const Medium medium = make_medium(2);
  const std::vector<GaussianId> ids(medium.ids().begin(), medium.ids().end());
  EXPECT_TRUE(
      MediumEdit::change(medium, ids, std::vector{medium.gaussian(0), medium.gaussian(1)}).empty());
  EXPECT_TRUE(MediumEdit::set_homogeneous_density(medium, 0.0).empty());
}

TEST(MediumEdit, MergedDragIsOneEdit) {
  Medium medium = make_medium(4);
  const Medium start = medium;
  const std::vector<GaussianId> ids{medium.ids()[1], medium.ids()[3]};
  const auto moved = [&](double dx) {
    std::vector<Gaussian> after;
    for (const GaussianId id : ids) {
      after.push_back(medium.gaussian(*medium.index_of(id)));
      after.back().center.x += dx;
    }
    return after;
  };
  MediumEdit drag = MediumEdit::change(medium, ids, moved(1.0));
  drag.apply(medium);
  const MediumEdit second = MediumEdit::change(medium, ids, moved(2.0));
  second.apply(medium);
  drag.merge(second);
  EXPECT_EQ(drag.changed().size(), 2u);

  Medium replay = start;
  drag.apply(replay);
  EXPECT_EQ(replay, medium);
  drag.inverted().apply(replay);
  EXPECT_EQ(replay, start);

  // A drag that comes back to where it began leaves nothing to undo.
  const MediumEdit back = MediumEdit::change(medium, ids, moved(-3.0));
  drag.merge(back);
  EXPECT_TRUE(drag.empty());
}

MediumEdit random_edit(const Medium& medium, std::mt19937& random) {
  std::vector<GaussianId> some;
  for (const GaussianId id : medium.ids()) {
    if (random() % 5 == 0) some.push_back(id);
  }
  std::shuffle(some.begin(), some.end(), random);
  switch (random() % 4) {
    case 0:
      return MediumEdit::add(medium, std::vector<Gaussian>(random() % 4, {{1, 2, 3}, 4, 5}));
    case 1:
      return MediumEdit::remove(medium, some);
    case 2: {
      std::vector<Gaussian> after(some.size());
      for (Gaussian& g : after) g.radius = 1.0 + static_cast<double>(random() % 100);
      return MediumEdit::change(medium, some, after);
    }
    default:
      return MediumEdit::set_homogeneous_density(medium, static_cast<double>(random() % 10));
  }
}

// Random edits; undoing all restores the start exactly, redoing all the end.
TEST(MediumEdit, UndoAllRedoAll) {
  std::mt19937 random(7);
  for (int round = 0; round < 50; ++round) {
    Medium medium = make_medium(20);
    const Medium start = medium;
    std::vector<MediumEdit> history;
    for (int step = 0; step < 40; ++step) {
      history.push_back(random_edit(medium, random));
      history.back().apply(medium);
    }
    const Medium end = medium;
    for (auto edit = history.rbegin(); edit != history.rend(); ++edit) {
      edit->inverted().apply(medium);
    }
    ASSERT_EQ(medium, start);
    for (const MediumEdit& edit : history) edit.apply(medium);
    ASSERT_EQ(medium, end);
  }
}

// Optics and shapes are there while a Gaussian has some.
TEST(MediumEdit, KeepsOpticsAndShapes) {
  Medium medium = make_medium(5);
  const Medium start = medium;
  Gaussian changed = medium.gaussian(2);
  changed.optics = {glm::dvec3(0.5), glm::dvec3(3.0, 1.0, 0.0)};
  changed.set_radii({0.5, 0.1, 0.4}, {0.6, 0.8, 0.0, 0.0});
  std::vector<MediumEdit> history;
  const auto apply = [&](const MediumEdit& edit) {
    history.push_back(edit);
    edit.apply(medium);
  };
  apply(MediumEdit::change(medium, std::vector{medium.ids()[2]}, std::vector{changed}));
  EXPECT_TRUE(medium.has_albedos() && medium.has_emission());
  EXPECT_NE(medium, start);
  apply(MediumEdit::remove(medium, std::vector{medium.ids()[0], medium.ids()[3]}));
  EXPECT_EQ(medium.gaussian(1), changed);
  EXPECT_EQ(medium.gaussian(0), start.gaussian(1));
  apply(MediumEdit::add(medium, std::vector{Gaussian{}, changed}));
  EXPECT_EQ(medium.gaussian(4), changed);
  EXPECT_EQ(medium.gaussian(3), Gaussian());
  // One that goes and comes back in the middle.
  apply(MediumEdit::remove(medium, std::vector{medium.ids()[1]}));
  const Medium end = medium;
  while (!history.empty()) {
    history.back().inverted().apply(medium);
    history.pop_back();
  }
  EXPECT_EQ(medium, start);
  EXPECT_EQ(start, medium);
  EXPECT_FALSE(medium.has_albedos() || medium.has_emission());
  EXPECT_NE(end, start);
}

// A whole history merges into one edit that does and undoes the same.
TEST(MediumEdit, AnyEditsMerge) {
  std::mt19937 random(11);
  for (int round = 0; round < 50; ++round) {
    Medium medium = make_medium(20);
    const Medium start = medium;
    MediumEdit all;
    for (int step = 0; step < 30; ++step) {
      const MediumEdit edit = random_edit(medium, random);
      edit.apply(medium);
      all.merge(edit);
      Medium replay = start;
      all.apply(replay);
      ASSERT_EQ(replay, medium);
      all.inverted().apply(replay);
      ASSERT_EQ(replay, start);
    }
    all.merge(all.inverted());
    EXPECT_TRUE(all.empty());
  }
}

TEST(MediumEdit, AddingThenRemovingCancels) {
  Medium medium = make_medium(3);
  MediumEdit stroke = MediumEdit::add(medium, std::vector<Gaussian>(5));
  stroke.apply(medium);
  stroke.merge(MediumEdit::remove(medium, medium.ids().subspan(3)));
  EXPECT_TRUE(stroke.empty());
}

TEST(MediumRevision, IsSharedByCopiesAndNewAfterEachChange) {
  Medium medium = make_medium(2);
  EXPECT_EQ(Medium().revision(), 0u);
  const Medium copy = medium;
  EXPECT_EQ(copy.revision(), medium.revision());
  std::vector<Revision> seen{0, medium.revision()};
  const auto is_new = [&] {
    const bool found = std::ranges::find(seen, medium.revision()) != seen.end();
    seen.push_back(medium.revision());
    return !found;
  };
  medium.append({});
  EXPECT_TRUE(is_new());
  medium.set_homogeneous_density(0.5);
  EXPECT_TRUE(is_new());
  MediumEdit::remove(medium, std::vector{medium.ids()[0]}).apply(medium);
  EXPECT_TRUE(is_new());
  EXPECT_NE(medium.changed(1.0, [](const Gaussian& g) { return g; }).revision(), medium.revision());
  medium.set_homogeneous_density(0.5);
  MediumEdit().apply(medium);
  EXPECT_FALSE(is_new()) << "nothing has changed";
  EXPECT_EQ(copy.revision(), seen[1]);
}

// A Gaussian stretched along its own axes keeps them, so that its numbers are those one expects.
TEST(Gaussian, OtherRadiiKeepItsRotation) {
  const glm::dquat turn(0.6, 0.0, 0.8, 0.0);
  Gaussian g;
  g.set_radii({0.5, 0.1, 0.2}, 3.0 * turn);
  EXPECT_LT(glm::length(g.shape.rotation - turn), 1e-15);
  const Gaussian before = g;
  g.set_radii(2.0 * g.radii(), g.shape.rotation);
  EXPECT_EQ(g.shape, before.shape);
  EXPECT_EQ(g.radius, 2.0 * before.radius);
  g.set_radii(glm::dvec3(0.3), g.shape.rotation);
  EXPECT_TRUE(g.is_ball());
}

TEST(Transform, KeepsTheOrderOfAxes) {
  Gaussian ball{.center = {1, 2, 3}, .radius = 0.5, .density = 1.0};
  for (int axis = 0; axis < 3; ++axis) {
    glm::dmat3 map(1.0);
    map[axis][axis] = 3.0;
    Gaussian long_one = ball;
    transform(long_one, map);
    glm::dvec3 radii(0.5);
    radii[axis] = 1.5;
    EXPECT_LT(glm::distance(long_one.radii(), radii), 1e-14);
    EXPECT_EQ(long_one.shape.rotation, glm::dquat(1, 0, 0, 0));
    EXPECT_EQ(long_one.center, ball.center);
    map[axis][axis] = 1.0 / 3.0;
    transform(long_one, map);
    EXPECT_TRUE(long_one.is_ball());
  }
  // Turned ones as well.
  const glm::dquat rotation = glm::angleAxis(0.4, glm::normalize(glm::dvec3(1, 2, -3)));
  const glm::dmat3 axes = glm::mat3_cast(rotation);
  Gaussian turned = ball;
  turned.set_radii({0.2, 0.5, 0.4}, rotation);
  const glm::dmat3 along(axes[0] * 4.0, axes[1], axes[2]);
  transform(turned, along * glm::transpose(axes));
  EXPECT_LT(glm::distance(turned.radii(), glm::dvec3(0.8, 0.5, 0.4)), 1e-14);
  EXPECT_NEAR(glm::dot(turned.shape.rotation, rotation), 1.0, 1e-14);
}

TEST(MediumEdit, AddsWithIdsOfAFile) {
  Medium medium;
  medium.append({{0, 0, 0}, 1, 1});
  const std::vector<Gaussian> two{{{1, 0, 0}, 1, 1}, {{2, 0, 0}, 1, 1}};
  const std::vector<GaussianId> ids{5, 9};
  const MediumEdit edit = MediumEdit::add(medium, two, ids);
  edit.apply(medium);
  EXPECT_TRUE(std::ranges::equal(medium.ids(), std::vector<GaussianId>{1, 5, 9}));
  EXPECT_EQ(medium.gaussian(*medium.index_of(9)), two[1]);
  EXPECT_EQ(medium.next_id(), 10u);
  edit.inverted().apply(medium);
  EXPECT_EQ(medium.size(), 1u);
}

// Copies that are written to in all ways, each beside a vector.
TEST(SharedColumn, CopiesAreAsIfTheirOwn) {
  struct Pair {
    SharedColumn<int> column;
    std::vector<int> plain;
  };
  Random random(3);
  const auto below = [&](std::size_t n) {
    return static_cast<std::size_t>(random.uniform(0.0, static_cast<double>(n)));
  };
  std::vector<Pair> pairs(6);
  for (int step = 0; step < 20'000; ++step) {
    Pair& pair = pairs[below(pairs.size())];
    switch (below(6)) {
      case 0:
        pair = pairs[below(pairs.size())];
        break;
      case 1:
      case 2:
        pair.column.push_back(step);
        pair.plain.push_back(step);
        break;
      case 3:
        if (pair.plain.empty()) break;
        pair.column.set(0, step);
        pair.plain[0] = step;
        break;
      case 4: {
        const std::size_t size = below(pair.plain.size() + 4);
        pair.column.resize(size, step);
        pair.plain.resize(size, step);
        break;
      }
      default:
        for (int& each : pair.column.write()) ++each;
        for (int& each : pair.plain) ++each;
    }
    for (const Pair& each : pairs) {
      ASSERT_TRUE(std::ranges::equal(each.column.all(), each.plain)) << step;
    }
  }
}

TEST(SharedColumn, CopiesAreFreeUntilWritten) {
  SharedColumn<double> column;
  column.reserve(10);
  for (int i = 0; i < 5; ++i) column.push_back(i);
  SharedColumn<double> copy = column;
  EXPECT_TRUE(copy.is_shared_with(column));
  // The end belongs to the first that takes it.
  column.push_back(5.0);
  EXPECT_EQ(column.all().data(), copy.all().data());
  copy.push_back(6.0);
  EXPECT_NE(column.all().data(), copy.all().data());
  EXPECT_EQ(column[5], 5.0);
  EXPECT_EQ(copy[5], 6.0);
  // Writing what is there already is no change.
  copy = column;
  copy.set(2, 2.0);
  EXPECT_TRUE(copy.is_shared_with(column));
  copy.set(2, 3.0);
  EXPECT_FALSE(copy.is_shared_with(column));
  EXPECT_EQ(column[2], 2.0);
}

TEST(SharedColumn, MovedFromIsEmpty) {
  SharedColumn<int> column;
  column.push_back(1);
  const SharedColumn<int> moved = std::move(column);
  EXPECT_TRUE(column.empty());  // NOLINT(bugprone-use-after-move)
  EXPECT_EQ(moved.size(), 1u);
}

}  // namespace

}  // namespace brume
