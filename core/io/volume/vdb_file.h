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

// The grids of a file in its order. Throws InputError: not OpenVDB's format in one of its versions
// 222 to 224, damaged, or written as a stream (without the places of the grids).
std::vector<VdbGrid> read_vdb_grids(const std::filesystem::path& file, std::string_view bytes);

// The first grid of a name. Throws InputError naming the grids of the file if there is none.
const VdbGrid& grid_named(const std::filesystem::path& file, const std::vector<VdbGrid>& grids,
                          const std::string& name);

}  // namespace brume
