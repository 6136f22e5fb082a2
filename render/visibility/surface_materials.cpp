#include "render/visibility/surface_materials.h"

#include <algorithm>
#include <glm/geometric.hpp>

namespace brume {
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
