#include "core/scene/materials/brdf.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <numbers>

#include "core/math/sphere_rule.h"
#include "core/scene/materials/ggx.h"
#include "core/scene/materials/ggx_sh.h"
#include "core/scene/materials/measured_brdf.h"

namespace brume {
namespace {

using std::numbers::pi;

glm::dvec3 phong_highlight(const Material& material, const glm::dvec3& wi, const glm::dvec3& wo,
                           const glm::dvec3& n) {
  const double r = glm::dot(2.0 * glm::dot(wi, n) * n - wi, wo);
  if (!(r > 0.0)) return glm::dvec3(0.0);
  const double e = material.exponent;
  return material.specular * ((e + 2.0) / (2.0 * pi) * std::pow(std::min(r, 1.0), e));
}

}  // namespace

glm::dvec3 brdf(const Material& material, const glm::dvec3& wi, const glm::dvec3& wo,
                const glm::dvec3& n) {
  if (!(glm::dot(wi, n) > 0.0)) return glm::dvec3(0.0);
  switch (material.type) {
    case Material::Type::diffuse:
      return material.reflectance * std::numbers::inv_pi;
    case Material::Type::phong:
      return material.reflectance * std::numbers::inv_pi + phong_highlight(material, wi, wo, n);
    case Material::Type::measured:
      assert(material.measured);
      return (*material.measured)(wi, wo, n);
    case Material::Type::metallic_roughness:
      return ggx_brdf(average_material(material.metallic_roughness).reflection, wi, wo, n);
  }
  return glm::dvec3(0.0);
}

glm::dquat surface_frame(const glm::dvec3& n, const glm::dvec3& wo) {
  glm::dvec3 y = glm::cross(n, wo);
  if (!(glm::length(y) > 1e-9)) {
    // At normal incidence, any tangent will do.
    y = glm::cross(n, std::abs(n.x) < 0.5 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0));
  }
  y = glm::normalize(y);
  return glm::quat_cast(glm::dmat3(glm::cross(y, n), y, n));
}

ZonalSh<double> clamped_cosine_sh() {
  // sqrt((2 l + 1) / (4 pi)) A_l with A = pi, 2 pi / 3, pi / 4, 0, -pi / 24, 0 (Ramamoorthi and
  // Hanrahan 2001).
  ZonalSh<double> result = {pi, 2.0 * pi / 3.0, 0.25 * pi, 0.0, -pi / 24.0, 0.0};
  for (std::size_t l = 0; l < result.size(); ++l) {
    result[l] *= std::sqrt((2.0 * static_cast<double>(l) + 1.0) / (4.0 * pi));
  }
  return result;
}

const ZonalSh<float>& clamped_cosine_factors() {
  static const ZonalSh<float> factors = [] {
    const ZonalSh<double> cosine = clamped_cosine_sh();
    ZonalSh<float> f;
    for (std::size_t l = 0; l < f.size(); ++l) {
      f[l] = static_cast<float>(
          std::sqrt(4.0 * std::numbers::pi / (2.0 * static_cast<double>(l) + 1.0)) * cosine[l] *
          std::numbers::inv_pi);
    }
    return f;
  }();
  return factors;
}

namespace {

constexpr int intervals = 64;

// Beyond this a highlight is a point to six bands, and finer than the quadrature below.
constexpr double sharpest = 1e5;

// Half vectors around n = +z with their solid angles [sr], dense where highlights are.
std::vector<SphereNode> half_vectors() {
  const QuadratureRule rule = gauss_legendre(64);
  constexpr int azimuths = 64;
  std::vector<SphereNode> nodes;
  for (std::size_t i = 0; i < rule.nodes.size(); ++i) {
    const double x = 0.5 * (1.0 + rule.nodes[i]);
    const double theta = 0.5 * pi * x * x;
    const double weight = 0.5 * rule.weights[i] * pi * x * std::sin(theta) * (2.0 * pi / azimuths);
    for (int k = 0; k < azimuths; ++k) {
      const double phi = (k + 0.5) * 2.0 * pi / azimuths;
      nodes.push_back(
          {{std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta)},
           weight});
    }
  }
  return nodes;
}

