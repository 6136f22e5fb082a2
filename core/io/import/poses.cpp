#include "core/io/import/poses.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <iterator>

#include "brume/error.h"
#include "core/io/import/sampler.h"

namespace brume {
namespace {

// Bounds the way of vertices from one pose to another.
struct Extent {
  std::array<glm::dvec3, 8> corners;  // around the vertices, morphed ones too
  std::vector<double> targets;        // the longest offset by each target
};

Extent extent_of(const Deformation& deformation, const DeformationMotion& motion,
                 const NodeMotion& nodes) {
  Extent extent;
  double greatest = 0.0;  // offset
  for (std::size_t i = 0; i < deformation.targets.size(); ++i) {
    double length = 0.0;
    for (const glm::vec3& offset : deformation.targets[i].points) {
      nodes.check_coordinates(offset);
      length = std::max(length, glm::length(glm::dvec3(offset)));
    }
    extent.targets.push_back(length);
    double weight = i < motion.weights.size() ? std::abs(motion.weights[i]) : 0.0;
    if (motion.track && length > 0.0 && i < motion.track->values.front().size()) {
      for (const MorphWeights& weights : motion.track->values) {
        weight = std::max(weight, std::abs(weights[i]));
      }
    }
    greatest += weight * length;
  }
  glm::dvec3 low(deformation.rest.points.front());
  glm::dvec3 high = low;
  for (const glm::vec3& point : deformation.rest.points) {
    low = glm::min(low, glm::dvec3(point));
    high = glm::max(high, glm::dvec3(point));
  }
  low -= greatest;
  high += greatest;
  for (unsigned i = 0; i < extent.corners.size(); ++i) {
    extent.corners[i] = {i & 1 ? high.x : low.x, i & 2 ? high.y : low.y, i & 4 ? high.z : low.z};
  }
  return extent;
}

// Linear between poses, as vertices are then.
struct PoseMeasure {
  const Extent& extent;
  double allowed;  // offset of a vertex

  [[nodiscard]] static Pose mixed(const Pose& a, const Pose& b, double share) {
    return brume::mixed(a, b, share);
  }
  [[nodiscard]] double distance(const Pose& a, const Pose& b) const {
    double greatest = 0.0;
    for (std::size_t i = 0; i < a.joints.size(); ++i) {
      const glm::dmat4 difference = a.joints[i] - b.joints[i];
      for (const glm::dvec3& corner : extent.corners) {
        greatest =
            std::max(greatest, glm::length(glm::dvec3(difference * glm::dvec4(corner, 1.0))));
      }
    }
    const std::size_t count = std::min(a.weights.size(), extent.targets.size());
    for (std::size_t i = 0; i < count; ++i) {
      greatest = std::max(greatest, std::abs(a.weights[i] - b.weights[i]) * extent.targets[i]);
    }
    return greatest / allowed;
  }
};

std::vector<double> times_of(const DeformationMotion& motion, const NodeMotion& nodes) {
  std::vector<double> times;
  const auto add = [&](const std::vector<double>& others) {
    std::vector<double> all;
    std::ranges::set_union(times, others, std::back_inserter(all));
    times = std::move(all);
  };
  for (const Joint& joint : motion.joints) {
    if (joint.node && nodes.moves(*joint.node)) add(nodes.times(*joint.node));
  }
  if (motion.track) add(motion.track->times);
  return times;
}

}  // namespace

Pose pose_at(const DeformationMotion& motion, const NodeMotion& nodes, double time) {
  Pose pose{.time = time};
  const MorphWeights weights = motion.track ? value_at(*motion.track, time) : motion.weights;
  pose.weights.assign(std::begin(weights), std::end(weights));
  std::vector<std::size_t> moving;
  for (const Joint& joint : motion.joints) {
    if (joint.node) moving.push_back(*joint.node);
  }
  const std::vector<glm::dmat4> transforms = nodes.to_world(moving, time);
  auto to_world = transforms.begin();
  for (const Joint& joint : motion.joints) {
    pose.joints.push_back(joint.node ? *to_world++ * joint.to_node : joint.to_node);
  }
  return pose;
}

std::shared_ptr<const Deformation> moving_deformation(Deformation deformation,
                                                      const DeformationMotion& motion,
                                                      const NodeMotion& nodes) {
  const std::vector<double> times = times_of(motion, nodes);
  if (times.empty()) return nullptr;
  const Extent extent = extent_of(deformation, motion, nodes);
  // The poses of one mesh take 2 GB at most.
  constexpr std::size_t max_transforms = std::size_t{1} << 24;
  std::size_t transforms = 0;
  const auto state_at = [&](double time) {
    constexpr std::size_t weights_per_transform = 16;  // by their bytes
    transforms += 1 + motion.joints.size() + extent.targets.size() / weights_per_transform;
    if (transforms > max_transforms) {
      throw InputError(nodes.file(), "", "the animation of its joints takes too long");
    }
    Pose pose = pose_at(motion, nodes, time);
    // Cubic curves of weights go beyond their keys.
    double morphed = 0.0;
    for (std::size_t i = 0; i < std::min(pose.weights.size(), extent.targets.size()); ++i) {
      morphed += std::abs(pose.weights[i]) * extent.targets[i];
    }
    nodes.check_coordinates(glm::dvec3(morphed));
    for (const glm::dmat4& joint : pose.joints) {
      for (const glm::dvec3& corner : extent.corners) {
        nodes.check_coordinates(glm::dvec3(joint * glm::dvec4(corner, 1.0)));
      }
    }
    return pose;
  };
  // The largest at some of the times counts: what is hidden is often scaled to nothing at first.
  constexpr std::size_t max_sizes = 64;
  double size = 0.0;
  for (std::size_t k = 0; k < times.size(); k += 1 + (times.size() - 1) / max_sizes) {
    for (const glm::dmat4& joint : state_at(times[k]).joints) {
      const glm::dvec3 diagonal = extent.corners.back() - extent.corners.front();
      size = std::max(size, glm::length(glm::dmat3(joint) * diagonal));
    }
  }
  constexpr double rounding = 1e-9;
  const PoseMeasure measure{extent, max_share * size + rounding};
  std::vector<Pose>& poses = deformation.poses;
  for (Sample<Pose>& sample : Sampler(state_at, measure, nodes.file()).run(times)) {
    sample.state.is_held = sample.is_held;
    poses.push_back(std::move(sample.state));
  }
  const bool is_constant = std::ranges::all_of(poses, [&](const Pose& pose) {
    return pose.weights == poses.front().weights && pose.joints == poses.front().joints;
  });
  return is_constant ? nullptr : std::make_shared<const Deformation>(std::move(deformation));
}

}  // namespace brume
