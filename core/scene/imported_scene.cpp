#include "core/scene/imported_scene.h"

#include <algorithm>
#include <glm/common.hpp>
#include <map>
#include <set>
#include <string_view>
#include <utility>

#include "brume/mesh_arrays.h"
#include "brume/primitive.h"
#include "core/scene/copies.h"
#include "core/scene/mesh.h"
#include "core/scene/placement.h"
#include "core/scene/remembered.h"

namespace brume {
namespace {

// Appends; a mesh without texture coordinates has none in the whole.
void append(MeshArrays& all, const MeshArrays& mesh) {
  const auto first = static_cast<unsigned>(all.points.size());
  all.points.insert(all.points.end(), mesh.points.begin(), mesh.points.end());
  all.normals.insert(all.normals.end(), mesh.normals.begin(), mesh.normals.end());
  for (const glm::uvec3& triangle : mesh.triangles) all.triangles.push_back(triangle + first);
}

// The same at a placement.
void append(MeshArrays& all, const MeshArrays& mesh, const Placement& placement) {
  const std::size_t first = all.points.size();
  append(all, mesh);
  for (std::size_t i = first; i < all.points.size(); ++i) {
    all.points[i] = placement.point_to_world(glm::dvec3(all.points[i]));
    all.normals[i] = placement.normal_to_world(glm::dvec3(all.normals[i]));
  }
}

// The box around a mesh.
MeshArrays box_mesh(const TriangleMesh& mesh) {
  const MeshBox around = box_of(mesh);
  MeshArrays box = to_arrays(*mesh_of({Primitive::Shape::box, glm::dvec3(1.0)}));
  for (glm::vec3& p : box.points) {
    p = glm::mix(around.low, around.high, glm::dvec3(p) + 0.5);
  }
  return box;
}

// Where the surface stands that shows parts which share their mesh, and its copies.
struct PartPlacements {
  CopyPlacement own;
  std::shared_ptr<const CopyPlacements> copies;  // null: none
};

// What they depend on.
struct PartsKey {
  Identity<ImportedScene> scene;
  std::vector<const ImportedPart*> parts;
  Placement placement;
  Identity<CopyPlacements> copies;
  double time;  // of parts that move; else 0

  bool operator==(const PartsKey&) const = default;
};

CopyPlacement within(const Placement& outer, const CopyPlacement& inner) {
  return {outer.point_to_world(inner.translate), outer.rotate * inner.rotate,
          outer.scale * inner.scale};
}

PartPlacements placements_of(const Surface& whole, std::span<const ImportedPart* const> parts,
                             double time) {
  const auto compute = [&] {
    CopyPlacements all;
    for (std::size_t copy = 0; copy < placement_count(whole); ++copy) {
      const Placement outer = placement_of(whole, copy);
      for (const ImportedPart* part : parts) {
        for (const CopyPlacement& inner : placements_at(*part, time)) {
          all.push_back(within(outer, inner));
        }
      }
    }
    PartPlacements result{all.front(), nullptr};
    all.erase(all.begin());
    if (!all.empty()) result.copies = std::make_shared<const CopyPlacements>(std::move(all));
    return result;
  };
  const bool moves =
      std::ranges::any_of(parts, [](const ImportedPart* part) { return !part->keys.empty(); });
  if (parts.size() == 1 && parts.front()->placements.empty() && !whole.placed_copies) {
    return compute();
  }
  static Remembered<PartsKey, PartPlacements> results;
  return results.get({whole.imported,
                      {parts.begin(), parts.end()},
                      Placement(whole),
                      whole.placed_copies,
                      moves ? time : 0.0},
                     compute, [](const PartPlacements& result) {
                       return result.copies ? std::span(*result.copies).size_bytes()
                                            : sizeof(result);
                     });
}

struct DeformedKey {
  Identity<Deformation> deformation;
  double time;

