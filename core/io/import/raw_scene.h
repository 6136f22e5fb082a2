#pragma once

#include <array>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "brume/mesh_arrays.h"
#include "brume/metallic_roughness.h"
#include "core/scene/imported_scene.h"

namespace brume {

inline constexpr std::size_t max_imported_nodes = 1 << 16;

// An image of a scene: a file of its own, or bytes within the scene's file.
struct RawImage {
  std::filesystem::path file{};  // where it is, absolute; within the scene's file, that
  std::string bytes{};           // as in a file; empty: in `file`
  std::string name{};            // within the scene's file, what that calls it
  std::string error{};           // why there are no bytes, if the scene's file is to blame
  bool is_absolute = false;      // the path that names it
};

struct RawTexture {
  std::size_t image = 0;
  TextureWrap wrap_u = TextureWrap::repeat;
  TextureWrap wrap_v = TextureWrap::repeat;
  bool uses_second_texcoords = false;
};

struct RawMaterial {
  std::string name{};                                   // empty: none
  MetallicRoughness values{};                           // without its textures
  std::array<std::optional<RawTexture>, 5> textures{};  // in the order of textures_of()
  // Its alpha, or brightness if it has none, multiplies the opacity.
  std::optional<std::size_t> opacity_image{};
  // The first channel of the transmission texture alone counts, and the base color texture, if
  // there is one, multiplies it.
  bool is_transmission_tinted = false;
};

struct RawPart {
  std::size_t node = 0;
  std::size_t material = 0;
  MeshArrays mesh{};
  // As in ImportedPart; the mesh is then that of an earlier part, if one is named.
  CopyPlacements placements{};
  std::optional<std::size_t> same_mesh_as{};
  PlacementKeys keys{};
  std::shared_ptr<const Deformation> deformation{};
};

// The content of a scene file before its images are decoded and its meshes made. Readers have
// checked all indices and numbers.
struct RawScene {
  std::vector<ImportedNode> nodes;
  std::vector<RawPart> parts;
  std::vector<RawMaterial> materials;
  std::vector<RawImage> images;
  std::vector<NamedCamera> cameras;
  std::vector<Light> lights;
  std::vector<std::filesystem::path> files;  // as in ImportedScene, without images
  std::vector<std::string> warnings;         // one line each, with the file's name
  std::string left_out;                      // as in ImportedScene
};

}  // namespace brume
