#include "core/scene/materials/ggx.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <numbers>

#include "brume/mesh_arrays.h"
#include "core/scene/materials/brdf.h"
#include "core/scene/materials/texture.h"

namespace brume {
namespace {

using std::numbers::pi;

double square(double x) {
  return x * x;
}

// 1 / cosine times the slope that Smith's masking takes from an angle.
double smith_root(double alpha2, double cosine) {
  return std::sqrt(alpha2 + (1.0 - alpha2) * square(cosine));
}

// A direction in the frame of n, on its side.
glm::dvec3 to_local(const glm::dquat& frame, const glm::dvec3& w) {
  glm::dvec3 local = glm::conjugate(frame) * w;
  local.z = std::max(local.z, min_ggx_cosine);
  return glm::normalize(local);
}

// The material by what its textures hold, and the color of vertices.
MaterialPoint combined(const MetallicRoughness& material, const glm::vec4& base_color,
                       const glm::vec4& metallic_roughness, const glm::vec4& emissive,
                       const glm::vec4& transmission, const glm::dvec3& color) {
  MaterialPoint point;
  point.reflection =
      GgxReflection(color * material.base_color * glm::dvec3(base_color),
                    std::clamp(material.metallic * double{metallic_roughness.b}, 0.0, 1.0),
                    std::clamp(material.roughness * double{metallic_roughness.g}, 0.0, 1.0));
  point.reflection.diffuse *= 1.0 - color * material.transmission * glm::dvec3(transmission);
  point.emitted = material.emissive * glm::dvec3(emissive);
  return point;
}

}  // namespace

GgxReflection::GgxReflection(const glm::dvec3& base_color, double metallic, double roughness)
    : f0(glm::mix(glm::dvec3(dielectric_f0), base_color, metallic)),
      alpha(std::max(roughness * roughness, min_alpha)) {
  diffuse = (1.0 - metallic) * base_color * (1.0 - f0);
}

double ggx_distribution(double alpha, double cos_h) {
  // 1 - cos^2 of angles near 0 has no digits, but alpha^2 is above them.
  const double alpha2 = alpha * alpha;
  const double c2 = std::min(square(cos_h), 1.0);
  return alpha2 / (pi * square(alpha2 * c2 + (1.0 - c2)));
}

double ggx_visibility(double alpha, double cos_light, double cos_eye) {
  const double alpha2 = alpha * alpha;
  return 0.5 / (cos_light * smith_root(alpha2, cos_eye) + cos_eye * smith_root(alpha2, cos_light));
}

glm::dvec3 ggx_brdf(const GgxReflection& reflection, const glm::dvec3& wi, const glm::dvec3& wo,
                    const glm::dvec3& n) {
  const double cos_light = glm::dot(wi, n);
  if (!(cos_light > 0.0)) return glm::dvec3(0.0);
  const double cos_eye = std::max(glm::dot(wo, n), min_ggx_cosine);
  const glm::dvec3 sum = wi + wo;
  const double length = glm::length(sum);
  if (!(length > 0.0)) return reflection.diffuse / pi;
  const double s = std::pow(1.0 - std::clamp(0.5 * length, 0.0, 1.0), 5.0);  // V.H = |L + V| / 2
  const double specular = ggx_distribution(reflection.alpha, glm::dot(sum, n) / length) *
                          ggx_visibility(reflection.alpha, cos_light, cos_eye);
  return (1.0 - s) / pi * reflection.diffuse +
         specular * (reflection.f0 * (1.0 - s) + glm::dvec3(s));
}

glm::dvec3 sample_ggx(double alpha, const glm::dvec3& wo, const glm::dvec3& n,
                      const glm::dvec2& u) {
  const glm::dquat frame = surface_frame(n, n);
  const glm::dvec3 eye = to_local(frame, wo);
  // The hemisphere is stretched by alpha, as seen from the eye.
  const glm::dvec3 stretched = glm::normalize(glm::dvec3(alpha * eye.x, alpha * eye.y, eye.z));
  const double lateral = std::hypot(stretched.x, stretched.y);
  const glm::dvec3 t1 = lateral > 0.0 ? glm::dvec3(-stretched.y, stretched.x, 0.0) / lateral
                                      : glm::dvec3(1.0, 0.0, 0.0);
  const glm::dvec3 t2 = glm::cross(stretched, t1);
  const double r = std::sqrt(u.x);
  const double phi = 2.0 * pi * u.y;
  const double a = r * std::cos(phi);
  const double half = 0.5 * (1.0 + stretched.z);
  const double b = (1.0 - half) * std::sqrt(std::max(0.0, 1.0 - a * a)) + half * r * std::sin(phi);
  const double c = std::sqrt(std::max(0.0, 1.0 - a * a - b * b));
  const glm::dvec3 m = a * t1 + b * t2 + c * stretched;
  const glm::dvec3 h = glm::normalize(glm::dvec3(alpha * m.x, alpha * m.y, std::max(m.z, 1e-12)));
  return frame * (2.0 * glm::dot(eye, h) * h - eye);
}

double ggx_pdf(double alpha, const glm::dvec3& wi, const glm::dvec3& wo, const glm::dvec3& n) {
  const glm::dquat frame = surface_frame(n, n);
  const glm::dvec3 eye = to_local(frame, wo);
  const glm::dvec3 h = eye + glm::conjugate(frame) * wi;
  const double length = glm::length(h);
  if (!(length > 0.0) || !(h.z > 0.0)) return 0.0;
  // D G1 (V.H) / N.V, and light moves 4 V.H times as far as H; G1 = 2 N.V / (N.V + root).
  return ggx_distribution(alpha, h.z / length) / (2.0 * (eye.z + smith_root(alpha * alpha, eye.z)));
}

bool is_varied(const Surface& surface) {
  const MetallicRoughness& material = surface.material.metallic_roughness;
  if (!to_arrays(*surface.mesh).colors.empty()) return true;
  return material.base_color_texture.content || material.metallic_roughness_texture.content ||
         material.normal_texture.content || material.emissive_texture.content ||
         material.transmission_texture.content;
}

bool may_mirror(const MetallicRoughness& material) {
  return square(material.roughness) < GgxReflection::max_mirror_alpha ||
         material.metallic_roughness_texture.content;
}

MaterialPoint material_at(const MetallicRoughness& material, const MeshValues& mesh) {
  MaterialPoint point = combined(material, lookup(material.base_color_texture, mesh),
                                 lookup(material.metallic_roughness_texture, mesh),
                                 lookup(material.emissive_texture, mesh),
                                 lookup(material.transmission_texture, mesh), mesh.color);
  if (!material.normal_texture.content) return point;
  const glm::dvec3 n = 2.0 * glm::dvec3(lookup(material.normal_texture, mesh)) - glm::dvec3(1.0);
  const glm::dvec3 scaled(material.normal_scale * n.x, material.normal_scale * n.y,
                          std::max(n.z, min_normal_height));
  point.normal = glm::normalize(scaled);
  return point;
}

MaterialPoint average_material(const MetallicRoughness& material, const glm::dvec4& color) {
  const auto average = [](const TextureReference& texture) {
    return texture.content ? texture.content->average() : glm::vec4(1.0f);
  };
  return combined(material, average(material.base_color_texture),
                  average(material.metallic_roughness_texture), average(material.emissive_texture),
                  average(material.transmission_texture), color);
}

}  // namespace brume
