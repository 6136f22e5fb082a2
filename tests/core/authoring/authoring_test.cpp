#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <numbers>
#include <random>

#include "core/authoring/airbrush.h"
#include "core/authoring/contribution.h"
#include "core/authoring/eraser.h"
#include "core/authoring/mirror.h"
#include "core/authoring/neighbours.h"
#include "core/authoring/paintbrush.h"
#include "core/authoring/smooth_path.h"
#include "core/math/infinity.h"
#include "core/transport/optical_depth.h"

namespace brume {
namespace {

std::vector<Gaussian> paint(const Paintbrush& brush, std::uint64_t seed,
                            const std::vector<glm::dvec3>& path) {
  PaintStroke stroke(brush, seed);
  std::vector<Gaussian> all;
  for (const glm::dvec3& point : path) {
    const auto more = stroke.extend(point);
    all.insert(all.end(), more.begin(), more.end());
  }
  return all;
}

TEST(PaintStroke, SpacesGaussiansEvenly) {
  const Paintbrush brush{.radius = 0.5, .density = 2.0, .spacing = 0.8, .scatter = 0.0};
  const auto gaussians = paint(brush, 1, {{0, 0, 0}, {1, 0, 0}, {1, 3, 0}});
  ASSERT_EQ(gaussians.size(), 11u);  // a path of 4 in steps of 0.4
  for (std::size_t k = 0; k < gaussians.size(); ++k) {
    const double s = 0.4 * static_cast<double>(k);
    const glm::dvec3 on_path = s <= 1.0 ? glm::dvec3(s, 0, 0) : glm::dvec3(1.0, s - 1.0, 0);
    EXPECT_LT(glm::distance(gaussians[k].center, on_path), 1e-12) << k;
    EXPECT_EQ(gaussians[k].radius, 0.5);
    EXPECT_EQ(gaussians[k].density, 2.0);
  }
}

TEST(PaintStroke, StretchesAlongTheStroke) {
  const Paintbrush brush{
      .radius = 0.5, .density = 2.0, .spacing = 0.8, .scatter = 0.0, .stretch = 2.5};
  const auto gaussians = paint(brush, 1, {{0, 0, 0}, {1.5, 0, 0}, {1.5, 2.5, 0}});
  ASSERT_EQ(gaussians.size(), 5u);  // a path of 4 in steps of 1, after 0.7 from the ball
  EXPECT_LT(glm::distance(gaussians[1].center, glm::dvec3(0.7, 0, 0)), 1e-12);
  EXPECT_LT(glm::distance(gaussians[2].center, glm::dvec3(1.5, 0.2, 0)), 1e-12);
  EXPECT_TRUE(gaussians[0].is_ball());
  for (std::size_t k = 1; k < gaussians.size(); ++k) {
    EXPECT_EQ(gaussians[k].radius, 1.25);
    EXPECT_EQ(gaussians[k].density, 2.0);
    const glm::dvec3 radii = glm::dvec3(0.5, 0.5, 1.25);
    EXPECT_LT(glm::distance(gaussians[k].radii(), radii), 1e-12);
    const glm::dvec3 direction = k == 1 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
    const glm::dvec3 long_axis = gaussians[k].shape.rotation * glm::dvec3(0, 0, 1);
    EXPECT_NEAR(std::abs(glm::dot(long_axis, direction)), 1.0, 1e-12) << k;
  }
}

TEST(Spray, StretchesAlongTheWayOfParticles) {
  Airbrush airbrush{.radius = 0.1, .rate = 60.0, .spread = 0.3};
  const auto spray = [&airbrush] {
    Spray result(airbrush, 1);
    for (int k = 0; k < 30; ++k) {
      result.advance(
          1.0 / 30.0,
          [](double) {
            return Nozzle{{0, 0, 0}, {0, 1, 0}};
          },
          [](const auto&, const auto&) { return std::nullopt; });
    }
    return result.frozen();
  };
  EXPECT_EQ(spray().size(), 60u);
  airbrush.stretch = 3.0;
  const std::vector<Gaussian> stretched = spray();
  EXPECT_NEAR(static_cast<double>(stretched.size()), 20.0, 1.0);
  double upwards = 0.0;
  for (const Gaussian& gaussian : stretched) {
    EXPECT_LT(glm::distance(gaussian.radii(), glm::dvec3(0.1, 0.1, 0.3)), 1e-12);
    upwards += std::abs((gaussian.shape.rotation * glm::dvec3(0, 0, 1)).y);
  }
  EXPECT_GT(upwards / static_cast<double>(stretched.size()), 0.8);
}

TEST(Neighbours, EllipsoidsTouchByWhatTheyReach) {
  Medium medium;
  Gaussian flat{.center = {0, 0, 0}, .density = 1.0};
  flat.set_radii({1.0, 0.1, 0.1}, {1, 0, 0, 0});
  medium.append(flat);
  medium.append({{1.4, 0.0, 0.0}, 0.5, 1.0});
  medium.append({{0.0, 0.7, 0.0}, 0.5, 1.0});
  const auto ids = medium.ids();
  EXPECT_EQ(touching(medium, ids.first(1)), (std::vector{ids[0], ids[1]}));
}

TEST(Mirror, ImagesOfEllipsoidsAreAsDenseAtMirroredPoints) {
  Gaussian gaussian{.center = {0.5, 1.0, -0.3}, .density = 1.0};
  gaussian.set_radii({0.2, 1.0, 0.5}, glm::angleAxis(0.7, glm::normalize(glm::dvec3(1, -2, 3))));
  const MirrorPlanes planes{{true, true, false}, {0.1, 0.2, 0.3}};
  const std::vector<Gaussian> images = mirror_images(gaussian, planes);
  ASSERT_EQ(images.size(), 4u);
  const auto exponent = [](const Gaussian& g, const glm::dvec3& x) {
    return glm::length(warp(g.shape) * (x - g.center)) / g.radius;
  };
  const glm::dvec3 point(0.7, 0.6, 0.1);
  for (std::size_t k = 0; k < images.size(); ++k) {
    glm::dvec3 mirrored = point;
    if (k % 2 == 1) mirrored.x = 0.2 - point.x;
    if (k / 2 == 1) mirrored.y = 0.4 - point.y;
    EXPECT_NEAR(exponent(images[k], mirrored), exponent(gaussian, point), 1e-12) << k;
  }
}

TEST(PaintStroke, ScattersAcrossTheStrokeByLessThanTheRadius) {
  const Paintbrush brush{.radius = 0.25, .density = 1.0, .spacing = 0.5, .scatter = 1.0};
  const glm::dvec3 end(30.0, 40.0, -50.0);
  const glm::dvec3 direction = glm::normalize(end);
  const auto gaussians = paint(brush, 3, {{0, 0, 0}, end});
  ASSERT_GT(gaussians.size(), 500u);
  double farthest = 0.0;
  double sum_of_squares = 0.0;
  for (std::size_t k = 0; k < gaussians.size(); ++k) {
    const glm::dvec3 offset = gaussians[k].center - 0.125 * static_cast<double>(k) * direction;
    EXPECT_NEAR(glm::dot(offset, direction), 0.0, 1e-10);
    EXPECT_LT(glm::length(offset), 0.25);
    farthest = std::max(farthest, glm::length(offset));
    sum_of_squares += glm::dot(offset, offset);
  }
  EXPECT_GT(farthest, 0.24);
  // The mean square in a disc is half the radius squared; 5 standard errors of 565 of them.
  EXPECT_NEAR(sum_of_squares / static_cast<double>(gaussians.size()), 0.5 * 0.0625,
              5.0 * 0.0625 / std::sqrt(12.0 * 565.0));
}

TEST(PaintStroke, DependsOnSeedAndPathOnly) {
  const Paintbrush brush;
  const auto few = paint(brush, 5, {{0, 0, 0}, {4, 0, 0}});
  std::vector<glm::dvec3> points;
  for (int k = 0; k <= 64; ++k) points.emplace_back(k / 16.0, 0, 0);
  const auto many = paint(brush, 5, points);
  ASSERT_EQ(few.size(), many.size());
  for (std::size_t k = 0; k < few.size(); ++k) {
    EXPECT_LT(glm::distance(few[k].center, many[k].center), 1e-12);
  }
  EXPECT_EQ(paint(brush, 5, points), many);
  EXPECT_NE(paint(brush, 6, points), many);
}

TEST(PaintStroke, AHugeJumpRestartsTheStroke) {
  PaintStroke stroke({.radius = 1e-3}, 1);
  stroke.extend({0, 0, 0});
  const auto far = stroke.extend({1e9, 0, 0});
  ASSERT_EQ(far.size(), 1u);
  EXPECT_EQ(far[0].center, glm::dvec3(1e9, 0, 0));
}

Medium row_of_three() {
  Medium medium;
  for (const double x : {0.0, 0.5, 3.0}) medium.append({{x, 0, -10}, 1.0, 0.8});
  return medium;
}
const auto any_gaussian = [](GaussianId /*id*/) { return true; };

TEST(Eraser, ThinsWhatItCoversAndDeletesWhatHasNoneLeft) {
  Medium medium = row_of_three();
  const Medium start = medium;
  const EraserCone cone{{0, 0, 0}, {0, 0, -1}, 0.1};  // 1 u wide at the Gaussians
  const double cover = eraser_cover(cone, {0.5, 0, -10});
  EXPECT_DOUBLE_EQ(cover, 0.5625);
  EXPECT_EQ(eraser_cover(cone, {1.0, 0, -10}), 0.0);
  EXPECT_EQ(eraser_cover(cone, {0, 0, 10}), 0.0);  // behind the eye
  EXPECT_EQ(eraser_cover(cone, {0, 0, -5}), 1.0);

  EraserStroke stroke(0.4);
  MediumEdit merged;
  const auto touch = [&] {
    const MediumEdit edit = stroke.touch(medium, {&cone, 1}, any_gaussian);
    edit.apply(medium);
    merged.merge(edit);
  };
  touch();
  EXPECT_DOUBLE_EQ(medium.densities()[0], 0.8 * 0.6);
  EXPECT_DOUBLE_EQ(medium.densities()[1], 0.8 * (1.0 - 0.4 * cover));
  EXPECT_EQ(medium.densities()[2], 0.8);
  touch();
  touch();
  EXPECT_EQ(medium.size(), 2u);
  EXPECT_FALSE(medium.index_of(start.ids()[0]));
  touch();
  touch();
  EXPECT_EQ(medium.size(), 1u);
  merged.inverted().apply(medium);
  EXPECT_EQ(medium, start);
}

TEST(Eraser, TouchesAtOnceAreTouchesOneByOne) {
  const Medium start = row_of_three();
  std::vector<EraserCone> cones;
  for (int k = 0; k < 8; ++k) {
    cones.push_back({{0, 0, 0}, glm::normalize(glm::dvec3(0.02 * k, 0, -1)), 0.1});
  }
  Medium one_by_one = start;
  EraserStroke slow(0.3);
  for (const EraserCone& cone : cones) {
    slow.touch(one_by_one, {&cone, 1}, any_gaussian).apply(one_by_one);
  }
  Medium at_once = start;
  EraserStroke(0.3).touch(at_once, cones, any_gaussian).apply(at_once);
  EXPECT_EQ(at_once, one_by_one);
  EXPECT_LT(at_once.size(), start.size());
}

TEST(Eraser, TouchesOnlyWhatItMay) {
  const Medium medium = row_of_three();
  EraserStroke stroke(1.0);
  const GaussianId locked = medium.ids()[0];
  const EraserCone cone{{0, 0, 0}, {0, 0, -1}, 0.1};
  const MediumEdit edit =
      stroke.touch(medium, {&cone, 1}, [&](GaussianId id) { return id != locked; });
  EXPECT_TRUE(edit.removed().empty());
  ASSERT_EQ(edit.changed().size(), 1u);
  EXPECT_EQ(edit.changed()[0].id, medium.ids()[1]);
}

// How far a curve through some positions of a spiral, given one by one, is from the spiral
// [pixels].
TEST(SmoothPath, FollowsASpiralThroughFewPositions) {
  // Four turns out to 120 pixels, 31 positions a turn: a second of a mouse at 125 Hz.
  const auto spiral = [](double turns) {
    const double angle = 2.0 * std::numbers::pi * turns;
    return 30.0 * turns * glm::dvec2(std::cos(angle), std::sin(angle));
  };
  SmoothPath path(spiral(0.0), 3.0);
  std::vector<glm::dvec2> curve{spiral(0.0)};
  const auto append = [&](const std::vector<glm::dvec2>& more) {
    curve.insert(curve.end(), more.begin(), more.end());
  };
  for (int k = 1; k <= 124; ++k) append(path.extend(spiral(k / 31.0)));
  append(path.end());
  EXPECT_EQ(curve.back(), spiral(4.0));
  double polygon = 0.0;  // how far the middles between positions are from the spiral
  double smooth = 0.0;
  const auto distance = [&](const glm::dvec2& point) {
    double nearest = 1e9;
    for (int k = 0; k <= 20000; ++k) {
      nearest = std::min(nearest, glm::distance(point, spiral(k * 2e-4)));
    }
    return nearest;
  };
  for (std::size_t k = 0; k < curve.size(); ++k) {
    if (k > 0) {
      EXPECT_LT(glm::distance(curve[k], curve[k - 1]), 4.0);
    }
    // The last piece, of 24 pixels, does not know how it would have gone on.
    if (k % 5 == 0 && k + 10 < curve.size()) smooth = std::max(smooth, distance(curve[k]));
  }
  for (int k = 90; k < 124; ++k) {
    polygon = std::max(polygon, distance(0.5 * (spiral(k / 31.0) + spiral((k + 1) / 31.0))));
  }
  EXPECT_GT(polygon, 0.5);
  EXPECT_LT(smooth, 0.1);
}

TEST(SmoothPath, InterpolatesWithoutCusps) {
  // Far apart and close together in turn: where other Catmull-Rom curves loop.
  const std::vector<glm::dvec2> positions{{0, 0},    {100, 0}, {101, 1}, {101, 1},
                                          {102, 60}, {20, 61}, {20, 60}};
  SmoothPath path(positions[0], 0.5);
  std::vector<glm::dvec2> curve{positions[0]};
  for (const glm::dvec2& position : positions) {
    const auto more = path.extend(position);
    curve.insert(curve.end(), more.begin(), more.end());
  }
  const auto rest = path.end();
  curve.insert(curve.end(), rest.begin(), rest.end());
  for (const glm::dvec2& position : positions) {
    EXPECT_TRUE(std::find(curve.begin(), curve.end(), position) != curve.end());
  }
  for (std::size_t k = 1; k < curve.size(); ++k) {
    EXPECT_GT(glm::distance(curve[k], curve[k - 1]), 0.0);
    if (k > 1) {
      EXPECT_GT(glm::distance(curve[k], curve[k - 2]), 0.05);  // it never turns back
    }
  }
  EXPECT_TRUE(path.end().empty());
}

TEST(Contributions, SharesAreWhatTheRayLoses) {
  Medium medium;
  medium.append({{0, 0, -20}, 1.0, 5.0});
  medium.append({{0.3, 0, -10}, 1.0, 1.0});
  medium.append({{9, 0, -10}, 1.0, 1.0});
  const auto met = contributions(medium, glm::dvec3(1.0), {0, 0, 0}, {0, 0, -1});
  ASSERT_EQ(met.size(), 2u);
  double sum = 0.0;
  double depth = 0.0;
  for (const Contribution& c : met) {
    const double expected =
        optical_depth(medium.gaussian(c.index), glm::dvec3(0), glm::dvec3(0, 0, -1000));
    EXPECT_NEAR(c.optical_depth.g, expected, 1e-12);
    sum += c.fraction;
    depth += c.optical_depth.g;
  }
  EXPECT_NEAR(sum, 1.0 - std::exp(-depth), 1e-12);
  EXPECT_EQ(met[0].index, 1u);  // the thinner one, but it stands before the other
  EXPECT_GT(met[0].fraction, met[1].fraction);
  // A surface between them hides the far one.
  EXPECT_EQ(contributions(medium, glm::dvec3(1.0), {0, 0, 0}, {0, 0, -1}, 15.0).size(), 1u);
}

// A small thin Gaussian is a point that scatters: (I / d^2) tau albedo / 4 pi, less what b0 and the
// Gaussian before it take away on both ways.
TEST(Contributions, RadianceOfALightIsThatOfAPointInThinFog) {
  Scene scene;
  scene.medium.append({{0, 0, -10}, 0.05, 0.1});
  scene.medium.append({{0, 0, -4}, 0.5, 0.4});
  scene.medium.set_homogeneous_density(0.02);
  scene.optics.albedo = {1.0, 0.5, 0.5};
  PointLight light;
  light.position = {3, 0, -10};
  light.intensity = {7.0, 7.0, 14.0};
  const glm::dvec3 towards(0, 0, -1);
  const auto met = contributions(scene.medium, scene.optics.albedo, {0, 0, 0}, towards);
  ASSERT_EQ(met.size(), 2u);
  const auto& far = met[0].index == 0 ? met[0] : met[1];
  EXPECT_NEAR(far.distance, 10.0, 1e-3);
  const double in_front = std::sqrt(M_PI) * 0.5 * 0.4;
  EXPECT_NEAR(far.depth_in_front.r, in_front + 0.02 * 10.0, 1e-4);
  EXPECT_NEAR(far.depth_in_front.g, 2.0 * far.depth_in_front.r, 1e-12);
  const glm::dvec3 radiance = scattered_radiance(scene, far, {0, 0, 0}, towards, light);
  const auto expected = [&](double intensity, double albedo) {
    const double taken = (in_front + 0.02 * 13.0) / albedo;
    return intensity / 9.0 * far.optical_depth.r / (4.0 * M_PI) * std::exp(-taken);
  };
  EXPECT_NEAR(radiance.r, expected(7.0, 1.0), 0.01 * radiance.r);
  EXPECT_NEAR(radiance.g, expected(7.0, 0.5), 0.02 * radiance.g);
  EXPECT_NEAR(radiance.b, 2.0 * radiance.g, 1e-12);
}

// Gaussians of any albedo and emission in a row along a ray, against sums over all pairs.
TEST(Contributions, EmissionIsAttenuatedByTheExtinctionInFront) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  const glm::dvec3 medium_albedo(0.9, 0.6, 0.3);
  for (int round = 0; round < 20; ++round) {
    Medium medium;
    medium.set_homogeneous_density(0.05 * uniform(random));
    for (int i = 0; i < 6; ++i) {
      GaussianOptics optics;
      if (i % 2 == 0) optics.albedo = glm::dvec3(1.0, uniform(random), 0.5) * 0.9 + 0.1;
      if (i % 3 != 0) optics.emission = 9.0 * glm::dvec3(uniform(random), uniform(random), 0.0);
      medium.append({{uniform(random), 0, -10.0 * uniform(random) - 3.0}, 0.9, 2.0, optics});
    }
    const glm::dvec3 eye(0.0);
    const glm::dvec3 direction(0, 0, -1);
    const auto met = contributions(medium, medium_albedo, eye, direction, infinity, 0.0);
    ASSERT_EQ(met.size(), 6u);
    // Its optical depth up to a distance, and where on the ray it is.
    const auto depth = [&](std::size_t i) {
      const Gaussian g = medium.gaussian(i);
      return optical_depth(g, eye, glm::dvec3(0, 0, -1000)) /
             g.optics.albedo.value_or(medium_albedo);
    };
    const auto place = [&](std::size_t i) { return -medium.centers()[i].z; };
    for (std::size_t k = 0; k < met.size(); ++k) {
      const std::size_t i = met[k].index;
      glm::dvec3 in_front = medium.homogeneous_density() * met[k].distance / medium_albedo;
      EXPECT_NEAR(met[k].distance, place(i), 1e-2);  // some begin behind the eye
      for (std::size_t j = 0; j < medium.size(); ++j) {
        if (place(j) < place(i)) in_front += depth(j);
      }
      for (int c = 0; c < 3; ++c) {
        const double attenuated = std::exp(-in_front[c]) * (1.0 - std::exp(-depth(i)[c]));
        EXPECT_NEAR(met[k].emitted[c], medium.optics(i).emission[c] * attenuated, 1e-9);
        EXPECT_NEAR(met[k].depth_in_front[c], in_front[c], 1e-9);
      }
      if (k > 0) {
        EXPECT_LE(met[k].effect(), met[k - 1].effect());
      }
    }
  }
}

// Too thin to be seen against a background, but bright.
TEST(Contributions, ThinGaussiansThatShineAreMet) {
  Medium medium;
  medium.append({{0, 0, -5}, 1.0, 1e-4});
  medium.append({{0, 0, -5}, 1.0, 1e-4, {.emission = {0, 0, 1000}}});
  const auto met = contributions(medium, glm::dvec3(1.0), {0, 0, 0}, {0, 0, -1});
  ASSERT_EQ(met.size(), 1u);
  EXPECT_EQ(met[0].index, 1u);
  EXPECT_NEAR(met[0].emitted.b, 0.1772, 1e-4);
}

TEST(FogOnRay, FindsHowFarOneSees) {
  Scene scene;
  scene.optics.albedo = glm::dvec3(0.5);
  scene.medium.append({{0, 0, -4}, 0.5, 0.3});
  scene.medium.append({{0, 0, -9}, 0.5, 0.3});
  scene.medium.append({{3, 0, -6}, 0.5, 9.0});  // aside
  const FogOnRay clear(scene, {0, 0, 0}, {0, 0, -1}, {0.0, infinity});
  const double each = std::sqrt(std::numbers::pi) * 0.5 * 0.3 / 0.5;
  EXPECT_NEAR(clear.optical_depth(6.5), each, 1e-6);
  EXPECT_NEAR(clear.optical_depth(infinity), 2.0 * each, 1e-6);
  // The half of the light that both take is lost within the first, which has more than that.
  const double lost = 0.5 * -std::expm1(-2.0 * each);
  const auto middle = clear.middle_of_gaussians(0.02);
  ASSERT_TRUE(middle);
  EXPECT_NEAR(-std::expm1(-clear.optical_depth(*middle)), lost, 1e-6);
  EXPECT_NEAR(*middle, 4.0, 0.5);
  EXPECT_EQ(clear.distance_at(2.1 * each), infinity);
  EXPECT_FALSE(FogOnRay(scene, {0, 0, 0}, {0, 1, 0}, {0.0, infinity}).middle_of_gaussians(0.02));

  scene.medium.set_homogeneous_density(0.1);
  const FogOnRay hazy(scene, {0, 0, 0}, {0, 1, 0}, {2.0, 50.0});
  EXPECT_NEAR(hazy.distance_at(0.6), 5.0, 1e-6);
  EXPECT_NEAR(hazy.optical_depth(infinity), 9.6, 1e-9);
}

TEST(PaintStroke, BeginsAnewWhereItIsLifted) {
  PaintStroke stroke({.radius = 0.5, .spacing = 1.0, .scatter = 0.0}, 1);
  EXPECT_EQ(stroke.extend({0, 0, 0}).size(), 1u);
  stroke.lift();
  const auto next = stroke.extend({10, 0, 0});
  ASSERT_EQ(next.size(), 1u);
  EXPECT_EQ(next.front().center, glm::dvec3(10, 0, 0));
}

}  // namespace
}  // namespace brume
