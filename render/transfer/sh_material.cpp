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
  if (!diffuse_) table_.emplace(brdf_);
}

glm::dvec3 ShMaterial::unshadowed(const ShVector<glm::dvec3>& light, const glm::dvec3& n,
                                  const glm::dvec3& wo) const {
  return sh_dot(light, sh_rotate(brdf_(glm::dot(n, wo)), surface_frame(n, wo)));
}

ReceivedLight ShMaterial::received(const ShVector<glm::dvec3>& light,
                                   const ShVector<glm::dvec3>& traced,
                                   const RadianceTransfer& transfer, MeshSide side,
                                   const MeshPoint& point) const {
  ReceivedLight result;
  // Horner's scheme in the albedo.
  for (int bounce = transfer.settings.bounces; bounce >= (diffuse_ ? 0 : 1); --bounce) {
    const ShVector<double> transferred = transfer.reflected(side, bounce, point);
    glm::dvec3 sum = sh_dot(light, transferred);
    if (bounce > 0) sum += sh_dot(traced, transferred);
    result.radiance = albedo_ * (result.radiance + sum);
  }
  if (diffuse_) return result;
  result.radiance *= albedo_;
  result.incident = sh_product(light, transfer.visibility(side, point));
  return result;
}

glm::dvec3 ShMaterial::reflected(const ReceivedLight& light, const glm::dvec3& n,
                                 const glm::dvec3& wo) const {
  const bool is_sent = light.incident.order() == 0;
  return glm::max(light.radiance + (is_sent ? glm::dvec3(0.0) : unshadowed(light.incident, n, wo)),
                  0.0);
}

}  // namespace brume