  bool operator==(const DeformedKey&) const = default;
};

std::shared_ptr<const TriangleMesh> mesh_at(const ImportedPart& part, double time) {
  if (!part.deformation) return part.mesh;
  const std::vector<Pose>& poses = part.deformation->poses;
  time = std::clamp(time, poses.front().time, poses.back().time);
  static Remembered<DeformedKey, std::shared_ptr<const TriangleMesh>> results;
  return results.get(
      {part.deformation, time}, [&] { return to_mesh(deformed(*part.deformation, time)); },
      [](const auto& mesh) { return mesh_bytes(*mesh); });
}

Surface surface_of(const Surface& whole, const ImportedPart& part, double time) {
  Surface surface = whole;
  const ImportedNode& source = whole.imported->nodes[part.node];
  const std::string& node = source.mesh_name.empty() ? source.name : source.mesh_name;
  surface.name = whole.name.empty() || whole.name == node ? node : whole.name + "/" + node;
  surface.imported = nullptr;
  surface.nodes.clear();
  surface.mesh = mesh_at(part, time);
  surface.material = material_of(whole, part);
  surface.materials.clear();
  return surface;
}

// One value per node: true if it is chosen, or is below one that is.
std::vector<bool> nodes_below(const ImportedScene& scene, auto is_chosen) {
  std::vector<bool> result(scene.nodes.size());
  for (std::size_t i = 0; i < result.size(); ++i) {
    const std::optional<std::size_t>& parent = scene.nodes[i].parent;
    result[i] = (parent && result[*parent]) || is_chosen(i);
  }
  return result;
}

std::vector<const ImportedPart*> parts_of(const ImportedScene& scene,
                                          const std::vector<bool>& nodes) {
  std::vector<const ImportedPart*> parts;
  for (const ImportedPart& part : scene.parts) {
    if (nodes[part.node]) parts.push_back(&part);
  }
  return parts;
}

}  // namespace

std::vector<const ImportedPart*> chosen_parts(const ImportedScene& scene,
                                              std::span<const std::string> nodes) {
  const std::set<std::string_view> names(nodes.begin(), nodes.end());
  return parts_of(scene, nodes_below(scene, [&](std::size_t node) {
                    return names.empty() || names.contains(scene.nodes[node].name);
                  }));
}

std::vector<const ImportedPart*> parts_below(const ImportedScene& scene, std::size_t node) {
  return parts_of(scene, nodes_below(scene, [node](std::size_t other) { return other == node; }));
}

const Material* material_of_file(const ImportedScene& scene, const std::string& name) {
  for (const ImportedPart& part : scene.parts) {
    if (part.material.name == name) return &part.material;
  }
  return nullptr;
}

std::array<bool, texture_has_colors.size()> are_of_file(const ImportedScene& scene,
                                                        const Material& material) {
  const Material none;
  const Material* of_file = material_of_file(scene, material.name);
  const auto textures = textures_of(material.metallic_roughness);
  const auto originals = textures_of((of_file ? of_file : &none)->metallic_roughness);
  std::array<bool, texture_has_colors.size()> result{};
  for (std::size_t k = 0; k < result.size(); ++k) {
    const bool is_within = !textures[k]->file.empty() && !scene.files.empty() &&
                           textures[k]->file == scene.files.front();
    result[k] = is_within || *textures[k] == *originals[k];
  }
  return result;
}

const Material& material_of(const Surface& surface, const ImportedPart& part) {
  const auto replacement =
      std::ranges::find(surface.materials, part.material.name, &Material::name);
  return replacement == surface.materials.end() ? part.material : *replacement;
}

std::vector<std::string> material_names(const Surface& surface) {
  std::vector<std::string> names;
  if (!surface.imported) return names;
  std::set<std::string_view> known;
  for (const ImportedPart* part : chosen_parts(*surface.imported, surface.nodes)) {
    if (known.insert(part->material.name).second) names.push_back(part->material.name);
  }
  return names;
}

CopyPlacements placements_at(const ImportedPart& part, double time) {
  if (part.keys.empty()) return part.placements;
  const auto& [translate, rotate, scale] = part.keys;
  const CopyPlacement outer{value_at(translate, time), value_at(rotate, time),
                            value_at(scale, time)};
  if (part.placements.empty()) return {outer};
  CopyPlacements all;
  for (const CopyPlacement& inner : part.placements) all.push_back(within(Placement(outer), inner));
  return all;
}

std::shared_ptr<const TriangleMesh> joined_mesh(std::span<const ImportedPart* const> parts) {
  if (parts.empty()) return nullptr;
  if (parts.size() == 1 && placements_at(*parts.front(), 0.0).empty()) return parts.front()->mesh;
  // Beyond so many triangles, copies are the boxes around them.
  constexpr std::size_t max_triangles = 2'000'000;
  MeshArrays all;
  for (const ImportedPart* part : parts) {
    const CopyPlacements placements = placements_at(*part, 0.0);
    if (placements.empty()) append(all, to_arrays(*part->mesh));
    for (const CopyPlacement& placement : placements) {
      const bool has_room = all.triangles.size() + part->mesh->n_faces() <= max_triangles;
      append(all, has_room ? to_arrays(*part->mesh) : box_mesh(*part->mesh), Placement(placement));
    }
  }
  return to_mesh(std::move(all));
}

bool is_shown_as_it_is(const Surface& surface) {
  return surface.visible && !surface.imported && !surface.copies;
}

// As many nodes with one mesh are surfaces of their own.
constexpr std::size_t max_nodes_apart = 16;

std::vector<Surface> shown_surfaces(std::span<const Surface> surfaces, double time) {
  std::vector<Surface> shown;
  for (const Surface& surface : with_placed_copies({surfaces.begin(), surfaces.end()})) {
    if (!surface.visible) continue;
    if (!surface.imported) {
      shown.push_back(surface);
      continue;
    }
    std::vector<std::vector<const ImportedPart*>> sharing;  // mesh and material
    std::map<const TriangleMesh*, std::size_t> places;      // in `sharing`
    const std::vector<const ImportedPart*> chosen = chosen_parts(*surface.imported, surface.nodes);
    std::map<const TriangleMesh*, std::size_t> uses;
    for (const ImportedPart* part : chosen) ++uses[part->mesh.get()];
    for (const ImportedPart* part : chosen) {
      const bool is_alone = uses[part->mesh.get()] <= max_nodes_apart;
      const auto [place, is_new] = is_alone ? std::pair(places.end(), true)
                                            : places.try_emplace(part->mesh.get(), sharing.size());
      if (is_new) {
        sharing.push_back({part});
      } else {
        sharing[place->second].push_back(part);
      }
    }
    for (const std::vector<const ImportedPart*>& parts : sharing) {
      Surface& added = shown.emplace_back(surface_of(surface, *parts.front(), time));
      if (parts.front()->placements.empty() && parts.front()->keys.empty()) continue;
      const auto [own, copies] = placements_of(surface, parts, time);
      added.translate = own.translate;
      added.rotate = own.rotate;
      added.scale = own.scale;
      added.placed_copies = copies;
    }
  }
  return shown;
}

}  // namespace brume
