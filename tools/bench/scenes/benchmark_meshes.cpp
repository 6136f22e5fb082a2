#include "tools/bench/scenes/benchmark_meshes.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <utility>

#include "core/math/normals.h"
#include "core/scene/mesh.h"

namespace brume {
namespace {

using std::numbers::pi;

}  // namespace

std::size_t MeshBuilder::size() const {
  return mesh_.points.size();
}

void MeshBuilder::grid(int columns, int rows, bool closed, const Place& place) {
  const auto first = static_cast<unsigned>(size());
  for (int j = 0; j < rows; ++j) {
    for (int i = 0; i < columns; ++i) {
      const glm::dvec3 p =
          place(static_cast<double>(i) / (closed ? columns : columns - 1), j / (rows - 1.0));
      mesh_.points.emplace_back(p);
    }
  }
  const auto add = [&](unsigned a, unsigned b, unsigned c) {
    // None at the poles of a ball, where a row is a point.
    const glm::vec3& p = mesh_.points[a];
    const glm::vec3 normal = glm::cross(mesh_.points[b] - p, mesh_.points[c] - p);
    if (glm::dot(normal, normal) > 0.0f) mesh_.triangles.emplace_back(a, b, c);
  };
  for (int j = 0; j + 1 < rows; ++j) {
    for (int i = 0; i < (closed ? columns : columns - 1); ++i) {
      const auto vertex_at = [&](int column, int row) {
        return first + static_cast<unsigned>(row * columns + column % columns);
      };
      add(vertex_at(i, j), vertex_at(i + 1, j), vertex_at(i + 1, j + 1));
      add(vertex_at(i, j), vertex_at(i + 1, j + 1), vertex_at(i, j + 1));
    }
  }
}

void MeshBuilder::box(const glm::dvec3& low, const glm::dvec3& high, int n) {
  for (int axis = 0; axis < 3; ++axis) {
    for (const double side : {0.0, 1.0}) {
      grid(n, n, false, [&](double u, double v) {
        glm::dvec3 p;
        p[axis] = side;
        p[(axis + 1) % 3] = u;
        p[(axis + 2) % 3] = v;
        return low + p * (high - low);
      });
    }
  }
}

void MeshBuilder::ellipsoid(const glm::dvec3& center, const glm::dvec3& radii, int n) {
  grid(2 * n, n, true, [&](double u, double v) {
    const glm::dvec3 p(std::sin(pi * v) * std::cos(2 * pi * u), std::cos(pi * v),
                       std::sin(pi * v) * std::sin(2 * pi * u));
    return center + radii * p;
  });
}

void MeshBuilder::cylinder(const glm::dvec3& start, const glm::dvec3& end, double radius, int n) {
  const glm::dvec3 axis = glm::normalize(end - start);
  const glm::dvec3 side =
      std::abs(axis.y) < 0.9 ? glm::dvec3(0.0, 1.0, 0.0) : glm::dvec3(1.0, 0.0, 0.0);
  const glm::dvec3 x = glm::normalize(glm::cross(axis, side));
  const glm::dvec3 y = glm::cross(axis, x);
  const auto ring = [&](const glm::dvec3& center, double r, double u) {
    return center + r * (std::cos(2 * pi * u) * x + std::sin(2 * pi * u) * y);
  };
  grid(n, 2, true, [&](double u, double v) { return ring(start + v * (end - start), radius, u); });
  for (const glm::dvec3& center : {start, end}) {
    grid(n, 2, true, [&](double u, double v) { return ring(center, v * radius, u); });
  }
}

void MeshBuilder::tube(const std::function<glm::dvec3(double v)>& path, double radius, int n,
                       int rows) {
  grid(n, rows, true, [&](double u, double v) {
    const glm::dvec3 axis = glm::normalize(path(v + 1e-3) - path(v - 1e-3));
    const glm::dvec3 x = glm::normalize(glm::cross(axis, glm::dvec3(0.0, 0.0, 1.0)));
    return path(v) +
           radius * (std::cos(2 * pi * u) * x + std::sin(2 * pi * u) * glm::cross(axis, x));
  });
}

void MeshBuilder::sheet(std::size_t vertices, const Place& place) {
  const std::size_t end = size() + vertices;
  std::size_t face = mesh_.triangles.size();
  const int columns = static_cast<int>(std::sqrt(static_cast<double>(vertices)));
  grid(columns, static_cast<int>(vertices) / columns, false, place);
  for (; size() < end; ++face) {
    const glm::uvec3 corners = mesh_.triangles[face];
    const auto middle = static_cast<unsigned>(size());
    glm::vec3 sum(0.0f);
    for (int k = 0; k < 3; ++k) sum += mesh_.points[corners[k]];
    mesh_.points.push_back(sum / 3.0f);
    mesh_.triangles[face] = {corners.x, corners.y, middle};
    mesh_.triangles.emplace_back(corners.y, corners.z, middle);
    mesh_.triangles.emplace_back(corners.z, corners.x, middle);
  }
}

std::shared_ptr<const TriangleMesh> MeshBuilder::finish() {
  mesh_.normals.assign(size(), glm::vec3(0.0f));
  for (const glm::uvec3& corners : mesh_.triangles) {
    const glm::vec3 normal(glm::normalize(area_normal(mesh_.points, corners)));
    for (int k = 0; k < 3; ++k) mesh_.normals[corners[k]] += normal;
  }
  for (glm::vec3& normal : mesh_.normals) {
    if (normal != glm::vec3(0.0f)) normal = glm::normalize(normal);
  }
  return to_mesh(std::move(mesh_));
}

std::size_t add_patch(MeshArrays& mesh, int n,
                      const std::function<MeshVertex(double, double)>& vertex) {
  const std::size_t first = mesh.points.size();
  for (int i = 0; i <= n; ++i) {
    for (int j = 0; j <= n; ++j) {
      const MeshVertex v = vertex(static_cast<double>(i) / n, static_cast<double>(j) / n);
      mesh.points.emplace_back(v.position);
      mesh.normals.emplace_back(v.normal);
    }
  }
  const auto index_at = [&](int i, int j) {
    return first + static_cast<std::size_t>(i * (n + 1) + j);
  };
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < n; ++j) {
      mesh.triangles.emplace_back(index_at(i, j), index_at(i + 1, j), index_at(i + 1, j + 1));
      mesh.triangles.emplace_back(index_at(i, j), index_at(i + 1, j + 1), index_at(i, j + 1));
    }
  }
  return first;
}

std::size_t add_floor(MeshArrays& mesh, int n, double half) {
  return add_patch(mesh, n, [half](double u, double v) {
    return MeshVertex{{half * (2.0 * u - 1.0), half * (2.0 * v - 1.0), 0.0}, {0.0, 0.0, 1.0}};
  });
}

std::size_t add_ball(MeshArrays& mesh, int n, const glm::dvec3& center, double radius, double to,
                     bool inward) {
  return add_patch(mesh, n, [=](double u, double v) {
    const double theta = to * u;
    // The winding matches the normals.
    const double phi = 2.0 * std::numbers::pi * (inward ? v : -v);
    const glm::dvec3 out(std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi),
                         -std::cos(theta));
    return MeshVertex{center + radius * out, inward ? -out : out};
  });
}

}  // namespace brume
