#include "core/scene/materials/mean_reflectance.h"

#include <cmath>
#include <glm/common.hpp>
#include <numbers>

#include "core/math/sphere_rule.h"
#include "core/scene/materials/brdf.h"
#include "core/scene/materials/ggx_sh.h"

namespace brume {

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
