#include "core/io/import/gltf_skin.h"

#include <algorithm>
#include <cmath>
#include <glm/matrix.hpp>
#include <string>
#include <utility>

#include "core/io/import/gltf_mesh.h"
#include "core/io/import/node_transform.h"

namespace brume {
namespace {

// Four joints of each vertex and their weights: the attributes JOINTS_n and WEIGHTS_n.
struct Influences {
  std::vector<glm::vec4> joints;
  std::vector<glm::vec4> weights;
};

std::vector<Influences> read_influences(GltfFile& file, JsonObject& attributes,
                                        std::size_t vertices) {
  std::vector<Influences> sets;
  const auto values = [&](const std::string& key) {
    auto vectors = gltf_vectors<glm::vec4>(file, attributes, key);
    check_value_count(attributes, key, vectors.size(), vertices);
    return vectors;
  };
  for (;;) {
    const std::string set = std::to_string(sets.size());
    Influences influences{values("JOINTS_" + set), values("WEIGHTS_" + set)};
    if (influences.joints.empty() || influences.weights.empty()) return sets;
    sets.push_back(std::move(influences));
  }
}

// The mean of the matrices of a vertex, whatever its weights add up to; without any, its first
// joint has all. Joints without weight need not exist.
glm::dmat4 mean_matrix(JsonObject& attributes, const std::vector<glm::dmat4>& joints,
                       const std::vector<Influences>& sets, std::size_t vertex) {
  glm::dmat4 sum(0.0);
  double sum_of_weights = 0.0;
  const auto add = [&](std::size_t set, int k, double weight) {
    const float joint = sets[set].joints[vertex][k];
    if (!(joint >= 0.0f && joint < static_cast<float>(joints.size()))) {
      attributes.fail("JOINTS_" + std::to_string(set),
                      "vertex " + std::to_string(vertex) + ": found the joint " +
                          quoted_text(static_cast<double>(joint)) + "; allowed: 0 to " +
                          std::to_string(joints.size() - 1));
    }
    sum += weight * joints[static_cast<std::size_t>(joint)];
    sum_of_weights += weight;
  };
  for (std::size_t set = 0; set < sets.size(); ++set) {
    for (int k = 0; k < 4; ++k) {
      const float weight = sets[set].weights[vertex][k];
      if (weight > 0.0f && std::isfinite(weight)) add(set, k, static_cast<double>(weight));
    }
  }
  if (sum_of_weights == 0.0) add(0, 0, 1.0);
  return sum / sum_of_weights;
}

}  // namespace

const std::vector<glm::dmat4>* GltfSkins::joints(JsonObject& node) {
  const auto skin = file_.index(node, "skin", "skins");
  if (!skin) return nullptr;
  const auto known = skins_.find(*skin);
  const auto& matrices =
      known != skins_.end()
          ? known->second
          : skins_.try_emplace(*skin, read(*skin, node.path_of("skin"))).first->second;
  return matrices.empty() ? nullptr : &matrices;
}

// Empty if there is a joint that is not in the scene.
std::vector<glm::dmat4> GltfSkins::read(std::size_t skin, const JsonPath& user) {
  JsonObject object = file_.object("skins", skin);
  const std::vector<std::size_t> joints = gltf_node_indices(file_, object, "joints");
  if (joints.empty()) object.fail("joints", "missing");
  std::vector<float> inverse_binds;
  if (const auto accessor = file_.index(object, "inverseBindMatrices", "accessors")) {
    inverse_binds = file_.numbers(object.path_of("inverseBindMatrices"), *accessor, 16);
    if (inverse_binds.size() < 16 * joints.size()) {
      object.fail("inverseBindMatrices", "found " + std::to_string(inverse_binds.size() / 16) +
                                             " matrices for " + std::to_string(joints.size()) +
                                             " joints");
    }
  }
  std::map<std::size_t, const glm::dmat4*> to_world;
  for (const GltfNode& node : nodes_) to_world[node.element] = &node.to_world;
  std::vector<glm::dmat4> matrices;
  for (std::size_t i = 0; i < joints.size(); ++i) {
    const auto node = to_world.find(joints[i]);
    if (node == to_world.end()) {
      file_.context().warn(user,
                           "has joints that are not in the scene: the mesh is shown as it is "
                           "without its skin");
      return {};
    }
    glm::dmat4 inverse_bind(1.0);
    for (int k = 0; k < 16 && !inverse_binds.empty(); ++k) {
      inverse_bind[k / 4][k % 4] =
          static_cast<double>(inverse_binds[16 * i + static_cast<std::size_t>(k)]);
    }
    matrices.push_back(*node->second * inverse_bind);
  }
  return matrices;
}

bool apply_skin(GltfFile& file, JsonObject& attributes, const std::vector<glm::dmat4>& joints,
                MeshArrays& mesh) {
  const std::vector<Influences> sets = read_influences(file, attributes, mesh.points.size());
  if (sets.empty()) return false;
  std::vector<bool> is_mirrored(mesh.points.size());
  std::vector<glm::vec3> points = mesh.points;  // `mesh` stays as it is should there be a mistake
  std::vector<glm::vec3> normals = mesh.normals;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const glm::dmat4 matrix = mean_matrix(attributes, joints, sets, i);
    points[i] = glm::dvec3(matrix * glm::dvec4(points[i], 1.0));
    const glm::dmat3 linear(matrix);
    is_mirrored[i] = glm::determinant(linear) < 0.0;
    if (!normals.empty()) normals[i] = moved_normal(linear, normals[i]);
  }
  mesh.points = std::move(points);
  mesh.normals = std::move(normals);
  for (glm::uvec3& triangle : mesh.triangles) {
    if (is_mirrored[triangle.x]) std::swap(triangle.y, triangle.z);
  }
  return true;
}

}  // namespace brume
