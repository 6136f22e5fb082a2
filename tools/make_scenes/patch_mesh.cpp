#include "tools/make_scenes/patch_mesh.h"

#include <algorithm>
#include <cmath>

#include "tools/make_scenes/sample_scene.h"

namespace brume {

void add_patch(int columns, int rows, const std::function<glm::dvec3(double, double)>& place,
               PatchMesh& mesh) {
  const auto first = static_cast<int>(mesh.vertices.size());
  for (int j = 0; j <= rows; ++j) {
    for (int i = 0; i <= columns; ++i) {
      const glm::dvec3 p = place(static_cast<double>(i) / columns, static_cast<double>(j) / rows);
      mesh.vertices.emplace_back(rounded(p.x), rounded(p.y), rounded(p.z));
    }
  }
  for (int j = 0; j < rows; ++j) {
    for (int i = 0; i < columns; ++i) {
      const auto corner = static_cast<std::uint16_t>(first + j * (columns + 1) + i);
      const auto right = static_cast<std::uint16_t>(corner + 1);
      const auto above = static_cast<std::uint16_t>(corner + columns + 1);
      const auto across = static_cast<std::uint16_t>(above + 1);
      mesh.triangles.push_back({corner, right, across});
      mesh.triangles.push_back({corner, across, above});
    }
  }
}

void add_rectangle(int columns, int rows, const glm::dvec3& corner, const glm::dvec3& u,
                   const glm::dvec3& v, PatchMesh& mesh) {
  add_patch(
      columns, rows, [&](double s, double t) { return corner + s * u + t * v; }, mesh);
}

void add_box(const glm::dvec3& low, const glm::dvec3& high, double quad, PatchMesh& mesh) {
  const glm::dvec3 size = high - low;
  for (int axis = 0; axis < 3; ++axis) {
    glm::dvec3 u(0.0);
    glm::dvec3 v(0.0);
    glm::dvec3 across(0.0);
    const int next = (axis + 1) % 3;
    const int last = (axis + 2) % 3;
    u[next] = size[next];
    v[last] = size[last];
    across[axis] = size[axis];
    const auto quads = [&](int k) { return std::max(1, static_cast<int>(size[k] / quad + 0.5)); };
    // Seen from outside, counterclockwise.
    add_rectangle(quads(last), quads(next), low, v, u, mesh);
    add_rectangle(quads(next), quads(last), low + across, u, v, mesh);
  }
}

}  // namespace brume
