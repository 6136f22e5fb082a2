#include "core/io/scene/scene_budget.h"

#include <cmath>
#include <set>
#include <string>

#include "brume/gaussian.h"
#include "brume/mesh_arrays.h"
#include "core/scene/imported_scene.h"
#include "core/scene/lights/emitting_surfaces.h"
#include "core/scene/lights/photometric_profile.h"
#include "core/scene/lights/radiance_map.h"
#include "core/scene/materials/measured_brdf.h"
#include "core/scene/materials/texture.h"
#include "core/scene/mesh.h"

namespace brume {

void SceneBudget::reserve_gaussians(const JsonPath& path, std::size_t count) {
  if (count > gaussians_left()) {
    context_.fail(
        path,
        "found " + std::to_string(gaussians_ + count) +
            " Gaussians in the scene so far, including emitters and sequences; allowed: at most " +
            std::to_string(limits::gaussians));
  }
  gaussians_ += count;
  reserve_bytes(path, count * (sizeof(Gaussian) + sizeof(GaussianId)));
}

void SceneBudget::reserve(const JsonPath& path, const RadianceMap& map) {
  reserve_bytes(path, map.pixels.size() * sizeof(glm::vec3));
}

void SceneBudget::reserve(const JsonPath& path, const MeasuredBrdf& measured) {
  reserve_bytes(path, measured.values().size() * sizeof(glm::vec3));
}

void SceneBudget::reserve(const JsonPath& path, const PhotometricProfile& profile) {
  reserve_bytes(path, profile.bytes());
}

void SceneBudget::reserve(const JsonPath& path, const Texture& texture) {
  reserve_bytes(path, texture.bytes());
}

void SceneBudget::reserve(const JsonPath& path, const TriangleMesh& mesh) {
  reserve_bytes(path, mesh_bytes(mesh));
}

void SceneBudget::reserve(const JsonPath& path, std::span<const ImportedPart* const> parts) {
  constexpr std::size_t max_parts = 4 * limits::surfaces;
  std::set<const TriangleMesh*> meshes;
  for (const ImportedPart* part : parts) meshes.insert(part->mesh.get());
  parts_ += meshes.size();
  if (parts_ > max_parts) {
    context_.fail(path, "the imported scenes have " + std::to_string(parts_) +
                            " meshes of nodes so far; allowed: at most " +
                            std::to_string(max_parts));
  }
  std::set<const Texture*> textures;
  for (const ImportedPart* part : parts) {
    if (meshes.erase(part->mesh.get()) > 0) reserve(path, *part->mesh);
    reserve_bytes(path, part->placements.size() * limits::copy_bytes + part->keys.bytes());
    for (const TextureReference* texture : textures_of(part->material.metallic_roughness)) {
      if (texture->content) textures.insert(texture->content.get());
    }
  }
  for (const Texture* texture : textures) reserve(path, *texture);
}

void SceneBudget::reserve_copies(const JsonPath& path, double count, const Surface& surface) {
  constexpr std::size_t light_bytes = 512;  // of an emitting triangle
  std::size_t emitting = 0;                 // triangles
  if (!surface.imported) {
    emitting = is_emissive(surface) ? surface.mesh->n_faces() : 0;
  } else {
    for (const ImportedPart* part : chosen_parts(*surface.imported, surface.nodes)) {
      if (emits(material_of(surface, *part))) emitting += part->mesh->n_faces();
    }
  }
  const std::size_t bytes = limits::copy_bytes + light_bytes * emitting;
  const std::size_t max_count = (limits::scene_bytes - bytes_) / bytes;
  if (!(std::round(count) <= static_cast<double>(max_count))) {
    context_.fail(path, "found " + quoted_text(std::round(count)) +
                            " copies; allowed: as many as the memory of the scene holds, " +
                            std::to_string(max_count) + " more");
  }
  reserve_bytes(path, static_cast<std::size_t>(std::llround(count)) * bytes);
}

void SceneBudget::reserve_bytes(const JsonPath& path, std::size_t bytes) {
  bytes_ += bytes;
  if (bytes_ <= limits::scene_bytes) return;
  context_.fail(path, "the files of the scene take " + std::to_string(bytes_) +
                          " bytes of memory so far; allowed: at most " +
                          std::to_string(limits::scene_bytes));
}

std::size_t SceneBudget::gaussians_left() const {
  return limits::gaussians - gaussians_;
}

std::size_t SceneBudget::copies_left() const {
  return (limits::scene_bytes - bytes_) / limits::copy_bytes;
}

}  // namespace brume
