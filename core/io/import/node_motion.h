#pragma once

#include <cstddef>
#include <filesystem>
#include <glm/gtc/quaternion.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <memory>
#include <optional>
#include <span>
#include <valarray>
#include <vector>

namespace brume {

// Interpolation between the times of a track, as glTF has it.
enum class TrackInterpolation { linear, step, cubic };

// A value of a node over time, constant before its first time and after its last.
template <class T>
struct Track {
  std::vector<double> times;  // ascending, at least one [s]
  std::vector<T> values;  // as many; `cubic`: three each, tangents before and after it around it
  TrackInterpolation interpolation = TrackInterpolation::linear;
};

// The weights of morph targets, in their order.
using MorphWeights = std::valarray<double>;
MorphWeights value_at(const Track<MorphWeights>& track, double time);

// The transform of a node within its parent: points are scaled first, moved last. Values without a
// track are as at rest.
struct NodeTransform {
  glm::dvec3 translation{0.0};
  glm::dquat rotation{1.0, 0.0, 0.0, 0.0};  // unit
  glm::dvec3 scale{1.0};

  [[nodiscard]] glm::dmat4 matrix() const;
};
struct NodeTracks {
  std::shared_ptr<const Track<glm::dvec3>> translation{};  // null: none
  std::shared_ptr<const Track<glm::dquat>> rotation{};
  std::shared_ptr<const Track<glm::dvec3>> scale{};

  [[nodiscard]] bool has_any() const { return translation || rotation || scale; }
};

// A node of a tree of them, and how it moves within its parent.
struct MovingNode {
  std::optional<std::size_t> parent{};  // an earlier node
  glm::dmat4 at_rest{1.0};              // where it has no tracks
  NodeTransform transform{};            // where it has
  NodeTracks tracks{};
};

// The nodes of a scene over time.
class NodeMotion {
 public:
  // The file is for errors.
  NodeMotion(const std::filesystem::path& file, std::vector<MovingNode> nodes);

  [[nodiscard]] const std::filesystem::path& file() const { return file_; }
  // Whether a node or one that it is in has a track.
  [[nodiscard]] bool moves(std::size_t node) const { return moves_[node]; }
  // Throws InputError where that has taken too long in all.
  [[nodiscard]] glm::dmat4 to_world(std::size_t node, double time) const;
  // The same of several, of which each ancestor is evaluated once.
  [[nodiscard]] std::vector<glm::dmat4> to_world(std::span<const std::size_t> nodes,
                                                 double time) const;
  // Throws InputError unless a point that an animation moves is one of a scene.
  void check_coordinates(const glm::dvec3& point) const;
  // The times of the tracks of a node and of those that it is in, ascending; none twice.
  [[nodiscard]] std::vector<double> times(std::size_t node) const;

 private:
  [[nodiscard]] glm::dmat4 to_parent(std::size_t node, double time) const;
  void count(std::size_t steps) const;

  std::filesystem::path file_;
  std::vector<MovingNode> nodes_;
  std::vector<bool> moves_;
  mutable std::size_t steps_ = 0;
};

}  // namespace brume
