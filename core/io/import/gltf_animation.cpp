#include "core/io/import/gltf_animation.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <utility>

#include "core/io/import/gltf_mesh.h"
#include "core/number_domain.h"

namespace brume {
namespace {

glm::dvec3 to_value(const float* numbers, const glm::dvec3&) {
  return {numbers[0], numbers[1], numbers[2]};
}
glm::dquat to_value(const float* numbers, const glm::dquat&) {
  return {numbers[3], numbers[0], numbers[1], numbers[2]};
}

GltfAnimation no_animation(std::size_t nodes) {
  GltfAnimation none;
  none.tracks.resize(nodes);
  none.weights.resize(nodes);
  return none;
}

class Animation {
 public:
  // Both outlive this.
  Animation(GltfFile& file, JsonObject& object)
      : file_(file),
        object_(object),
        samplers_(object_.array("samplers", max_elements)),
        channels_(object_.array("channels", max_elements)) {}

  GltfAnimation read(const std::vector<GltfNode>& nodes) {
    std::map<std::size_t, std::size_t> index_of;  // of elements
    for (std::size_t i = 0; i < nodes.size(); ++i) index_of[nodes[i].element] = i;
    GltfAnimation result = no_animation(nodes.size());
    for (std::size_t i = 0; i < channels_.size(); ++i) {
      JsonObject channel(file_.context(), channels_[i], object_.path_of("channels").element(i));
      JsonObject target = channel.object("target");
      const auto element = file_.index(target, "node", "nodes");
      const auto node = element ? index_of.find(*element) : index_of.end();
      if (node == index_of.end()) continue;
      read_channel(channel, target, result.tracks[node->second], result.weights[node->second]);
    }
    return result;
  }

 private:
  static constexpr std::size_t max_elements = 1 << 20;

  void read_channel(JsonObject& channel, JsonObject& target, NodeTracks& tracks,
                    std::shared_ptr<const Track<MorphWeights>>& weights) {
    const std::string path = target.text("path", "");
    if (path == "translation") {
      read_track(channel, vectors_, 3, tracks.translation);
    } else if (path == "rotation") {
      read_track(channel, quaternions_, 4, tracks.rotation);
    } else if (path == "scale") {
      read_track(channel, vectors_, 3, tracks.scale);
    } else if (path == "weights") {
      const std::size_t sampler = sampler_of(channel);
      auto& found = weights_[sampler];
      if (!found) found = read_weights(sampler);
      weights = found;
    } else {
      file_.context().warn(target.path_of("path"),
                           "animations of " + quoted_text(path) + " are left out");
    }
  }

  std::size_t sampler_of(JsonObject& channel) {
    static_cast<void>(channel.required("sampler"));
    if (samplers_.empty()) channel.fail("sampler", "refers to samplers; the animation has none");
    return static_cast<std::size_t>(
        channel.integer("sampler", 0, static_cast<std::int64_t>(samplers_.size()) - 1, 0));
  }

  template <class T>
  using Known = std::map<std::size_t, std::shared_ptr<const Track<T>>>;  // by sampler

  template <class T>
  void read_track(JsonObject& channel, Known<T>& known, std::size_t components,
                  std::shared_ptr<const Track<T>>& track) {
    const std::size_t index = sampler_of(channel);
    auto& found = known[index];
    if (!found) found = std::make_shared<const Track<T>>(read_sampler<T>(index, components));
    track = found;
  }

  template <class T>
  Track<T> read_sampler(std::size_t index, std::size_t components) {
    JsonObject sampler(file_.context(), samplers_[index],
                       object_.path_of("samplers").element(index));
    Track<T> track;
    track.interpolation = interpolation_of(sampler);
    track.times = read_times(sampler);
    const std::vector<float> values = numbers(sampler, "output", components);
    const std::size_t count = values_per_time(track.interpolation) * track.times.size();
    if (values.size() != components * count) {
      sampler.fail("output", "found " + std::to_string(values.size() / components) +
                                 " values for " + std::to_string(track.times.size()) +
                                 " times; allowed: " + std::to_string(count));
    }
    for (std::size_t i = 0; i < values.size(); i += components) {
      track.values.push_back(to_value(&values[i], T()));
    }
    return track;
  }

  static TrackInterpolation interpolation_of(JsonObject& sampler) {
    const std::string name = sampler.text("interpolation", "LINEAR");
    if (name == "STEP") return TrackInterpolation::step;
    if (name == "CUBICSPLINE") return TrackInterpolation::cubic;
    if (name != "LINEAR") {
      sampler.fail("interpolation",
                   "found " + quoted_text(name) + "; allowed: LINEAR, STEP, CUBICSPLINE");
    }
    return TrackInterpolation::linear;
  }
  static std::size_t values_per_time(TrackInterpolation interpolation) {
    return interpolation == TrackInterpolation::cubic ? 3 : 1;
  }

  std::vector<double> read_times(JsonObject& sampler) {
    std::vector<double> times;
    for (const float time : numbers(sampler, "input", 1)) {
      const auto seconds = static_cast<double>(time);
      if (!domain::seconds.contains(seconds)) {
        sampler.fail("input", domain::seconds.refusal(seconds));
      }
      if (!times.empty() && !(seconds > times.back())) {
        sampler.fail("input", "found the time " + quoted_text(seconds) + " after " +
                                  quoted_text(times.back()) + "; allowed: ascending times");
      }
      times.push_back(seconds);
    }
    return times;
  }

  // Null where there are no morph targets.
  std::shared_ptr<const Track<MorphWeights>> read_weights(std::size_t index) {
    JsonObject sampler(file_.context(), samplers_[index],
                       object_.path_of("samplers").element(index));
    auto track = std::make_shared<Track<MorphWeights>>();
    track->interpolation = interpolation_of(sampler);
    track->times = read_times(sampler);
    const std::vector<float> values = numbers(sampler, "output", 1);
    const std::size_t count = values_per_time(track->interpolation) * track->times.size();
    const std::size_t targets = values.size() / count;
    if (values.size() != targets * count) {
      sampler.fail("output", "found " + std::to_string(values.size()) + " values for " +
                                 std::to_string(track->times.size()) +
                                 " times; allowed: as many for each");
    }
    for (std::size_t i = 0; i < values.size(); i += targets) {
      MorphWeights& weights = track->values.emplace_back(targets);
      std::copy_n(&values[i], targets, std::begin(weights));
    }
    return targets > 0 ? track : nullptr;
  }

  std::vector<float> numbers(JsonObject& sampler, const char* key, std::size_t components) {
    static_cast<void>(sampler.required(key));
    std::vector<float> values =
        file_.numbers(sampler.path_of(key), *file_.index(sampler, key, "accessors"), components);
    for (const float value : values) {
      if (domain::coordinate.contains(static_cast<double>(value))) continue;
      sampler.fail(key, domain::coordinate.refusal(static_cast<double>(value)));
    }
    return values;
  }

  GltfFile& file_;
  JsonObject& object_;
  const Json::array_t& samplers_;
  const Json::array_t& channels_;
  Known<glm::dvec3> vectors_;
  Known<glm::dquat> quaternions_;
  Known<MorphWeights> weights_;
};

}  // namespace

GltfAnimation read_gltf_animation(GltfFile& file, const std::vector<GltfNode>& nodes) {
  const std::size_t count = file.list("animations").size();
  if (count == 0) return no_animation(nodes.size());
  if (count > 1) {
    file.context().warn(file.path().member("animations"),
                        "found " + std::to_string(count) + "; all but the first are left out");
  }
  JsonObject first = file.object("animations", 0);
  return Animation(file, first).read(nodes);
}

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
