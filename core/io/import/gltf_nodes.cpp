#include "core/io/import/gltf_nodes.h"

#include <algorithm>
#include <glm/gtc/quaternion.hpp>
#include <string>

#include "core/io/import/raw_scene.h"
#include "core/number_domain.h"

namespace brume {
namespace {

// Roots of the default scene; of all nodes, if the file has no scene.
std::vector<std::size_t> roots(GltfFile& file) {
  const std::size_t count = file.list("nodes").size();
  if (!file.list("scenes").empty()) {
    JsonObject root = file.root();
    JsonObject scene = file.object("scenes", file.index(root, "scene", "scenes").value_or(0));
    return gltf_node_indices(file, scene, "nodes");
  }
  std::vector<bool> is_child(count, false);
  for (std::size_t i = 0; i < count; ++i) {
    JsonObject node = file.object("nodes", i);
    for (const std::size_t child : gltf_node_indices(file, node, "children"))
      is_child[child] = true;
  }
  std::vector<std::size_t> result;
  for (std::size_t i = 0; i < count; ++i) {
    if (!is_child[i]) result.push_back(i);
  }
  return result;
}

void check_node_transform(GltfFile& file, const JsonPath& path, const glm::dmat4& to_world) {
  for (int k = 0; k < 16; ++k) {
    const double value = to_world[k / 4][k % 4];
    if (domain::coordinate.contains(value)) continue;
    file.context().fail(path, "its transform in the scene: " + domain::coordinate.refusal(value));
  }
}

// Sets the transform of a node to its parent.
void read_transform(GltfFile& file, JsonObject& object, GltfNode& node) {
  if (const Json* matrix = object.find("matrix")) {
    const std::vector<double> m =
        read_numbers(file.context(), *matrix, object.path_of("matrix"), 16, domain::coordinate);
    for (int k = 0; k < 16; ++k) node.to_parent[k / 4][k % 4] = m[static_cast<std::size_t>(k)];
    return;
  }
  auto& [translation, rotation, scale] = node.transform;
  if (const Json* value = object.find("rotation")) {
    const std::vector<double> q =
        read_numbers(file.context(), *value, object.path_of("rotation"), 4, domain::coordinate);
    rotation = glm::dquat(q[3], q[0], q[1], q[2]);
    const double length = glm::length(rotation);
    if (!(length > 0.0)) object.fail("rotation", "found length 0; allowed: a unit quaternion");
    rotation /= length;
  }
  scale = object.vector("scale", domain::coordinate, glm::dvec3(1.0));
  translation = object.vector("translation", domain::coordinate, glm::dvec3(0.0));
  node.to_parent = node.transform.matrix();
}

}  // namespace

std::vector<std::size_t> gltf_node_indices(GltfFile& file, JsonObject& object, const char* key) {
  const std::size_t count = file.list("nodes").size();
  std::vector<std::size_t> indices;
  for (const Json& value : object.array(key, count)) {
    if (!value.is_number_unsigned() || value.get<std::uint64_t>() >= count) {
      object.fail(key, "found " + quoted_json(value) + "; allowed: one of the " +
                           std::to_string(count) + " nodes");
    }
    indices.push_back(value.get<std::size_t>());
  }
  return indices;
}

std::vector<GltfNode> read_gltf_nodes(GltfFile& file) {
  std::vector<GltfNode> nodes;
  struct Visit {
    std::size_t element;
    std::optional<std::size_t> parent;
  };
  std::vector<Visit> open;
  for (const std::size_t root : roots(file)) open.push_back({root, std::nullopt});
  std::ranges::reverse(open);
  std::vector<bool> is_known(file.list("nodes").size(), false);
  while (!open.empty()) {
    const Visit visit = open.back();
    open.pop_back();
    JsonObject object = file.object("nodes", visit.element);
    if (is_known[visit.element]) {
      file.context().fail(object.path(), "is the child of more than one node; allowed: a tree");
    }
    is_known[visit.element] = true;
    if (nodes.size() >= max_imported_nodes) {
      file.context().fail(file.path().member("nodes"),
                          "found more than " + std::to_string(max_imported_nodes) +
                              " nodes; allowed: " + std::to_string(max_imported_nodes));
    }
    const std::size_t index = nodes.size();
    const glm::dmat4 parent = visit.parent ? nodes[*visit.parent].to_world : glm::dmat4(1.0);
    GltfNode& node = nodes.emplace_back();
    node.element = visit.element;
    node.parent = visit.parent;
    read_transform(file, object, node);
    node.to_world = parent * node.to_parent;
    check_node_transform(file, object.path(), node.to_world);
    std::vector<std::size_t> children = gltf_node_indices(file, object, "children");
    for (auto child = children.rbegin(); child != children.rend(); ++child) {
      open.push_back({*child, index});
    }
  }
  return nodes;
}

}  // namespace brume
