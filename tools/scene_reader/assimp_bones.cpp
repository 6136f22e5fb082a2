#include "tools/scene_reader/assimp_bones.h"

#include <cmath>
#include <span>

namespace brume {

glm::dmat4 to_dmat4(const aiMatrix4x4& m) {  // which has rows
  glm::dmat4 result;
  for (unsigned row = 0; row < 4; ++row) {
    for (unsigned column = 0; column < 4; ++column) {
      result[static_cast<int>(column)][static_cast<int>(row)] = static_cast<double>(m[row][column]);
    }
  }
  return result;
}

std::vector<Joint> read_bones(const aiMesh& mesh, const std::map<std::string, std::size_t>& names,
                              std::size_t node, Deformation& deformation) {
  std::vector<Joint> joints;
  std::vector<std::vector<Influence>> influences(mesh.mNumVertices);
  for (const aiBone* bone : std::span(mesh.mBones, mesh.mNumBones)) {
    const auto found = names.find(bone->mName.C_Str());
    if (found == names.end()) continue;
    const auto joint = static_cast<std::uint32_t>(joints.size());
    joints.push_back({found->second, to_dmat4(bone->mOffsetMatrix)});
    for (const aiVertexWeight& weight : std::span(bone->mWeights, bone->mNumWeights)) {
      if (weight.mVertexId < mesh.mNumVertices && weight.mWeight > 0.0f &&
          std::isfinite(weight.mWeight)) {
        influences[weight.mVertexId].push_back({joint, weight.mWeight});
      }
    }
  }
  const auto own = static_cast<std::uint32_t>(joints.size());
  joints.push_back({node});
  for (std::vector<Influence>& of_vertex : influences) {
    if (of_vertex.empty()) of_vertex.push_back({own, 1.0f});
    float sum = 0.0f;
    for (const Influence& influence : of_vertex) sum += influence.weight;
    for (const Influence& influence : of_vertex) {
      deformation.influences.push_back({influence.joint, influence.weight / sum});
    }
    deformation.ends.push_back(static_cast<std::uint32_t>(deformation.influences.size()));
  }
  return joints;
}

}  // namespace brume
