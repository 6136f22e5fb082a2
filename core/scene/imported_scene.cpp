#include "core/scene/imported_scene.h"

#include <set>
#include <string_view>

#include "brume/mesh_arrays.h"
#include "core/scene/copies.h"
#include "core/scene/mesh.h"

namespace brume {
namespace {

// Appends; a mesh without texture coordinates has none in the whole.
void append(MeshArrays& all, const MeshArrays& mesh) {
  const auto first = static_cast<unsigned>(all.points.size());
  all.points.insert(all.points.end(), mesh.points.begin(), mesh.points.end());
  all.normals.insert(all.normals.end(), mesh.normals.begin(), mesh.normals.end());
  for (const glm::uvec3& triangle : mesh.triangles) all.triangles.push_back(triangle + first);
}

Surface surface_of(const Surface& whole, const ImportedPart& part) {
  Surface surface = whole;
  const ImportedNode& source = whole.imported->nodes[part.node];
  const std::string& node = source.mesh_name.empty() ? source.name : source.mesh_name;
  surface.name = whole.name.empty() || whole.name == node ? node : whole.name + "/" + node;
  surface.imported = nullptr;
  surface.nodes.clear();
  surface.mesh = part.mesh;
  surface.material = part.material;
  return surface;
}

}  // namespace

std::vector<const ImportedPart*> chosen_parts(const ImportedScene& scene,
                                              std::span<const std::string> nodes) {
  const std::set<std::string_view> names(nodes.begin(), nodes.end());
  std::vector<bool> is_chosen(scene.nodes.size(), nodes.empty());
  for (std::size_t i = 0; i < scene.nodes.size() && !nodes.empty(); ++i) {
    const ImportedNode& node = scene.nodes[i];
    is_chosen[i] = (node.parent && is_chosen[*node.parent]) || names.contains(node.name);
  }
  std::vector<const ImportedPart*> parts;
  for (const ImportedPart& part : scene.parts) {
    if (is_chosen[part.node]) parts.push_back(&part);
  }
  return parts;
}

std::shared_ptr<const TriangleMesh> joined_mesh(std::span<const ImportedPart* const> parts) {
  if (parts.empty()) return nullptr;
  if (parts.size() == 1) return parts.front()->mesh;
  MeshArrays all;
  for (const ImportedPart* part : parts) append(all, to_arrays(*part->mesh));
  return to_mesh(all);
}

bool is_shown_as_it_is(const Surface& surface) {
  return surface.visible && !surface.imported && !surface.copies;
}

std::vector<Surface> shown_surfaces(std::span<const Surface> surfaces) {
  std::vector<Surface> shown;
  for (const Surface& surface : with_placed_copies({surfaces.begin(), surfaces.end()})) {
    if (!surface.visible) continue;
    if (!surface.imported) {
      shown.push_back(surface);
      continue;
    }
    for (const ImportedPart* part : chosen_parts(*surface.imported, surface.nodes)) {
      shown.push_back(surface_of(surface, *part));
    }
  }
  return shown;
}

}  // namespace brume
