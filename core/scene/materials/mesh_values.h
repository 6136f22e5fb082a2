#pragma once

#include <array>
#include <cstddef>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "brume/mesh_arrays.h"
#include "brume/metallic_roughness.h"

namespace brume {

// The values of a mesh at a point, for its material.
struct MeshValues {
  // A place in textures, which are averaged over a square of side `footprint` there.
  struct Texcoord {
    glm::dvec2 uv{0.0};
    double footprint = 0.0;
  };
  std::array<Texcoord, 2> texcoords{};  // the mesh's first and second
  glm::dvec4 color{1.0};                // of vertices, see MeshArrays
};

// The mean of those of three points by barycentric weights, without footprints.
MeshValues interpolate(const std::array<MeshValues, 3>& corners, const glm::dvec3& weights);

// Those at the corners of a triangle. Where a mesh has no second texture coordinates they are the
// first.
std::array<MeshValues, 3> corner_values(const MeshArrays& mesh, std::size_t triangle);
// Those within a triangle.
MeshValues values_in(const MeshArrays& mesh, std::size_t triangle, const glm::dvec3& weights);

// The mean color over a mesh's area; white without colors.
glm::dvec4 mean_color(const MeshArrays& mesh);

// The texture of a reference where these values are; white if it has none.
glm::vec4 lookup(const TextureReference& texture, const MeshValues& values);

}  // namespace brume
