#include "tools/scene_reader/assimp_animation.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "core/number_domain.h"

namespace brume {
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
