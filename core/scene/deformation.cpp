#include "core/scene/deformation.h"

#include <algorithm>
#include <glm/matrix.hpp>
#include <utility>

#include "core/math/normals.h"
#include "core/scene/mesh.h"

namespace brume {
namespace {

// The offsets of a vertex by all targets.
glm::dvec3 offset(const Deformation& deformation, const std::vector<double>& weights,
                  std::vector<glm::vec3> MorphTarget::*values, std::size_t vertex) {
  glm::dvec3 sum(0.0);
  const std::size_t count = std::min(weights.size(), deformation.targets.size());
  for (std::size_t i = 0; i < count; ++i) {
    const std::vector<glm::vec3>& offsets = deformation.targets[i].*values;
    if (weights[i] != 0.0 && !offsets.empty()) sum += weights[i] * glm::dvec3(offsets[vertex]);
  }
  return sum;
}

glm::dmat4 mean_joint(const Deformation& deformation, const std::vector<glm::dmat4>& joints,
                      std::size_t vertex) {
  if (deformation.influences.empty()) return joints.front();
  glm::dmat4 sum(0.0);
  for (std::size_t i = vertex > 0 ? deformation.ends[vertex - 1] : 0; i < deformation.ends[vertex];
       ++i) {
    const Influence& influence = deformation.influences[i];
    sum += static_cast<double>(influence.weight) * joints[influence.joint];
  }
  return sum;
}

Pose pose_at(const std::vector<Pose>& poses, double time) {
  const auto next = std::ranges::upper_bound(poses, time, {}, &Pose::time);
  if (next == poses.begin()) return poses.front();
  const Pose& last = *(next - 1);
  if (next == poses.end() || last.is_held) return last;
  return mixed(last, *next, (time - last.time) / (next->time - last.time));
}

}  // namespace

void add_vertex(std::span<const Influence> of_vertex, std::vector<Influence>& influences,
                std::vector<std::uint32_t>& ends) {
  double sum = 0.0;
  for (const Influence& influence : of_vertex) sum += static_cast<double>(influence.weight);
  for (const Influence& influence : of_vertex) {
    const double share = static_cast<double>(influence.weight) / sum;
    influences.push_back({influence.joint, static_cast<float>(share)});
  }
  ends.push_back(static_cast<std::uint32_t>(influences.size()));
}

Pose mixed(const Pose& a, const Pose& b, double share) {
  Pose pose = a;
  for (std::size_t i = 0; i < pose.weights.size(); ++i) {
    pose.weights[i] += share * (b.weights[i] - a.weights[i]);
  }
  for (std::size_t i = 0; i < pose.joints.size(); ++i) {
    pose.joints[i] += share * (b.joints[i] - a.joints[i]);
  }
  return pose;
}

std::size_t Deformation::bytes() const {
  std::size_t bytes =
      mesh_bytes(rest) + std::span(influences).size_bytes() + std::span(ends).size_bytes();
  for (const MorphTarget& target : targets) {
    bytes += std::span(target.points).size_bytes() + std::span(target.normals).size_bytes();
  }
  for (const Pose& pose : poses) {
    bytes += std::span(pose.weights).size_bytes() + std::span(pose.joints).size_bytes();
  }
  return bytes;
}

MeshArrays deformed(const Deformation& deformation, double time) {
  return deformed(deformation, pose_at(deformation.poses, time));
}

MeshArrays deformed(const Deformation& deformation, const Pose& pose) {
  MeshArrays mesh = deformation.rest;
  std::vector<bool> is_mirrored(mesh.points.size());
  for (std::size_t i = 0; i < mesh.points.size(); ++i) {
    const glm::dmat4 matrix = mean_joint(deformation, pose.joints, i);
    const glm::dvec3 point =
        glm::dvec3(mesh.points[i]) + offset(deformation, pose.weights, &MorphTarget::points, i);
    mesh.points[i] = glm::dvec3(matrix * glm::dvec4(point, 1.0));
    const glm::dmat3 linear(matrix);
    is_mirrored[i] = glm::determinant(linear) < 0.0;
    if (mesh.normals.empty()) continue;
    const glm::dvec3 normal =
        glm::dvec3(mesh.normals[i]) + offset(deformation, pose.weights, &MorphTarget::normals, i);
    mesh.normals[i] = moved_normal(linear, normal);
  }
  for (glm::uvec3& triangle : mesh.triangles) {
    if (is_mirrored[triangle.x]) std::swap(triangle.y, triangle.z);
  }
  if (mesh.normals.empty()) {
    add_flat_normals(mesh);
  } else {
    complete_normals(mesh);
  }
  return mesh;
}

}  // namespace brume
