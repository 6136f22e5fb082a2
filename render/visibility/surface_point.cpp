#include "render/visibility/surface_point.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "core/scene/materials/brdf.h"

namespace brume {

glm::dvec3 brdf(const SurfacePoint& point, const glm::dvec3& wi) {
  if (point.ggx) return ggx_brdf(*point.ggx, wi, point.to_eye, point.normal);
  return brdf(point.surface->material, wi, point.to_eye, point.normal);
}

TextureFrame::TextureFrame(const std::array<glm::dvec3, 3>& positions,
                           const std::array<glm::dvec2, 3>& texcoords) {
  const glm::dvec3 p1 = positions[1] - positions[0];
  const glm::dvec3 p2 = positions[2] - positions[0];
  const glm::dvec2 t1 = texcoords[1] - texcoords[0];
  const glm::dvec2 t2 = texcoords[2] - texcoords[0];
  const double determinant = t1.x * t2.y - t1.y * t2.x;
  const double area = glm::length(glm::cross(p1, p2));
  if (determinant == 0.0 || !(area > 0.0)) return;
  // Only directions count: not divided by the determinant, whose sign they have.
  const double sign = determinant > 0.0 ? 1.0 : -1.0;
  along_u = sign * (t2.y * p1 - t1.y * p2);
  along_v = sign * (t1.x * p2 - t2.x * p1);
  density = std::sqrt(std::abs(determinant) / area);
}

glm::dvec3 TextureFrame::to_world(const glm::dvec3& of_texture, const glm::dvec3& n) const {
  const glm::dvec3 in_plane = along_u - glm::dot(along_u, n) * n;
  const double length = glm::length(in_plane);
  if (!(length > 0.0)) return n;
  const glm::dvec3 tangent = in_plane / length;
  const glm::dvec3 across = glm::cross(n, tangent);
  // Where the texture is mirrored, v runs the other way.
  const double handedness = glm::dot(across, along_v) < 0.0 ? -1.0 : 1.0;
  return glm::normalize(of_texture.x * tangent + of_texture.y * handedness * across +
                        of_texture.z * n);
}

MeshValues MeshFrame::with_width(double width) const {
  MeshValues result = values;
  for (std::size_t set = 0; set < textures.size(); ++set) {
    result.texcoords[set].footprint = width * textures[set].density;
  }
  return result;
}

MaterialPoint material_at(const MetallicRoughness& material, const MeshFrame& frame, double width,
                          double side, glm::dvec3& normal) {
  MaterialPoint point = material_at(material, frame.with_width(width));
  const TextureReference& map = material.normal_texture;
  if (map.content && glm::dot(normal, normal) > 0.0) {
    const TextureFrame& texture = frame.textures[map.uses_second_texcoords ? 1 : 0];
    normal = side * texture.to_world(point.normal, side * normal);
  }
  return point;
}

namespace {

void set(const MaterialPoint& material, std::size_t k, GgxPoints& ggx) {
  ggx.diffuse.set(k, glm::vec3(material.reflection.diffuse));
  ggx.f0.set(k, glm::vec3(material.reflection.f0));
  ggx.emitted.set(k, glm::vec3(material.emitted));
  ggx.alpha[k] = static_cast<float>(material.reflection.alpha);
  ggx.lobe[k] = 1.0f;
}

}  // namespace

void find_materials(std::span<const MeshFrame> frames, std::span<const double> distances,
                    SurfacePoints& points) {
  const MetallicRoughness& material = points.surface->material.metallic_roughness;
  if (frames.empty()) {
    const MaterialPoint everywhere = material_at(material, MeshValues());
    for (std::size_t k = 0; k < points.padded_size(); ++k) set(everywhere, k, points.ggx);
    return;
  }
  for (std::size_t k = 0; k < points.padded_size(); ++k) {
    const std::size_t point = std::min(k, points.count - 1);
    glm::dvec3 normal = points.normal[k];
    const double cosine = std::max(glm::dot(normal, points.to_eye[k]), min_grazing_cosine);
    const double width = (static_cast<double>(points.pixel_angle) * distances[point] +
                          static_cast<double>(points.pixel_width)) /
                         cosine;
    set(material_at(material, frames[point], width, static_cast<double>(points.side[k]), normal), k,
        points.ggx);
    points.normal.set(k, glm::vec3(normal));
  }
}

}  // namespace brume