// All that is not diffuse, by quadrature over the half vectors.
ShVector<glm::dvec3> project(const Material& material, int order, double theta_o) {
  static const std::vector<SphereNode> rule = half_vectors();
  const glm::dvec3 n(0.0, 0.0, 1.0);
  const glm::dvec3 wo(std::sin(theta_o), 0.0, std::cos(theta_o));
  ShVector<glm::dvec3> sum(order);
  for (const SphereNode& node : rule) {
    const double cosine = glm::dot(wo, node.direction);
    const glm::dvec3 wi = 2.0 * cosine * node.direction - wo;
    if (!(cosine > 0.0) || !(wi.z > 0.0)) continue;
    // Light moves four times as far as the half vector does.
    const glm::dvec3 value = 4.0 * cosine * node.weight * wi.z * brdf(material, wi, wo, n);
    const ShVector<double> y = sh_basis(order, wi);
    for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += y[i] * value;
  }
  return sum;
}

}  // namespace

BrdfSh::BrdfSh(const Material& material, int order) {
  const bool is_measured = material.type == Material::Type::measured;
  ShVector<glm::dvec3> diffuse(order);
  if (!is_measured) {
    const ZonalSh<double> cosine = clamped_cosine_sh();
    for (int l = 0; l < order; ++l) {
      diffuse[sh_index(l, 0)] = cosine[static_cast<std::size_t>(l)] / pi * material.reflectance;
    }
  }
  if (material.type == Material::Type::diffuse) {
    rows_.push_back(diffuse);
    return;
  }
  Material highlight = material;
  if (!is_measured) {
    highlight.reflectance = glm::dvec3(0.0);
    highlight.exponent = std::min(material.exponent, sharpest);
  }
  for (int i = 0; i <= intervals; ++i) {
    ShVector<glm::dvec3> row = project(highlight, order, 0.5 * pi * i / intervals);
    for (std::size_t k = 0; k < row.size(); ++k) row[k] += diffuse[k];
    rows_.push_back(row);
  }
}

ShVector<glm::dvec3> BrdfSh::operator()(double cos_theta_o) const {
  if (rows_.size() == 1) return rows_[0];
  const double place = std::acos(std::clamp(cos_theta_o, 0.0, 1.0)) / (0.5 * pi) * intervals;
  const double below = std::min(std::floor(place), intervals - 1.0);
  const double t = place - below;
  const ShVector<glm::dvec3>& a = rows_[static_cast<std::size_t>(below)];
  const ShVector<glm::dvec3>& b = rows_[static_cast<std::size_t>(below) + 1];
  ShVector<glm::dvec3> result(a.order());
  for (std::size_t i = 0; i < a.size(); ++i) result[i] = (1.0 - t) * a[i] + t * b[i];
  return result;
}

glm::dvec3 mean_reflectance(const Material& material, const glm::dvec4& color) {
  if (material.type == Material::Type::diffuse) return material.reflectance;
  static const QuadratureRule rule = gauss_legendre(32);
  // `lobe`: the reflected light by the cosine of the eye, whose first harmonic is its integral.
  const auto mean = [&](auto&& lobe) {
    glm::dvec3 sum(0.0);
    for (std::size_t i = 0; i < rule.nodes.size(); ++i) {
      const double cosine = 0.5 * (1.0 + rule.nodes[i]);
      sum += rule.weights[i] * cosine * lobe(cosine)[0];
    }
    return glm::clamp(std::sqrt(4.0 * std::numbers::pi) * sum, 0.0, 1.0);
  };
  if (material.type == Material::Type::metallic_roughness) {
    const GgxReflection reflection =
        average_material(material.metallic_roughness, color).reflection;
    return mean([&](double cosine) { return GgxSh::table()(reflection, cosine); });
  }
  return mean(BrdfSh(material, 1));
}

}  // namespace brume
