// The SIMD kernels against the plain double formulas, for every instruction set of this machine.

#include "render/simd/gaussian_kernels.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "brume/scene.h"
#include "core/transport/closed_form_airlight.h"
#include "core/transport/phase_function.h"
#include "render/cpu/paper_airlight.h"
#include "render/optical_depth/path_depths.h"
#include "render/simd/phase_kernels.h"
#include "tests/random.h"
#include "tests/render/for_each_target.h"

namespace brume {
namespace {

constexpr double half_sqrt_pi = 0.886226925452758;

Medium random_medium(Random& random, int count, double radius_low, double radius_high,
                     double density_low, double density_high) {
  Medium medium;
  for (int i = 0; i < count; ++i) {
    medium.append({random.point(2.0), random.power(radius_low, radius_high),
                   random.power(density_low, density_high)});
  }
  return medium;
}

struct Ranges {
  const char* name;
  double radius_low, radius_high, density_low, density_high;  // powers of ten
  double tolerance;                                           // relative, of each result
};

// Errors of a sum of positive terms, relative. Float inputs condition a depth at the rim of a
// Gaussian by 2 a^2 h |q| eps (math, section 1): with |q| up to 6 and the kernels' cutoff at 4 to 8
// radii that is 1e-5 for radii near 1 and 1e-2 for radii of 0.003.
const Ranges ranges[] = {
    {"ordinary", -0.7, 0.3, -1, 1, 1e-4},
    {"small", -2.5, -1, -1, 2, 1e-2},
    {"large", 1, 4, -3, 0, 1e-5},
    {"dense", -1, 0, 2, 6, 1e-3},
};

TEST(Kernels, PathDepthsAgreeWithDouble) {
  for_each_target([] {
    for (const Ranges& r : ranges) {
      SCOPED_TRACE(r.name);
      Random random(11);
      for (int round = 0; round < 20; ++round) {
        const Medium medium =
            random_medium(random, 40, r.radius_low, r.radius_high, r.density_low, r.density_high);
        const MediumIndex index(medium, 1e-12);
        const glm::dvec3 origin = random.point(3.0);
        std::vector<glm::dvec3> ends;
        std::vector<std::int32_t> self;
        for (int k = 0; k < 37; ++k) {
          ends.push_back(k % 4 == 0 ? medium.centers()[static_cast<std::size_t>(k)]
                                    : random.point(3.0));
          self.push_back(k % 4 == 0 ? k : -1);
        }
        std::vector<double> fast(ends.size());
        std::vector<double> plain(ends.size());
        bundle_depths(index, origin, ends, self, Settings::Precision::simd_float, fast);
        bundle_depths(index, origin, ends, self, Settings::Precision::plain_double, plain);
        for (std::size_t k = 0; k < ends.size(); ++k) {
          // Depths far below any tolerance of use are not compared.
          ASSERT_NEAR(fast[k], plain[k], r.tolerance * plain[k] + 1e-7) << "path " << k;
        }
      }
    }
  });
}

// One Gaussian and one path where float is hardest pressed: math, section 1. Both sides get the
// same rounded inputs. The bounds are the table's for float32, except in the tail pairs and for
// tiny a, where the kernel's erfc and exp, good to 3e-7, add to them.
struct HardSegments {
  const char* name;
  double radius;    // [u]
  double distance;  // of the centre along the path, in radii, up to 10% more or less
  double across;    // at most, in radii
  double length;    // in radii; 0: twice the distance
  double bound;     // relative
};
const HardSegments hard_segments[] = {
    {"far, |q| = 100, a = 10", 0.1, 1000.0, 2.0, 0.0, 3.8e-4},
    {"far, |q| = 1000, a = 50", 0.02, 50'000.0, 2.0, 0.0, 1.7e-2},
    {"huge a, |q| = 10", 1e-4, 1e5, 2.0, 0.0, 2.1e-2},
    {"behind, u from 3", 1.0, -3.0, 1.0, 10.0, 4.2e-6},
    {"tail pair, u near 2", 1.0, -2.25, 1.0, 0.5, 3e-6},
    {"tail pair, u near 4", 1.0, -4.25, 1.0, 0.5, 8e-6},
    {"deep tail, u from 6.5", 1.0, -6.5, 1.0, 10.0, 1.5e-5},
    {"short, a d = 1e-3", 1.0, 0.5, 1.0, 1e-3, 4.0e-7},
    {"short, a d = 1e-6", 1.0, 0.5, 1.0, 1e-6, 3.2e-7},
    {"tiny a", 1e4, 0.3, 1.0, 1e-3, 3e-7},
};

TEST(Kernels, PathDepthsHoldTheTablesBounds) {
  for_each_target([] {
    for (const HardSegments& row : hard_segments) {
      SCOPED_TRACE(row.name);
      Random random(15);
      double worst = 0.0;
      for (int i = 0; i < 2000; ++i) {
        const glm::dvec3 axis = glm::normalize(random.point(1.0));
        const glm::dvec3 side = glm::normalize(glm::cross(axis, random.point(1.0)));
        const double radius = row.radius;
        const double along = row.distance * (1.0 + 0.1 * random.uniform(-1.0, 1.0));
        // The kernel's input, which the double formula takes too.
        GaussianBatch batch;
        Medium medium;
        medium.append(
            {radius * (along * axis + random.uniform(0.0, row.across) * side), radius, 1.0});
        batch.assign(MediumIndex(medium, 1e-300), glm::dvec3(0.0), std::array{0u});
        PathBatch path;
        const double length = radius * (row.length > 0.0 ? row.length : 2.0 * along);
        path.assign(std::array{axis}, std::array{length});
        const GaussianTerm<double> g(
            static_cast<double>(batch.a[0]),
            static_cast<double>(batch.scale[0] * batch.a[0]) / half_sqrt_pi,
            {batch.x[0], batch.y[0], batch.z[0]});
        const glm::dvec3 w(path.x[0], path.y[0], path.z[0]);
        const double reference = optical_depth(g, line_profile(g, glm::dvec3(0.0), w),
                                               static_cast<double>(path.length[0]));
        if (reference < 1e-30) continue;
        std::vector<float> depths(path.padded_size(), 0.0f);
        accumulate_path_depths(batch, path, depths.data());
        worst = std::max(worst, std::abs(static_cast<double>(depths[0]) / reference - 1.0));
      }
      EXPECT_LT(worst, row.bound);
      EXPECT_GT(worst, 0.0);
    }
  });
}

TEST(Kernels, PaperAirlightAgreesWithDouble) {
  for_each_target([] {
    for (const Ranges& r : ranges) {
      SCOPED_TRACE(r.name);
      Random random(12);
      double error2 = 0.0;
      double sum2 = 0.0;
      for (int round = 0; round < 30; ++round) {
        const Medium medium =
            random_medium(random, 30, r.radius_low, r.radius_high, r.density_low, r.density_high);
        MediumIndex index(medium, 1e-9, 0.4 * (round % 3));
        if (round % 4 == 3) {
          Noise noise;
          noise.amplitude = 0.4;
          noise.frequency = 1.5;
          noise.seed = round;
          index.set_noise(RayNoise(noise, 0.0));
        }
        std::vector<std::uint32_t> all;
        for (std::uint32_t i = 0; i < medium.size(); ++i) all.push_back(i);
        const glm::dvec3 eye = round % 5 == 0 ? medium.centers()[0] : random.point(4.0);
        PaperLights paper;
        paper.at_mean = round % 2 == 1;
        paper.from_eye.resize(medium.size());
        for (double& f : paper.from_eye) f = random.uniform(0.0, 3.0);
        paper.lights.resize(static_cast<std::size_t>(1 + round % 6));
        for (PaperLight& light : paper.lights) {
          light.conserve_energy = round % 4 > 1 && &light != &paper.lights[0];
          light.position = random.point(4.0);
          light.intensity = glm::dvec3(1.0, 2.0, 0.5);
          light.h_min = 1e-3;
          light.frozen.resize(medium.size());
          for (double& f : light.frozen) f = random.uniform(0.0, 3.0);
        }
        std::vector<glm::dvec3> directions;
        std::vector<double> lengths;
        for (int k = 0; k < 50; ++k) {
          directions.push_back(glm::normalize(random.point(1.0) - 0.2 * eye));
          lengths.push_back(k % 3 == 0 ? INFINITY : random.power(-1, 1));
        }
        const TileRays rays{eye, directions, lengths, 0, {}};
        std::vector<glm::vec3> fast(50), plain(50);
        std::vector<double> fast_depth(50), plain_depth(50);
        paper_airlight(index, all, paper, rays, Settings::Precision::simd_float,
                       {fast, fast_depth});
        paper_airlight(index, all, paper, rays, Settings::Precision::plain_double,
                       {plain, plain_depth});
        for (std::size_t k = 0; k < 50; ++k) {
          ASSERT_NEAR(fast_depth[k], plain_depth[k], r.tolerance * plain_depth[k] + 1e-6);
          for (int channel = 0; channel < 3; ++channel) {
            const double a = fast[k][channel];
            const double b = plain[k][channel];
            ASSERT_TRUE(std::isfinite(a)) << a;
            error2 += (a - b) * (a - b);
            sum2 += b * b;
          }
        }
      }
      EXPECT_GT(sum2, 0.0);
      EXPECT_LT(std::sqrt(error2 / sum2), r.tolerance);
    }
  });
}

TEST(Kernels, HomogeneousAirlightAgreesWithDouble) {
  for_each_target([] {
    Random random(13);
    std::vector<double> errors;
    for (int round = 0; round < 400; ++round) {
      const double b0 = random.power(-4, 1);
      const glm::dvec3 light = random.point(5.0);
      const double h_min = 1e-4;
      std::vector<glm::dvec3> ends;
      for (int k = 0; k < 16; ++k) ends.push_back(random.point(5.0) * random.power(-1, 2));
      const std::vector<std::int32_t> self(16, -1);
      PathBatch rays;
      rays.assign(glm::dvec3(0.0), ends, self);
      if (round % 2 == 0) std::fill(rays.length.begin(), rays.length.end(), INFINITY);
      std::vector<float> fast(rays.padded_size(), 0.0f);
      accumulate_homogeneous_airlight(BatchFog(static_cast<float>(b0)), 1.0f, glm::vec3(light),
                                      static_cast<float>(h_min), 0.0f, rays, fast.data());
      for (std::size_t k = 0; k < ends.size(); ++k) {
        const glm::dvec3 w = glm::normalize(ends[k]);
        const PointLightRay<double> path(light, glm::dvec3(0.0), w, h_min);
        const double length = round % 2 == 0 ? INFINITY : glm::length(ends[k]);
        const double exact = homogeneous_airlight(b0, path, length);
        if (exact < 1e-20) continue;  // below what float holds after exp(-b0 distance)
        errors.push_back(std::abs(static_cast<double>(fast[k]) / exact - 1.0));
      }
    }
    std::sort(errors.begin(), errors.end());
    ASSERT_GT(errors.size(), 1000u);
    // The rule's own worst case is 3.2e-4 (math, section 2), the rest is float.
    EXPECT_LT(errors.back(), 1e-3);
    // Exponents up to 46 (light of exp(-46) still counts here) round to 3e-6 in float.
    EXPECT_LT(errors[errors.size() / 2], 1e-5);
  });
}

// A light straight ahead, where the detour of the light's path is a difference of two large
// numbers, in fog from thin to far denser than the light's distance.
// A light straight ahead or nearly so, and the airlight before it.
struct LightAhead {
  double distance, b0, off, length, exact;

  [[nodiscard]] glm::dvec3 light() const { return {off * distance, 0.0, distance}; }
  [[nodiscard]] double h_min() const { return 1e-4 * distance; }
};

constexpr glm::dvec3 ahead(0.0, 0.0, 1.0);

std::vector<LightAhead> lights_ahead() {
  std::vector<LightAhead> all;
  Random random(16);
  for (int i = 0; i < 500; ++i) {
    LightAhead one{};
    one.distance = random.power(0, 6);
    one.b0 = random.power(-2, 9) / one.distance;
    one.off = i % 3 == 0 ? 0.0 : random.power(-7, -1);
    for (const double length : {0.5 * one.distance, static_cast<double>(INFINITY)}) {
      const PointLightRay<double> path(one.light(), glm::dvec3(0.0), ahead, one.h_min());
      one.length = length;
      one.exact = homogeneous_airlight(one.b0, path, length);
      all.push_back(one);
    }
  }
  return all;
}

TEST(Kernels, HomogeneousAirlightOfALightStraightAhead) {
  const std::vector<LightAhead> all = lights_ahead();  // once for all targets: it takes long
  for_each_target([&] {
    for (const LightAhead& one : all) {
      PathBatch ray;
      ray.assign(std::array{ahead}, std::array{one.length});
      std::vector<float> radiance(ray.padded_size(), 0.0f);
      accumulate_homogeneous_airlight(BatchFog(static_cast<float>(one.b0)), 1.0f,
                                      glm::vec3(one.light()), static_cast<float>(one.h_min()), 0.0f,
                                      ray, radiance.data());
      // The rule's worst case, and float below exp(-b0 distance) = 1e-30.
      ASSERT_NEAR(radiance[0], one.exact, 1e-3 * one.exact + 1e-30)
          << "b0 " << one.b0 << " distance " << one.distance << " off " << one.off;
    }
  });
}

TEST(Kernels, PhasedLightIsThatOfThePhaseFunction) {
  Random random(17);
  std::vector<PhasedLight> lights;
  for (int i = 0; i < 30; ++i) {
    lights.push_back({glm::normalize(random.point(1.0)),
                      {random.power(-3, 3), random.uniform(0.0, 1.0), i == 7 ? 1.0 : 0.0}});
  }
  constexpr std::size_t count = 64;
  std::array<std::vector<float>, 3> w;
  for (std::size_t k = 0; k < count; ++k) {
    // In the peak of some, before and behind, and anywhere.
    const glm::vec3 d = k < 30   ? lights[k].direction
                        : k < 50 ? -lights[k - 30].direction
                                 : glm::vec3(glm::normalize(random.point(1.0)));
    for (int c = 0; c < 3; ++c) w[static_cast<std::size_t>(c)].push_back(d[c]);
  }
  for (const double g : {0.0, 0.6, 0.95, -0.95}) {
    for_each_target([&] {
      std::array<std::vector<float>, 3> sums;
      sums.fill(std::vector<float>(count, 0.5f));
      add_phased(lights, g, {w[0], w[1], w[2]}, {sums[0], sums[1], sums[2]});
      for (std::size_t k = 0; k < count; ++k) {
        glm::dvec3 exact(0.0);
        for (const PhasedLight& light : lights) {
          // Unit in double too: in the peak it matters.
          const double cosine = glm::dot(glm::normalize(glm::dvec3(light.direction)),
                                         glm::normalize(glm::dvec3(w[0][k], w[1][k], w[2][k])));
          exact += henyey_greenstein(cosine, g) / (4.0 * std::numbers::pi) *
                   glm::dvec3(light.irradiance);
        }
        for (int c = 0; c < 3; ++c) {
          const double got = sums[static_cast<std::size_t>(c)][k];
          ASSERT_NEAR(got, 0.5 + exact[c], 1e-5 * (0.5 + exact[c])) << g << ' ' << k << ' ' << c;
        }
      }
    });
  }
}

}  // namespace
}  // namespace brume
