// Keyframes with slopes of their own, and what they may not do to the values of a scene.

#include <gtest/gtest.h>

#include <cmath>
#include <string_view>

#include "brume/keys.h"
#include "brume/limits.h"
#include "core/number_domain.h"
#include "core/scene/animation/animation.h"
#include "core/scene/animation/keys_in_domain.h"
#include "core/scene/animation/particles.h"

namespace brume {
namespace {

// The Hermite basis as textbooks have it.
double hermite(double a, double slope_a, double b, double slope_b, double length, double u) {
  return (2 * u * u * u - 3 * u * u + 1) * a + (u * u * u - 2 * u * u + u) * length * slope_a +
         (-2 * u * u * u + 3 * u * u) * b + (u * u * u - u * u) * length * slope_b;
}

TEST(Tangents, GiveTheCubicOfTheirSlopes) {
  const Keys<glm::dvec2> keys{{.time = 1.0, .value = {2.0, 0.0}, .out = glm::dvec2(5.0, -3.0)},
                              {.time = 3.0, .value = {4.0, 1.0}, .in = glm::dvec2(-7.0, 0.5)}};
  for (double u = 0.0; u < 1.0; u += 0.05) {
    const glm::dvec2 value = value_at(keys, 1.0 + 2.0 * u);
    EXPECT_NEAR(value.x, hermite(2.0, 5.0, 4.0, -7.0, 2.0, u), 1e-12);
    EXPECT_NEAR(value.y, hermite(0.0, -3.0, 1.0, 0.5, 2.0, u), 1e-12);
  }
  // At the keys, and beyond them, the values are theirs.
  EXPECT_EQ(value_at(keys, 1.0), keys[0].value);
  EXPECT_EQ(value_at(keys, 3.0), keys[1].value);
  EXPECT_EQ(value_at(keys, 9.0), keys[1].value);
}

// 54 / 29 is the automatic slope at the second key; see SmoothHasTheSlopesOfFritschAndButland.
TEST(Tangents, OneMayBeAutomatic) {
  Keys<double> keys{{.time = 0.0, .value = 0.0},
                    {.time = 1.0, .value = 1.0},
                    {.time = 1.5, .value = 4.0},
                    {.time = 2.0, .value = 4.0}};
  EXPECT_NEAR(slopes_at(keys, 1).out, 54.0 / 29.0, 1e-12);
  const double before = value_at(keys, 0.5);
  keys[2].in = -2.0;
  EXPECT_EQ(value_at(keys, 0.5), before);
  EXPECT_EQ(value_at(keys, 1.75), 4.0);
  EXPECT_NEAR(value_at(keys, 1.25), hermite(1.0, 54.0 / 29.0, 4.0, -2.0, 0.5, 0.5), 1e-12);
  EXPECT_EQ(slopes_at(keys, 2).in, -2.0);
  EXPECT_EQ(slopes_at(keys, 2).out, 0.0);
  EXPECT_EQ(slopes_at(keys, 0).in, 0.0);
}

// A curve whose tangents are the automatic slopes is the curve without.
TEST(Tangents, OfAutomaticSlopesChangeNothing) {
  const Keys<glm::dvec3> automatic{{.time = 0.0, .value = {0, 3, 1}},
                                   {.time = 1.0, .value = {1, 2, 1}},
                                   {.time = 1.2, .value = {4, 1.5, 1}},
                                   {.time = 4.0, .value = {5, 0, 9}}};
  Keys<glm::dvec3> keys = automatic;
  for (std::size_t i = 0; i < keys.size(); ++i) {
    const Slopes<glm::dvec3> slopes = slopes_at(automatic, i);
    keys[i].in = slopes.in;
    keys[i].out = slopes.out;
  }
  for (double time = -0.5; time < 4.5; time += 0.01) {
    const glm::dvec3 difference = value_at(keys, time) - value_at(automatic, time);
    for (int k = 0; k < 3; ++k) ASSERT_NEAR(difference[k], 0.0, 1e-12);
  }
}

TEST(Tangents, CountForNothingWhereItIsNotSmooth) {
  Keys<double> keys{
      {.time = 0.0, .value = 1.0, .interpolation = Interpolation::linear, .out = 50.0},
      {.time = 2.0, .value = 3.0, .interpolation = Interpolation::constant, .in = 50.0, .out = 9.0},
      {.time = 4.0, .value = 7.0, .in = 9.0}};
  EXPECT_DOUBLE_EQ(value_at(keys, 1.0), 2.0);
  EXPECT_EQ(value_at(keys, 2.0), 3.0);
  EXPECT_EQ(value_at(keys, std::nextafter(4.0, 0.0)), 3.0);
  EXPECT_EQ(value_at(keys, 4.0), 7.0);
  EXPECT_NEAR(integral(keys, 0.0, 5.0), 4.0 + 6.0 + 7.0, 1e-12);
  EXPECT_EQ(upper_bound(keys), 7.0);
}

// They are as steep as a file may have them, between keys as near and as far as may be.
TEST(Tangents, AreFiniteHoweverSteep) {
  for (const double length : {min_key_distance, 1.0, 2e9}) {
    const double begin = -0.5 * length;
    const Keys<double> keys{{.time = begin, .value = 0.0, .out = limits::slope},
                            {.time = begin + length, .value = 1e20, .in = -limits::slope}};
    for (const double u : {0.0, 1e-9, 0.5, 0.999, 1.0}) {
      EXPECT_TRUE(std::isfinite(value_at(keys, begin + u * length)));
      const double kept = value_at(keys, begin + u * length, domain::intensity);
      EXPECT_GE(kept, 0.0);
      EXPECT_LE(kept, 1e20);
    }
    EXPECT_TRUE(std::isfinite(integral(keys, -2e9, 2e9)));
    EXPECT_TRUE(std::isfinite(integral_above(0.0, keys, -2e9, 2e9)));
  }
}

// Every value of a scene with keyframes at the ends of its domain and tangents that lead outside.
TEST(Tangents, NeverLeadOutOfADomain) {
  Scene scene;
  scene.lights.resize(3);
  scene.lights[1].kind = light::Spot();
  scene.lights[2].kind = light::Rectangle();
  scene.environment.emplace().sky.emplace();
  scene.emitters.resize(1);
  scene.groups.resize(1);
  scene.surfaces.resize(1);
  scene.surfaces[0].material.type = Material::Type::phong;
  const auto visit_all = [&scene](auto&& visit) {
    visit_keyed(scene.camera, scene.camera_keys, visit);
    visit_keyed(scene.optics, visit);
    for (auto& light : scene.lights) visit_keyed(light, visit);
    visit_keyed_environment(*scene.environment, visit);
    visit_keyed(scene.groups[0], visit);
    visit_keyed(scene.emitters[0], visit);
    visit_keyed_surface(scene.surfaces[0], visit);
  };
  visit_all([]<class T>(const char*, T&, Keys<T>& keys, const NumberDomain& domain) {
    if constexpr (!std::is_same_v<T, glm::dquat>) {
      for (const double end : {domain.min_value, domain.max_value}) {
        const T value(domain.nearest(end));
        keys.push_back({.time = static_cast<double>(keys.size()),
                        .value = value,
                        .in = T(9.0),
                        .out = T(-9.0)});
      }
      keys.push_back({.time = 2.0, .value = T(domain.nearest(0.0)), .in = T(1e30)});
    }
  });
  int visited = 0;
  for (double time = 0.0; time <= 2.0; time += 0.125) {
    apply_keys(scene, time);
    visit_all(
        [&]<class T>(const char* name, const T& value, const Keys<T>&, const NumberDomain& domain) {
          if constexpr (std::is_same_v<T, double>) {
            ASSERT_TRUE(domain.contains(value)) << name;
          } else if constexpr (!std::is_same_v<T, glm::dquat>) {
            if (std::string_view(name) == "target") return;  // kept apart from the eye
            for (int k = 0; k < value.length(); ++k) ASSERT_TRUE(domain.contains(value[k])) << name;
          }
          ++visited;
        });
  }
  EXPECT_GT(visited, 17 * 30);
}

// A rate that would be negative is none: particles are never born again, nor more than bounded.
TEST(Tangents, OfARateBearParticlesOnlyWhereItIsPositive) {
  Emitter emitter{.lifetime = 1.0, .spread = 0.0};
  emitter.keys.rate = {{.time = 0.0, .value = 10.0, .out = -80.0},
                       {.time = 2.0, .value = 10.0, .in = 80.0}};
  std::size_t before = 0;
  for (double time = 0.0; time < 4.0; time += 0.05) {
    const std::size_t count = particles_at(emitter, time).size();
    EXPECT_LE(count, max_particles(emitter));
    if (time > 0.6 && time < 1.3) {
      EXPECT_LE(count, before + 1) << time;  // dying out
    }
    before = count;
  }
  EXPECT_TRUE(particles_at(emitter, 1.5).size() < 4);
  emitter.keys.rate = {{.time = 0.0, .value = 0.0, .out = 80.0},
                       {.time = 2.0, .value = 0.0, .in = -80.0}};
  EXPECT_GE(max_particles(emitter), particles_at(emitter, 1.5).size());
  EXPECT_GT(particles_at(emitter, 1.5).size(), 30u);
}

}  // namespace
}  // namespace brume
