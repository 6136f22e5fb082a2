#include "core/io/import/gltf_nodes.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/quaternion.hpp>
#include <glm/matrix.hpp>
#include <limits>
#include <string>

#include "brume/limits.h"
#include "core/io/import/gltf_mesh.h"
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

std::vector<glm::dmat4> gltf_instances(GltfFile& file, JsonObject& node) {
  auto extensions = node.find_object("extensions");
  auto instancing = extensions ? extensions->find_object("EXT_mesh_gpu_instancing") : std::nullopt;
  if (!instancing) return {glm::dmat4(1.0)};
  JsonObject attributes = instancing->object("attributes");
  const auto translations = gltf_vectors<glm::vec3>(file, attributes, "TRANSLATION");
  const auto rotations = gltf_vectors<glm::vec4>(file, attributes, "ROTATION");
  const auto scales = gltf_vectors<glm::vec3>(file, attributes, "SCALE");
  const std::size_t count = std::max({translations.size(), rotations.size(), scales.size()});
  for (const std::size_t size : {translations.size(), rotations.size(), scales.size()}) {
    if (size == 0 || size == count) continue;
    file.context().fail(attributes.path(), "found " + std::to_string(size) + " values for " +
                                               std::to_string(count) + " instances");
  }
  if (count > limits::copies) {
    file.context().fail(attributes.path(), "the instances take more memory than the allowed " +
                                               std::to_string(limits::scene_bytes) + " bytes");
  }
  std::vector<glm::dmat4> transforms;
  for (std::size_t i = 0; i < count; ++i) {
    glm::dquat rotation(1.0, 0.0, 0.0, 0.0);
    if (!rotations.empty()) {
      const glm::dvec4 q(rotations[i]);
      rotation = glm::dquat(q.w, q.x, q.y, q.z);
      if (!(glm::length(rotation) > 0.0)) {
        attributes.fail("ROTATION", "found length 0; allowed: unit quaternions");
      }
    }
    const glm::dvec3 scale = scales.empty() ? glm::dvec3(1.0) : glm::dvec3(scales[i]);
    glm::dmat4 instance(glm::mat4_cast(glm::normalize(rotation)));
    for (int k = 0; k < 3; ++k) instance[k] *= scale[k];
    if (!translations.empty()) instance[3] = glm::dvec4(glm::dvec3(translations[i]), 1.0);
    transforms.push_back(instance);
  }
  return transforms;
}

CopyPlacements placements_of(std::span<const glm::dmat4> transforms) {
  CopyPlacements result;
  for (const glm::dmat4& transform : transforms) {
    const glm::dmat3 axes(transform);
    const double scale = glm::length(axes[0]);
    // Roundings of float.
    constexpr double rounding = 1e-5;
    const glm::dmat3 turn = (1.0 / scale) * axes;
    const glm::dmat3 difference = glm::transpose(turn) * turn - glm::dmat3(1.0);
    double greatest = 0.0;
    for (int k = 0; k < 9; ++k) {
      greatest = std::max(greatest, std::abs(difference[k / 3][k % 3]));
    }
    const glm::dvec3 translate(transform[3]);
    const bool is_placed =
        domain::length.contains(scale) && greatest < rounding && glm::determinant(turn) > 0.0 &&
        domain::coordinate.contains(translate.x) && domain::coordinate.contains(translate.y) &&
        domain::coordinate.contains(translate.z);
    if (!is_placed) return {};
    result.push_back({translate, glm::normalize(glm::quat_cast(turn)), scale});
  }
  return result;
}

namespace {

constexpr double max_double = std::numeric_limits<double>::max();
constexpr NumberDomain any_number{-max_double, max_double, "a number"};

double nearest(GltfFile& file, const JsonPath& path, const NumberDomain& domain, double value) {
  if (domain.contains(value)) return value;
  const double taken = domain.nearest(value);
  file.context().warn(path, domain.refusal(value) + "; taken as " + quoted_text(taken));
  return taken;
}

}  // namespace

double nearest_number(GltfFile& file, JsonObject& object, std::string_view key,
                      const NumberDomain& domain, double fallback) {
  return nearest(file, object.path_of(key), domain, object.number(key, any_number, fallback));
}

std::vector<double> nearest_numbers(GltfFile& file, JsonObject& object, std::string_view key,
                                    const NumberDomain& domain, std::vector<double> fallback) {
  const Json* value = object.find(key);
  if (value == nullptr) return fallback;
  const JsonPath path = object.path_of(key);
  std::vector<double> numbers =
      read_numbers(file.context(), *value, path, fallback.size(), any_number);
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    numbers[i] = nearest(file, path.element(i), domain, numbers[i]);
  }
  return numbers;
}

glm::dvec3 nearest_vector(GltfFile& file, JsonObject& object, std::string_view key,
                          const NumberDomain& domain, const glm::dvec3& fallback) {
  const auto v = nearest_numbers(file, object, key, domain, {fallback.x, fallback.y, fallback.z});
  return {v[0], v[1], v[2]};
}

}  // namespace brume
