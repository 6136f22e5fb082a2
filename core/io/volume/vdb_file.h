#pragma once

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <string>
#include <vector>

#include "core/io/byte_reader.h"
#include "core/io/volume/vdb_tree.h"

namespace brume {

// Header of a grid in an OpenVDB file.
struct VdbGrid {
  std::string name;
  std::string type;  // of its values, as OpenVDB calls it
  std::string kind;  // its class: "fog volume", "level set", "staggered"; may be empty
  // Voxel v is at origin + axes v in the world; nothing where that is not linear.
  struct Transform {
    glm::dmat3 axes;
    glm::dvec3 origin;
  };
  std::optional<Transform> transform;
  // How to read the tree, and its position; nullopt if its values are not numbers.
  std::optional<VdbValues> values;
  std::uint64_t tree = 0, end = 0;  // [bytes]
};

// The newest version of the format that is known: what a newer one changed may be read wrongly.
inline constexpr std::uint32_t newest_vdb_version = 225;
// The version of a file's format. Throws InputError: not OpenVDB's format.
std::uint32_t vdb_version(const std::filesystem::path& file, std::string_view bytes);

// The grids of a file in its order. Throws InputError: not OpenVDB's format from version 222 on,
// damaged, or written as a stream (without the places of the grids).
std::vector<VdbGrid> read_vdb_grids(const std::filesystem::path& file, std::string_view bytes);

// The grids of a name, of which programs write several, one for each of their primitives. Throws
// InputError naming the grids of the file if there is none.
std::vector<VdbGrid> grids_named(const std::filesystem::path& file,
                                 const std::vector<VdbGrid>& grids, const std::string& name);

}  // namespace brume
