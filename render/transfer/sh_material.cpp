#include "render/transfer/sh_material.h"

#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <numbers>

namespace brume {

ShMaterial::ShMaterial(const Material& material, int order)
    : diffuse_(material.type == Material::Type::diffuse), brdf_(material, order) {
  // By reciprocity what leaves along the normal of light from everywhere.
  const double everywhere = std::sqrt(4.0 * std::numbers::pi);
  albedo_ = glm::clamp(everywhere * brdf_(1.0)[0], 0.0, 1.0);
}

glm::dvec3 ShMaterial::unshadowed(const ShVector<glm::dvec3>& light, const glm::dvec3& n,
                                  const glm::dvec3& wo) const {
  return sh_dot(light, sh_rotate(brdf_(glm::dot(n, wo)), surface_frame(n, wo)));
}

glm::dvec3 ShMaterial::shadowed(const ShVector<glm::dvec3>& light,
                                const ShVector<double>& visibility, const glm::dvec3& n,
                                const glm::dvec3& wo) const {
  return unshadowed(sh_product(light, visibility), n, wo);
}

glm::dvec3 ShMaterial::transferred(const ShVector<glm::dvec3>& light,
                                   const RadianceTransfer& transfer, MeshSide side,
                                   const MeshPoint& at, const glm::dvec3& n,
                                   const glm::dvec3& wo) const {
  // Horner's scheme in the albedo.
  glm::dvec3 reflected(0.0);
  for (int bounce = transfer.settings.bounces; bounce >= (diffuse_ ? 0 : 1); --bounce) {
    reflected = albedo_ * (reflected + sh_dot(light, transfer.reflected(side, bounce, at)));
  }
  if (!diffuse_) {
    reflected = albedo_ * reflected + shadowed(light, transfer.visibility(side, at), n, wo);
  }
  return glm::max(reflected, 0.0);
}

}  // namespace brume
