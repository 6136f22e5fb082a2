#include "render/paths/material_sampler.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "core/math/max_component.h"
#include "core/scene/materials/measured_brdf.h"
#include "render/paths/direction_sampling.h"

namespace brume {
namespace {

using std::numbers::pi;

// The exponent whose (n.h)^e falls to half where the highlight at normal incidence does.
double half_vector_exponent(const MeasuredBrdf& measured) {
  const glm::dvec3 n(0.0, 0.0, 1.0);
  const auto value_at = [&](double theta_h) {
    // Both directions on the half vector: theta_d is 0.
    const glm::dvec3 h(std::sin(theta_h), 0.0, std::cos(theta_h));
    const glm::dvec3 value = measured(h, h, n);
    return value.x + value.y + value.z;
  };
  const double peak = value_at(0.0);
  double theta = 0.005;
  while (theta < 1.2 && value_at(theta) > 0.5 * peak) theta *= 1.2;
  return std::clamp(std::log(0.5) / std::log(std::cos(theta)), 1.0, 1e5);
}

}  // namespace

MaterialSampler::MaterialSampler(const Material& material) {
  if (material.type == Material::Type::phong) {
    const double diffuse = max_component(material.reflectance);
    const double specular = max_component(material.specular);
    if (!(specular > 0.0)) return;
    lobe_ = Lobe::mirrored;
    exponent_ = material.exponent;
    lobe_share_ = specular / (diffuse + specular);
  } else if (material.type == Material::Type::measured) {
    lobe_ = Lobe::half_vector;
    exponent_ = half_vector_exponent(*material.measured);
    lobe_share_ = 0.5;
  }
}

glm::dvec3 MaterialSampler::sample(const glm::dvec3& n, const glm::dvec3& wo,
                                   PathRandom& random) const {
  if (lobe_share_ > 0.0 && random.uniform() < lobe_share_) {
    const double cosine = std::pow(random.uniform(), 1.0 / (exponent_ + 1.0));
    if (lobe_ == Lobe::mirrored) {
      return direction_around(2.0 * glm::dot(n, wo) * n - wo, cosine, random);
    }
    const glm::dvec3 h = direction_around(n, cosine, random);
    return 2.0 * glm::dot(h, wo) * h - wo;
  }
  return direction_around(n, std::sqrt(random.uniform()), random);
}

double MaterialSampler::pdf(const glm::dvec3& wi, const glm::dvec3& n, const glm::dvec3& wo) const {
  double sum = (1.0 - lobe_share_) * std::max(0.0, glm::dot(wi, n)) / pi;
  if (lobe_ == Lobe::none) return sum;
  const double scale = lobe_share_ * (exponent_ + 1.0) / (2.0 * pi);
  if (lobe_ == Lobe::mirrored) {
    const double cosine = glm::dot(wi, 2.0 * glm::dot(n, wo) * n - wo);
    if (cosine > 0.0) sum += scale * std::pow(std::min(cosine, 1.0), exponent_);
    return sum;
  }
  const glm::dvec3 h = wi + wo;
  const double length = glm::length(h);
  if (!(length > 0.0)) return sum;
  // The half vector that was drawn is the one before the surface. A direction moves twice as far.
  const double cosine = std::abs(glm::dot(h, n)) / length;
  const double along = std::abs(glm::dot(h, wo)) / length;
  if (along > 0.0) sum += scale * std::pow(std::min(cosine, 1.0), exponent_) / (4.0 * along);
  return sum;
}

GgxSampler::GgxSampler(const GgxReflection& reflection, const glm::dvec3& n, const glm::dvec3& wo)
    : reflection_(reflection), n_(n), wo_(wo) {
  const double cosine = std::clamp(glm::dot(n, wo), 0.0, 1.0);
  const double s = std::pow(1.0 - cosine, 5.0);
  const double specular = max_component(reflection.f0) * (1.0 - s) + s;
  const double diffuse = max_component(reflection.diffuse) * (1.0 - s);
  // Neither goes without samples: both are estimates.
  specular_share_ = diffuse > 0.0 ? std::clamp(specular / (specular + diffuse), 0.1, 0.9) : 1.0;
}

glm::dvec3 GgxSampler::sample(PathRandom& random) const {
  if (random.uniform() < specular_share_) {
    const double u = random.uniform();
    return sample_ggx(reflection_.alpha, wo_, n_, {u, random.uniform()});
  }
  return direction_around(n_, std::sqrt(random.uniform()), random);
}

double GgxSampler::pdf(const glm::dvec3& wi) const {
  return (1.0 - specular_share_) * std::max(0.0, glm::dot(wi, n_)) / pi +
         specular_share_ * ggx_pdf(reflection_.alpha, wi, wo_, n_);
}

}  // namespace brume
