#include "core/scene/materials/ggx.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "core/math/quadrature.h"
#include "core/scene/materials/ggx_sh.h"
#include "core/scene/materials/texture.h"
#include "tests/core/scene/from_angles.h"
#include "tests/random.h"

namespace brume {
namespace {

using std::numbers::pi;

const glm::dvec3 z_axis(0.0, 0.0, 1.0);

// Reflects all of what its microfacets meet.
GgxReflection white_metal(double roughness) {
  return {glm::dvec3(1.0), 1.0, roughness};
}

// The integral of f(wi) times its solid angle by a midpoint rule over half vectors in proportion to
// D: for what is specular.
template <class Value>
Value over_highlight(double alpha, const glm::dvec3& wo, Value sum, const auto& f) {
  constexpr int steps = 160;
  for (int i = 0; i < steps; ++i) {
    const double u = (i + 0.5) / steps;
    const double cos_h = std::sqrt((1.0 - u) / (1.0 + (alpha * alpha - 1.0) * u));
    for (int k = 0; k < steps; ++k) {
      const glm::dvec3 h = from_angles(std::acos(cos_h), 2.0 * pi * (k + 0.5) / steps);
      const double v_dot_h = glm::dot(wo, h);
      const glm::dvec3 wi = 2.0 * v_dot_h * h - wo;
      if (!(v_dot_h > 0.0) || !(wi.z > 0.0)) continue;
      const double density = ggx_distribution(alpha, cos_h) * cos_h / (4.0 * v_dot_h);
      sum = sum + f(wi) * (1.0 / (density * steps * steps));
    }
  }
  return sum;
}

// The same over directions in proportion to the cosine: for what is diffuse.
template <class Value>
Value over_hemisphere(Value sum, const auto& f) {
  constexpr int steps = 100;
  for (int i = 0; i < steps; ++i) {
    const double cosine = std::sqrt((i + 0.5) / steps);
    for (int k = 0; k < steps; ++k) {
      const glm::dvec3 wi = from_angles(std::acos(cosine), 2.0 * pi * (k + 0.5) / steps);
      sum = sum + f(wi) * (pi / (cosine * steps * steps));
    }
  }
  return sum;
}

GgxReflection specular_part(GgxReflection reflection) {
  reflection.diffuse = glm::dvec3(0.0);
  return reflection;
}

// The integrals of both parts, in red, of weigh(f cos(theta_i), wi).
template <class Value>
Value integral(const GgxReflection& reflection, const glm::dvec3& wo, const Value& zero,
               const auto& weigh) {
  const GgxReflection specular = specular_part(reflection);
  const auto specular_at = [&](const glm::dvec3& wi) {
    return ggx_brdf(specular, wi, wo, z_axis).x * wi.z;
  };
  const Value highlight = over_highlight(
      reflection.alpha, wo, zero, [&](const glm::dvec3& wi) { return weigh(specular_at(wi), wi); });
  return over_hemisphere(highlight, [&](const glm::dvec3& wi) {
    return weigh(ggx_brdf(reflection, wi, wo, z_axis).x * wi.z - specular_at(wi), wi);
  });
}

double albedo(const GgxReflection& reflection, const glm::dvec3& wo) {
  return integral(reflection, wo, 0.0, [](double f, const glm::dvec3&) { return f; });
}

TEST(Ggx, IsReciprocal) {
  Random random(5);
  for (int i = 0; i < 300; ++i) {
    const glm::dvec3 wi = from_angles(random.uniform(0, 1.5), random.uniform(0, 6));
    const glm::dvec3 wo = from_angles(random.uniform(0, 1.5), random.uniform(0, 6));
    const GgxReflection reflection({0.9, 0.5, 0.1}, random.uniform(0, 1), random.uniform(0, 1));
    const glm::dvec3 there = ggx_brdf(reflection, wi, wo, z_axis);
    EXPECT_NEAR(glm::length(there - ggx_brdf(reflection, wo, wi, z_axis)), 0.0,
                1e-12 * glm::length(there));
    EXPECT_GT(there.x, 0.0);
  }
  EXPECT_EQ(ggx_brdf(white_metal(0.5), {0, 0, -1}, z_axis, z_axis), glm::dvec3(0.0))
      << "from behind";
}

TEST(Ggx, MicrofacetsFillTheSurface) {
  // D projected on the surface is the surface.
  for (const double alpha : {1e-3, 0.1, 0.5, 1.0}) {
    const auto projected = [&](double theta) {
      return 2.0 * pi * std::sin(theta) * std::cos(theta) *
             ggx_distribution(alpha, std::cos(theta));
    };
    const std::array<double, 5> breakpoints{0.0, 2.0 * alpha / 10.0, alpha / 2.0,
                                            std::min(1.5, 3.0 * alpha), 0.5 * pi};
    EXPECT_NEAR(integrate<double>(projected, breakpoints, 1e-10).value, 1.0, 1e-6) << alpha;
  }
}

// The manual has these figures.
TEST(Ggx, WhiteFurnaceLosesWhatIsScatteredTwice) {
  std::array<double, 11> straight_on{};
  for (int i = 0; i <= 10; ++i) {
    const double roughness = 0.1 * i;
    for (const double theta : {0.0, 1.0, 1.4}) {
      const double reflected = albedo(white_metal(roughness), from_angles(theta, 0.3));
      EXPECT_LE(reflected, 1.0 + 2e-3) << roughness << ' ' << theta;
      if (theta == 0.0) straight_on[static_cast<std::size_t>(i)] = reflected;
    }
  }
  EXPECT_NEAR(straight_on[0], 1.0, 1e-3);
  // D is 1 / pi and V 1 / (2 (1 + N.L)): the integral of c / (1 + c).
  EXPECT_NEAR(straight_on[10], 1.0 - std::log(2.0), 1e-3);
  for (std::size_t i = 1; i <= 10; ++i) EXPECT_LE(straight_on[i], straight_on[i - 1] + 1e-4);
}

// glTF's diffuse part loses what one direction's Fresnel term reflects, not what all do: a white
// dielectric gains energy at grazing angles. The manual has these figures.
TEST(Ggx, WhiteDielectricsGainEnergyAtGrazingAngles) {
  for (const double roughness : {0.1, 0.3, 0.6, 1.0}) {
    const GgxReflection dielectric(glm::dvec3(1.0), 0.0, roughness);
    double mean = 0.0;
    constexpr int steps = 8;
    for (int i = 0; i < steps; ++i) {
      const double cosine = std::sqrt((i + 0.5) / steps);
      mean += albedo(dielectric, from_angles(std::acos(cosine), 0.3)) / steps;
    }
    EXPECT_LE(albedo(dielectric, z_axis), 1.0 + 1e-3) << roughness;
    EXPECT_GE(albedo(dielectric, z_axis), 0.97) << roughness;
    EXPECT_LE(albedo(dielectric, from_angles(1.4, 0.0)), 1.4) << roughness;
    EXPECT_NEAR(mean, 1.0, 0.04) << roughness;
  }
}

TEST(Ggx, SamplesAreUnbiased) {
  Random random(9);
  for (const double roughness : {0.15, 0.4, 1.0}) {
    for (const double theta : {0.0, 0.8, 1.45}) {
      const GgxReflection reflection({0.9, 0.5, 0.1}, 1.0, roughness);
      const glm::dvec3 wo = from_angles(theta, 1.0);
      double sum = 0.0;
      double squares = 0.0;
      constexpr int count = 4000;
      for (int i = 0; i < count; ++i) {
        const glm::dvec3 wi =
            sample_ggx(reflection.alpha, wo, z_axis, {random.uniform(0, 1), random.uniform(0, 1)});
        const double pdf = ggx_pdf(reflection.alpha, wi, wo, z_axis);
        ASSERT_GT(pdf, 0.0);
        const double value = ggx_brdf(reflection, wi, wo, z_axis).x * std::max(0.0, wi.z) / pdf;
        sum += value;
        squares += value * value;
      }
      const double mean = sum / count;
      const double error = std::sqrt((squares / count - mean * mean) / count);
      EXPECT_NEAR(mean, albedo(reflection, wo), 4.0 * error + 1e-4) << roughness << ' ' << theta;
      EXPECT_LT(squares / count, 1.01) << "no sample is worth more than the light it reflects";
    }
  }
}

// Pearson's test: as many samples fall into each bin of the sphere as the density says.
TEST(Ggx, SamplesFollowTheirDensity) {
  constexpr int rings = 8;
  constexpr int sectors = 8;
  constexpr int count = 20000;
  Random random(2);
  for (const double alpha : {0.2, 0.7}) {
    const glm::dvec3 wo = from_angles(0.9, 0.4);
    std::array<std::array<double, sectors>, rings> found{};
    for (int i = 0; i < count; ++i) {
      const glm::dvec3 wi =
          sample_ggx(alpha, wo, z_axis, {random.uniform(0, 1), random.uniform(0, 1)});
      EXPECT_NEAR(glm::length(wi), 1.0, 1e-12);
      const int ring = std::min(rings - 1, static_cast<int>(0.5 * (1.0 - wi.z) * rings));
      const double turn = std::atan2(wi.y, wi.x) / (2.0 * pi);
      const int sector =
          std::min(sectors - 1, static_cast<int>((turn - std::floor(turn)) * sectors));
      found[static_cast<std::size_t>(ring)][static_cast<std::size_t>(sector)] += 1.0;
    }
    double chi2 = 0.0;
    int bins = 0;
    for (int ring = 0; ring < rings; ++ring) {
      for (int sector = 0; sector < sectors; ++sector) {
        constexpr int steps = 48;
        double expected = 0.0;
        for (int i = 0; i < steps; ++i) {
          const double z = 1.0 - 2.0 * (ring + (i + 0.5) / steps) / rings;
          for (int k = 0; k < steps; ++k) {
            const double phi = 2.0 * pi * (sector + (k + 0.5) / steps) / sectors;
            expected += ggx_pdf(alpha, from_angles(std::acos(z), phi), wo, z_axis);
          }
        }
        expected *= count * 4.0 * pi / (rings * sectors * steps * steps);
        if (expected < 8.0) continue;
        const double got = found[static_cast<std::size_t>(ring)][static_cast<std::size_t>(sector)];
        chi2 += (got - expected) * (got - expected) / expected;
        ++bins;
      }
    }
    // Mean `bins`, variance 2 bins: five standard deviations.
    EXPECT_LT(chi2, bins + 5.0 * std::sqrt(2.0 * bins)) << alpha;
    EXPECT_GT(bins, 20);
  }
}

struct Harmonics {
  ShVector<double> values{sh_max_bands};

