#include "core/io/import/gltf_skin.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "core/io/import/gltf_mesh.h"

namespace brume {
namespace {

// Four joints of each vertex and their weights: the attributes JOINTS_n and WEIGHTS_n.
struct Influences {
  std::vector<glm::vec4> joints;
  std::vector<glm::vec4> weights;
};

std::vector<Influences> read_influences(GltfFile& file, JsonObject& attributes,
                                        std::size_t vertices) {
  // Vertices have four joints each of a set, seldom more than eight; files may name one array in
  // hundreds of sets.
  constexpr std::size_t max_sets = 8;
  std::vector<Influences> sets;
  const auto values = [&](const std::string& key) {
    auto vectors = gltf_vectors<glm::vec4>(file, attributes, key);
    check_value_count(attributes, key, vectors.size(), vertices);
    return vectors;
  };
  while (sets.size() < max_sets) {
    const std::string set = std::to_string(sets.size());
    Influences influences{values("JOINTS_" + set), values("WEIGHTS_" + set)};
    if (influences.joints.empty() || influences.weights.empty()) break;
    sets.push_back(std::move(influences));
  }
  return sets;
}

// Throws unless an influence is by one of the joints.
Influence influence_of(JsonObject& attributes, const std::vector<Influences>& sets,
                       std::size_t joints, std::size_t vertex, std::size_t set, int k) {
  const float joint = sets[set].joints[vertex][k];
  if (!(joint >= 0.0f && joint < static_cast<float>(joints))) {
    attributes.fail("JOINTS_" + std::to_string(set),
                    "vertex " + std::to_string(vertex) + ": found the joint " +
                        quoted_text(static_cast<double>(joint)) + "; allowed: 0 to " +
                        std::to_string(joints - 1));
  }
  return {static_cast<std::uint32_t>(joint), sets[set].weights[vertex][k]};
}

}  // namespace

const std::vector<Joint>* GltfSkins::joints(JsonObject& node) {
  const auto skin = file_.index(node, "skin", "skins");
  if (!skin) return nullptr;
  const auto known = skins_.find(*skin);
  const auto& joints =
      known != skins_.end()
          ? known->second
          : skins_.try_emplace(*skin, read(*skin, node.path_of("skin"))).first->second;
  return joints.empty() ? nullptr : &joints;
}

// Empty if there is a joint that is not in the scene.
std::vector<Joint> GltfSkins::read(std::size_t skin, const JsonPath& user) {
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
  std::map<std::size_t, std::size_t> index_of;  // of elements
  for (std::size_t i = 0; i < nodes_.size(); ++i) index_of[nodes_[i].element] = i;
  std::vector<Joint> result;
  for (std::size_t i = 0; i < joints.size(); ++i) {
    const auto node = index_of.find(joints[i]);
    if (node == index_of.end()) {
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
    result.push_back({node->second, inverse_bind});
  }
  return result;
}

void read_gltf_influences(GltfFile& file, JsonObject& attributes, std::size_t joints,
                          Deformation& deformation) {
  const std::size_t vertices = deformation.rest.points.size();
  const std::vector<Influences> sets = read_influences(file, attributes, vertices);
  std::vector<Influence> influences;
  std::vector<std::uint32_t> ends;
  std::vector<Influence> of_vertex;
  for (std::size_t vertex = 0; vertex < vertices && !sets.empty(); ++vertex) {
    of_vertex.clear();
    for (std::size_t set = 0; set < sets.size(); ++set) {
      for (int k = 0; k < 4; ++k) {
        const float weight = sets[set].weights[vertex][k];
        if (!(weight > 0.0f && std::isfinite(weight))) continue;
        of_vertex.push_back(influence_of(attributes, sets, joints, vertex, set, k));
      }
    }
    if (of_vertex.empty()) {
      of_vertex.push_back(influence_of(attributes, sets, joints, vertex, 0, 0));
      of_vertex.back().weight = 1.0f;
    }
    add_vertex(of_vertex, influences, ends);
  }
  deformation.influences = std::move(influences);
  deformation.ends = std::move(ends);
}

}  // namespace brume
