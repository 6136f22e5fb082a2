#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <glm/vec3.hpp>
#include <vector>

namespace brume {

// A mesh of patches that share no vertices: edges between them are sharp. Its numbers are rounded;
// see rounded().
struct PatchMesh {
  std::vector<glm::dvec3> vertices;
  std::vector<std::array<std::uint16_t, 3>> triangles;
};

// A grid of columns x rows quads at place(u, v), u and v from 0 to 1.
void add_patch(int columns, int rows, const std::function<glm::dvec3(double, double)>& place,
               PatchMesh& mesh);

// A rectangle from `corner` along two edges.
void add_rectangle(int columns, int rows, const glm::dvec3& corner, const glm::dvec3& u,
                   const glm::dvec3& v, PatchMesh& mesh);

// The six sides of a box, in quads of about `quad` [u].
void add_box(const glm::dvec3& low, const glm::dvec3& high, double quad, PatchMesh& mesh);

}  // namespace brume
