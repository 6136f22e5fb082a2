#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>

#include "brume/at_time.h"
#include "core/authoring/airbrush.h"
#include "core/scene/animation/particles.h"

namespace brume {
namespace {

const Emitter steam{.position = {1, 2, 3},
                    .rate = 20.0,
                    .lifetime = 2.0,
                    .velocity = {0, 3, 0},
                    .spread = 0.5,
                    .acceleration = {0.5, 0, 0},
                    .radius = {0.1, 0.5},
                    .density = {2.0, 0.0},
                    .seed = 7};

TEST(Particles, CountMatchesTheLiveOnes) {
  EXPECT_TRUE(particles_at(steam, -0.01).empty());
  EXPECT_EQ(particles_at(steam, 0.0).size(), 1u);
  EXPECT_EQ(particles_at(steam, 0.99).size(), 20u);
  EXPECT_EQ(particles_at(steam, 30.01).size(), 40u);
  Emitter fast = steam;
  fast.rate = 1e9;
  EXPECT_EQ(particles_at(fast, 5.0).size(), static_cast<std::size_t>(particle_limit));
  fast.rate = 0.0;
  EXPECT_TRUE(particles_at(fast, 5.0).empty());
  fast.rate = 1e12;
  EXPECT_TRUE(particles_at(fast, 1e12).empty());  // beyond counting, but not endless
}

TEST(Particles, FlyOnParabolasAndAge) {
  // The youngest at 1.02 s is number 20, born at 1 s; a second later it is the same one.
  const Gaussian young = particles_at(steam, 1.02).back();
  const Gaussian old = particles_at(steam, 2.02)[19];  // number 0 is gone
  const glm::dvec3 velocity =
      (young.center - steam.position - 0.5 * 0.02 * 0.02 * steam.acceleration) / 0.02;
  EXPECT_LT(glm::length(velocity - steam.velocity), steam.spread);
  const glm::dvec3 expected =
      steam.position + 1.02 * velocity + 0.5 * 1.02 * 1.02 * steam.acceleration;
  EXPECT_LT(glm::distance(old.center, expected), 1e-10);
  EXPECT_NEAR(young.radius, 0.1 + 0.4 * 0.01, 1e-12);
  EXPECT_NEAR(old.density, 2.0 * (1.0 - 0.51), 1e-12);
}

TEST(Particles, ShineAndFade) {
  Emitter fire = steam;
  fire.optics = {glm::dvec3(0.5, 0.25, 1.0), {8.0, 4.0, 0.0}};
  fire.emission_at_death = {4.0, 0.0, 0.0};
  for (const Gaussian& gaussian : particles_at(fire, 2.02)) {
    EXPECT_EQ(gaussian.optics.albedo, fire.optics.albedo);
    const double age = (2.0 - gaussian.density) / 2.0;  // of the lifetime
    EXPECT_NEAR(gaussian.optics.emission.r, 8.0 - 4.0 * age, 1e-12);
    EXPECT_NEAR(gaussian.optics.emission.g, 4.0 - 4.0 * age, 1e-12);
    EXPECT_EQ(gaussian.optics.emission.b, 0.0);
  }
  for (const Gaussian& gaussian : particles_at(steam, 2.02)) {
    EXPECT_EQ(gaussian.optics, GaussianOptics());
  }
}

// Its rate grows from 0 to 40 a second from 1 s to 3 s: the integral is 10 (t - 1)^2.
TEST(Particles, AreBornAtAKeyedRate) {
  Emitter emitter = steam;
  emitter.spread = 0.0;
  emitter.acceleration = {};
  emitter.keys.rate = {{.time = 1.0, .value = 0.0, .interpolation = Interpolation::linear},
                       {.time = 3.0, .value = 40.0}};
  EXPECT_TRUE(particles_at(emitter, 0.99).empty());
  const auto births = [&](double time) {
    std::vector<double> times;
    for (const Gaussian& gaussian : particles_at(emitter, time)) {
      times.push_back(time - (gaussian.center.y - emitter.position.y) / emitter.velocity.y);
    }
    return times;
  };
  const std::vector<double> early = births(2.0001);
  ASSERT_EQ(early.size(), 11u);  // numbers 0 to 10
  for (std::size_t k = 0; k < early.size(); ++k) {
    EXPECT_NEAR(early[k], 1.0 + std::sqrt(0.1 * static_cast<double>(k)), 1e-6);
  }
  // After the last key the rate stays.
  const std::vector<double> late = births(9.0001);
  ASSERT_EQ(late.size(), 80u);
  EXPECT_NEAR(late.back(), 9.0, 1e-6);
  EXPECT_NEAR(late[78], 9.0 - 1.0 / 40.0, 1e-6);
  EXPECT_EQ(emitted_until(emitter, 0.5), 0.0);
  EXPECT_NEAR(emitted_until(emitter, 2.0), 10.0, 1e-9);
  EXPECT_NEAR(emitted_until(emitter, 5.0), 120.0, 1e-9);
  // When it falls to 0, no more are born.
  emitter.keys.rate = {{.time = 0.0, .value = 20.0}, {.time = 1.0, .value = 0.0}};
  EXPECT_EQ(births(1.5).size(), 10u);
  EXPECT_TRUE(births(3.5).empty());
}

TEST(Particles, KeepWhatTheyWereBornWith) {
  Emitter emitter = steam;
  emitter.optics.albedo = glm::dvec3(1.0);
  const auto keyed = [](auto a, auto b) {
    return Keys<decltype(a)>{{.time = 0.0, .value = a, .interpolation = Interpolation::linear},
                             {.time = 4.0, .value = b}};
  };
  using Pair = glm::dvec2;
  using Vector = glm::dvec3;
  emitter.keys = {.position = keyed(Vector(0, 0, 0), Vector(4, 0, 0)),
                  .rate = {},
                  .lifetime = keyed(2.0, 1.0),
                  .velocity = keyed(Vector(0, 1, 0), Vector(0, 5, 0)),
                  .spread = keyed(0.0, 0.0),
                  .acceleration = keyed(Vector(0, 0, 2), Vector(0, 0, 4)),
                  .radius = keyed(Pair(1, 2), Pair(5, 10)),
                  .density = keyed(Pair(2, 0), Pair(2, 4)),
                  .albedo = keyed(Vector(0.2), Vector(1.0)),
                  .emission = keyed(Vector(8, 0, 0), Vector(0, 0, 8)),
                  .emission_at_death = keyed(Vector(0, 0, 0), Vector(4, 0, 0))};
  const std::vector<Gaussian> all = particles_at(emitter, 3.0);
  // Born at t = 2, a quarter of a second before that the lifetime is over: 1.5 s at 2 s.
  const auto number_40 = std::ranges::find_if(
      all, [](const Gaussian& g) { return std::abs(g.center.x - 2.0) < 1e-9; });
  ASSERT_NE(number_40, all.end());
  const double age = 1.0 / 1.5;
  EXPECT_NEAR(number_40->center.y, 3.0, 1e-9);
  EXPECT_NEAR(number_40->center.z, 0.5 * 3.0, 1e-9);
  EXPECT_NEAR(number_40->radius, 3.0 + 3.0 * age, 1e-9);
  EXPECT_NEAR(number_40->density, 2.0 * (1.0 - age) + 2.0 * age, 1e-9);
  EXPECT_NEAR(number_40->optics.albedo->g, 0.6, 1e-9);
  EXPECT_NEAR(number_40->optics.emission.r, 4.0 * (1.0 - age) + 2.0 * age, 1e-9);
  EXPECT_NEAR(number_40->optics.emission.b, 4.0 * (1.0 - age), 1e-9);
  // The oldest alive was born when the lifetime was what it is old: b + 2 - b / 4 = 3.
  EXPECT_NEAR(all.front().center.x, 4.0 / 3.0 + 1.0 / 60.0, 1e-9);  // number 27
  EXPECT_LE(all.size(), max_particles(emitter));
  // The moment that the document shows plays no part.
  Emitter shown = emitter;
  shown.lifetime = 0.0;
  shown.position = {9, 9, 9};
  EXPECT_EQ(particles_at(shown, 3.0), all);
}

TEST(Particles, DependOnTheTimeOnly) {
  const auto once = particles_at(steam, 3.3);
  particles_at(steam, 1.0);
  EXPECT_EQ(particles_at(steam, 3.3), once);
  Emitter other = steam;
  other.seed = 8;
  EXPECT_NE(particles_at(other, 3.3), once);
}

TEST(Particles, JoinTheMediumOfTheirTime) {
  Scene scene;
  scene.medium.append({{0, 0, 0}, 1.0, 1.0});
  scene.emitters = {steam, steam};
  const Scene later = evaluate_at(scene, 0.99);
  EXPECT_EQ(later.medium.size(), 41u);
  EXPECT_EQ(later.medium.gaussian(0), scene.medium.gaussian(0));
  EXPECT_TRUE(later.emitters.empty());
}

// A ball of radius 1 around the origin, seen from inside or outside.
std::optional<Obstacle> ball(const glm::dvec3& origin, const glm::dvec3& direction) {
  const double b = glm::dot(origin, direction);
  const double c = glm::dot(origin, origin) - 1.0;
  const double root = b * b - c;
  if (root < 0.0) return std::nullopt;
  const bool inside = c < 0.0;
  const double t = inside ? -b + std::sqrt(root) : -b - std::sqrt(root);
  if (t < 0.0) return std::nullopt;
  const glm::dvec3 normal = glm::normalize(origin + t * direction);
  return Obstacle{t, inside ? -normal : normal};
}

std::vector<Gaussian> spray(std::uint64_t seed, const glm::dvec3& origin,
                            const glm::dvec3& direction, int steps) {
  Spray made({.radius = 0.1, .density = 0.5, .rate = 200.0, .speed = 2.0, .wander = 1.0}, seed);
  const auto nozzle = [&](double) { return Nozzle{origin, direction}; };
  for (int k = 0; k < steps; ++k) made.advance(1.0 / 30.0, nozzle, ball);
  return made.frozen();
}

TEST(Spray, FillsAClosedSurfaceAndDoesNotLeave) {
  const auto fog = spray(1, {0.9, 0, 0}, {-1, 0, 0}, 150);
  EXPECT_EQ(fog.size(), 1000u);
  int far_side = 0;
  for (const Gaussian& gaussian : fog) {
    EXPECT_LT(glm::length(gaussian.center), 1.0);
    if (gaussian.center.x < -0.3) ++far_side;
  }
  EXPECT_GT(far_side, 100);  // of the ball beyond x = -0.3 there is 28%
}

TEST(Spray, BouncesOffFromOutside) {
  const auto fog = spray(1, {2, 0, 0}, {-1, 0, 0}, 60);
  bool came_near = false;
  for (const Gaussian& gaussian : fog) {
    EXPECT_GT(glm::length(gaussian.center), 1.0);
    came_near = came_near || glm::length(gaussian.center) < 1.1;
  }
  EXPECT_TRUE(came_near);
}

TEST(Spray, CoversThePathOfTheNozzle) {
  Spray made({.radius = 0.1, .density = 0.5, .rate = 3001.0, .speed = 0.0, .wander = 0.0}, 1);
  const auto nowhere = [](const glm::dvec3&, const glm::dvec3&) {
    return std::optional<Obstacle>();
  };
  made.advance(
      1.0 / 30.0,
      [](double moment) {
        return Nozzle{{moment, 0, 0}, {0, 1, 0}};
      },
      nowhere);
  std::array<int, 10> counts{};
  for (const Gaussian& gaussian : made.frozen()) {
    ASSERT_GE(gaussian.center.x, 0.0);
    ++counts.at(static_cast<std::size_t>(10.0 * gaussian.center.x));
  }
  // 100 at random over ten parts: fewer than one in any is a chance of 3e-4.
  for (const int count : counts) EXPECT_GT(count, 0);
  made.advance(
      1.0 / 30.0, [](double) { return std::optional<Nozzle>(); }, nowhere);
  EXPECT_EQ(made.frozen().size(), 100u);
}

TEST(Spray, IsReproducible) {
  EXPECT_EQ(spray(4, {2, 0, 0}, {-1, 0, 0}, 20), spray(4, {2, 0, 0}, {-1, 0, 0}, 20));
  EXPECT_NE(spray(4, {2, 0, 0}, {-1, 0, 0}, 20), spray(5, {2, 0, 0}, {-1, 0, 0}, 20));
}

}  // namespace
}  // namespace brume