  Harmonics operator*(double factor) const {
    Harmonics result = *this;
    for (std::size_t i = 0; i < values.size(); ++i) result.values[i] *= factor;
    return result;
  }
  Harmonics operator+(const Harmonics& other) const {
    Harmonics result = *this;
    for (std::size_t i = 0; i < values.size(); ++i) result.values[i] += other.values[i];
    return result;
  }
};

TEST(GgxSh, MatchesTheIntegral) {
  Random random(4);
  for (int i = 0; i < 12; ++i) {
    const double roughness = i < 2 ? 0.0 : random.uniform(0.0, 1.0);
    const GgxReflection reflection({0.8, 0.5, 0.2}, i % 2, roughness);
    const double theta = random.uniform(0.0, 1.4);
    const Harmonics expected = integral(
        reflection, from_angles(theta, 0.0), Harmonics{},
        [](double f, const glm::dvec3& wi) { return Harmonics{sh_basis(sh_max_bands, wi)} * f; });
    const ShVector<glm::dvec3> found = GgxSh::table()(reflection, std::cos(theta));
    for (std::size_t k = 0; k < found.size(); ++k) {
      // Coefficients are up to about 1, and linear between rows of the table.
      EXPECT_NEAR(found[k].x, expected.values[k], 5e-3)
          << i << ' ' << k << ' ' << roughness << ' ' << theta;
    }
  }
}

TEST(MaterialAt, MultipliesTexturesAndTurnsNormals) {
  const auto texel = [](std::array<std::uint8_t, 4> rgba, Texture::Encoding encoding) {
    return TextureReference{"a.png", std::make_shared<const Texture>(1, 1, rgba, encoding)};
  };
  MetallicRoughness material;
  material.base_color = {1.0, 0.5, 0.25};
  material.metallic = 0.5;
  material.emissive = {2.0, 2.0, 2.0};
  material.base_color_texture = texel({255, 188, 0, 255}, Texture::Encoding::srgb);
  material.metallic_roughness_texture = texel({9, 51, 102, 255}, Texture::Encoding::linear);
  material.normal_texture = texel({255, 128, 255, 255}, Texture::Encoding::linear);
  material.emissive_texture = texel({0, 255, 0, 255}, Texture::Encoding::srgb);
  const MaterialPoint point = material_at(material, {});
  EXPECT_NEAR(point.reflection.alpha, 0.04, 1e-6);  // (51 / 255)^2
  const double metallic = 0.5 * 0.4;                // 102 / 255
  EXPECT_NEAR(point.reflection.f0.x, 0.04 * (1.0 - metallic) + metallic, 1e-6);
  EXPECT_NEAR(point.reflection.diffuse.y, (1.0 - metallic) * 0.25 * (1.0 - point.reflection.f0.y),
              2e-3);  // sRGB 188 is half
  EXPECT_EQ(point.emitted, glm::dvec3(0.0, 2.0, 0.0));
  EXPECT_NEAR(point.normal.x, std::sqrt(0.5), 1e-5);  // 128 is not quite 0
  material.normal_scale = 0.0;
  EXPECT_EQ(material_at(material, {}).normal, z_axis);
  EXPECT_EQ(average_material(material).emitted, point.emitted);
}

}  // namespace
}  // namespace brume
