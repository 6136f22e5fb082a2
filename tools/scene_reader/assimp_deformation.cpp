#include "tools/scene_reader/assimp_deformation.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <set>
#include <span>
#include <string_view>

#include "core/number_domain.h"

namespace brume {
namespace {

// The importer names it NODE*0, of the node's first geometry.
const aiMeshMorphAnim* morph_channel(const aiScene& scene, const aiNode& node) {
  if (scene.mNumAnimations == 0) return nullptr;
  const aiAnimation& animation = *scene.mAnimations[0];
  const std::string begin = std::string(node.mName.C_Str()) + "*";
  for (const aiMeshMorphAnim* channel :
       std::span(animation.mMorphMeshChannels, animation.mNumMorphMeshChannels)) {
    if (std::string_view(channel->mName.C_Str()).starts_with(begin)) return channel;
  }
  return nullptr;
}

double weight_at(const std::map<double, double>& keys, double time) {
  if (keys.empty()) return 0.0;
  const auto next = keys.upper_bound(time);
  if (next == keys.begin()) return next->second;
  const auto last = std::prev(next);
  if (next == keys.end()) return last->second;
  const double share = (time - last->first) / (next->first - last->first);
  return std::lerp(last->second, next->second, share);
}

// None where a target is not one of this mesh.
MorphTarget offsets(const aiAnimMesh& target, const aiMesh& mesh) {
  MorphTarget result;
  if (target.mNumVertices != mesh.mNumVertices || !target.HasPositions()) return result;
  const bool has_normals = target.HasNormals() && mesh.HasNormals();
  for (unsigned i = 0; i < mesh.mNumVertices; ++i) {
    const auto add = [](const aiVector3D& offset, std::vector<glm::vec3>& list) {
      list.emplace_back(offset.x, offset.y, offset.z);
    };
    add(target.mVertices[i] - mesh.mVertices[i], result.points);
    if (has_normals) add(target.mNormals[i] - mesh.mNormals[i], result.normals);
  }
  return result;
}

}  // namespace

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
  const auto joint_of_node = static_cast<std::uint32_t>(joints.size());
  joints.push_back({node});
  for (std::vector<Influence>& of_vertex : influences) {
    if (of_vertex.empty()) of_vertex.push_back({joint_of_node, 1.0f});
    add_vertex(of_vertex, deformation.influences, deformation.ends);
  }
  return joints;
}

std::shared_ptr<const Track<MorphWeights>> read_morph(const aiScene& scene, const aiMesh& mesh,
                                                      const aiNode& node,
                                                      Deformation& deformation) {
  const aiMeshMorphAnim* const channel = morph_channel(scene, node);
  if (channel == nullptr) return nullptr;
  const std::span targets(mesh.mAnimMeshes, mesh.mNumAnimMeshes);
  // Each target has keys of its own.
  std::vector<std::map<double, double>> weights(targets.size());
  std::set<double> times;
  const double ticks = ticks_per_second(*scene.mAnimations[0]);
  for (const aiMeshMorphKey& key : std::span(channel->mKeys, channel->mNumKeys)) {
    const double time = key.mTime / ticks;
    if (!domain::seconds.contains(time)) continue;
    for (unsigned i = 0; i < key.mNumValuesAndWeights; ++i) {
      const double weight = key.mWeights[i];
      if (key.mValues[i] >= weights.size() || !domain::coordinate.contains(weight)) continue;
      weights[key.mValues[i]][time] = weight;
      times.insert(time);
    }
  }
  if (times.empty()) return nullptr;
  auto track = std::make_shared<Track<MorphWeights>>();
  for (const double time : times) {
    track->times.push_back(time);
    MorphWeights& values = track->values.emplace_back(weights.size());
    for (std::size_t i = 0; i < weights.size(); ++i) values[i] = weight_at(weights[i], time);
  }
  for (const aiAnimMesh* target : targets) deformation.targets.push_back(offsets(*target, mesh));
  return track;
}

namespace {

glm::dvec3 to_value(const aiVector3D& v) {
  return {v.x, v.y, v.z};
}
glm::dquat to_value(const aiQuaternion& q) {
  return {q.w, q.x, q.y, q.z};
}

bool is_valid(const glm::dvec3& v) {
  return domain::coordinate.contains(v.x) && domain::coordinate.contains(v.y) &&
         domain::coordinate.contains(v.z);
}
bool is_valid(const glm::dquat& q) {
  const double length = glm::length(q);
  return length > 0.0 && domain::coordinate.contains(length);
}

// The keys of a channel that have numbers and follow each other. What is always the same is `value`
// instead.
template <class T, class Key>
std::shared_ptr<const Track<T>> track_of(const Key* keys, unsigned count, double ticks, T& value) {
  auto track = std::make_shared<Track<T>>();
  for (const Key& key : std::span(keys, count)) {
    const double time = key.mTime / ticks;
    const T found = to_value(key.mValue);
    if (!domain::seconds.contains(time) || !is_valid(found) ||
        (!track->times.empty() && !(time > track->times.back()))) {
      continue;
    }
    track->times.push_back(time);
    track->values.push_back(found);
  }
  if (track->times.empty()) return nullptr;
  value = track->values.front();
  const bool is_constant = std::ranges::all_of(
      track->values, [&](const T& other) { return other == track->values.front(); });
  return is_constant ? nullptr : track;
}

}  // namespace

double ticks_per_second(const aiAnimation& animation) {
  constexpr double usual_ticks = 25.0;  // assimp's
  return animation.mTicksPerSecond > 0.0 ? animation.mTicksPerSecond : usual_ticks;
}

void add_tracks(const aiScene& scene, const std::map<std::string, std::size_t>& names,
                std::vector<MovingNode>& nodes) {
  if (scene.mNumAnimations == 0) return;
  const aiAnimation& animation = *scene.mAnimations[0];
  const double ticks = ticks_per_second(animation);
  for (const aiNodeAnim* channel : std::span(animation.mChannels, animation.mNumChannels)) {
    const auto found = names.find(channel->mNodeName.C_Str());
    if (found == names.end() || found->second == 0) continue;
    MovingNode& node = nodes[found->second];
    NodeTransform& rest = node.transform;
    node.tracks = {
        track_of(channel->mPositionKeys, channel->mNumPositionKeys, ticks, rest.translation),
        track_of(channel->mRotationKeys, channel->mNumRotationKeys, ticks, rest.rotation),
        track_of(channel->mScalingKeys, channel->mNumScalingKeys, ticks, rest.scale)};
    rest.rotation = glm::normalize(rest.rotation);
    node.at_rest = rest.matrix();
  }
}

}  // namespace brume
