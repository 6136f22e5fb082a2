#pragma once

#include <cstdint>
#include <glm/mat4x4.hpp>
#include <span>
#include <vector>

#include "brume/mesh_arrays.h"

namespace brume {

// The state of a mesh that deforms at a time. Between two of them it changes linearly, unless the
// first is held.
struct Pose {
  double time = 0.0;  // [s]
  bool is_held = false;
  std::vector<double> weights{};     // of morph targets
  std::vector<glm::dmat4> joints{};  // affine, from the mesh at rest to where it is
};

Pose mixed(const Pose& a, const Pose& b, double share);

// Offsets of the vertices of a mesh; without normals, those stay.
struct MorphTarget {
  std::vector<glm::vec3> points;
  std::vector<glm::vec3> normals;
};

// A joint that moves a vertex.
struct Influence {
  std::uint32_t joint = 0;
  float weight = 0.0f;  // in [0, 1]; those of a vertex add up to 1
};

// How a mesh deforms: by morph targets, then by the mean of its joints' transforms (linear blend
// skinning).
struct Deformation {
  MeshArrays rest{};  // without normals: those of its triangles, which then share no vertices
  std::vector<MorphTarget> targets{};
  std::vector<Influence> influences{};  // by vertex; empty: the only joint moves all
  std::vector<std::uint32_t> ends{};    // of each vertex, in `influences`
  std::vector<Pose> poses{};            // ascending times, at least one

  [[nodiscard]] std::size_t bytes() const;
};

// Appends the influences on a vertex, at least one, whose weights are > 0 and add up to anything.
void add_vertex(std::span<const Influence> of_vertex, std::vector<Influence>& influences,
                std::vector<std::uint32_t>& ends);

// The mesh in a pose, and at a time [s].
MeshArrays deformed(const Deformation& deformation, const Pose& pose);
MeshArrays deformed(const Deformation& deformation, double time);

}  // namespace brume
