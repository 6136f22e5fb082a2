#pragma once

#include <array>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "brume/keys.h"
#include "brume/scene.h"
#include "core/scene/deformation.h"

namespace brume {

// A node of another program's scene. Its own transform is in the points of its parts.
struct ImportedNode {
  std::string name;                     // not empty; several nodes may have the same
  std::optional<std::size_t> parent{};  // an earlier node
  std::string mesh_name{};              // what it shows is called, if the file names only its mesh
};

// Keyframes of a placement.
struct PlacementKeys {
  Keys<glm::dvec3> translate;
  Keys<glm::dquat> rotate;
  Keys<double> scale;

  [[nodiscard]] bool empty() const { return translate.empty(); }  // all or none are
  [[nodiscard]] std::size_t bytes() const {
    return std::span(translate).size_bytes() + std::span(rotate).size_bytes() +
           std::span(scale).size_bytes();
  }
  bool operator==(const PlacementKeys&) const = default;
};

// A mesh of a node, all of one material.
struct ImportedPart {
  std::size_t node = 0;
  std::shared_ptr<const TriangleMesh> mesh;  // in the coordinates of its file [u]
  Material material;                         // its name is not empty
  // Where the file places a mesh that it has several times, which is in its own coordinates then;
  // else empty.
  CopyPlacements placements{};
  // Its movement in the coordinates of the file, and that of its placements; the mesh is in its own
  // then. Empty: it stands.
  PlacementKeys keys{};
  // Makes the mesh of another time than 0 s, whose `mesh` is; null: it stays.
  std::shared_ptr<const Deformation> deformation{};
};

// A glTF, OBJ or FBX scene, as its file has it: y up.
struct ImportedScene {
  std::vector<ImportedNode> nodes;
  std::vector<ImportedPart> parts;
  std::vector<NamedCamera> cameras;
  std::vector<Light> lights;
  // The files it was read from: itself, then its buffers, material files and textures.
  std::vector<std::filesystem::path> files;
  // Those of them that its file names by absolute paths. On another machine the reader looks for
  // them beside the file.
  std::vector<std::filesystem::path> absolute_files;
  std::filesystem::file_time_type changed{};  // the latest of them, when it was read
  std::string left_out;  // where the first mesh without triangles is, and what it has; empty: none
};

// The textures of a material, in the order that imported ones are listed in.
auto textures_of(auto& material) {
  return std::array{&material.base_color_texture, &material.metallic_roughness_texture,
                    &material.normal_texture, &material.emissive_texture,
                    &material.transmission_texture};
}
inline constexpr std::array texture_has_colors{true, false, false, true, true};

// The parts of the nodes with these names and of all nodes below them; of all nodes if there is no
// name.
std::vector<const ImportedPart*> chosen_parts(const ImportedScene& scene,
                                              std::span<const std::string> nodes);

// The parts of a node and of all nodes below it.
std::vector<const ImportedPart*> parts_below(const ImportedScene& scene, std::size_t node);

// The first material of this name in a file; null: it has none.
const Material* material_of_file(const ImportedScene& scene, const std::string& name);
// True for each of textures_of() a material in place of one of a file that is the file's: as the
// file's own material has it, or within the file, where no scene file can name it.
std::array<bool, texture_has_colors.size()> are_of_file(const ImportedScene& scene,
                                                        const Material& material);

// The material of a part of an imported scene that a surface shows: its own, or that of the file.
const Material& material_of(const Surface& surface, const ImportedPart& part);
// The names of those of the parts that a surface shows, each once, in the order of the file.
std::vector<std::string> material_names(const Surface& surface);

// The placements of a part's mesh at a time [s]; empty: it is in the file's coordinates.
CopyPlacements placements_at(const ImportedPart& part, double time);

// These parts as one mesh, as they are at 0 s; null if there is none.
std::shared_ptr<const TriangleMesh> joined_mesh(std::span<const ImportedPart* const> parts);

// The surfaces that frames show at a time [s], once keys are applied: visible ones, and in place of
// one with an imported scene its parts where that file's animation has them then, each with the
// placements of that surface. Where more than 16 parts share a mesh they are one, with copies,
// called as the first. They are named SURFACE/NODE, or NODE where the surface has no name or the
// same. A node that has no name is called as its mesh.
std::vector<Surface> shown_surfaces(std::span<const Surface> surfaces, double time);
// Whether a surface stays itself there.
bool is_shown_as_it_is(const Surface& surface);

}  // namespace brume
