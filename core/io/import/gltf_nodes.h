#pragma once

#include <cstddef>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "brume/copies.h"
#include "core/io/import/gltf_file.h"
#include "core/io/import/node_motion.h"
#include "core/number_domain.h"

namespace brume {

struct GltfNode {
  std::size_t element = 0;              // of the list `nodes`
  std::optional<std::size_t> parent{};  // of read_gltf_nodes()
  glm::dmat4 to_world{1.0};             // affine; entries of domain::coordinate
  glm::dmat4 to_parent{1.0};
  NodeTransform transform{};  // which that is, unless the file has a matrix
};

// The nodes of the file's scene, of all nodes if it has none; parents before their children. Throws
// InputError if they are no trees, if a transform is no matrix of coordinates, or for more than
// max_imported_nodes.
std::vector<GltfNode> read_gltf_nodes(GltfFile& file);

// The member `key` of an object, a list of elements of the list `nodes`; empty if missing.
std::vector<std::size_t> gltf_node_indices(GltfFile& file, JsonObject& object, const char* key);

// The transforms of a node's instances within it (EXT_mesh_gpu_instancing); without any, the node
// is its only one.
std::vector<glm::dmat4> gltf_instances(GltfFile& file, JsonObject& node);

// Transforms as placements; empty: one of them stretches or mirrors.
CopyPlacements placements_of(std::span<const glm::dmat4> transforms);

// Numbers of materials and lights as exporters write them: 1.0000001 for 1, a negative intensity.
// The nearest allowed one is taken, with a warning; what is no number throws InputError.
double nearest_number(GltfFile& file, JsonObject& object, std::string_view key,
                      const NumberDomain& domain, double fallback);
std::vector<double> nearest_numbers(GltfFile& file, JsonObject& object, std::string_view key,
                                    const NumberDomain& domain, std::vector<double> fallback);
glm::dvec3 nearest_vector(GltfFile& file, JsonObject& object, std::string_view key,
                          const NumberDomain& domain, const glm::dvec3& fallback);

}  // namespace brume
