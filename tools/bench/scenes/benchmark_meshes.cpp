#include "tools/bench/scenes/benchmark_meshes.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <vector>

#include "core/scene/mesh.h"

namespace brume {
namespace {

using std::numbers::pi;

}  // namespace

MeshBuilder::MeshBuilder() : mesh_(std::make_shared<TriangleMesh>()) {}

std::size_t MeshBuilder::size() const {
  return mesh_->n_vertices();
}

void MeshBuilder::grid(int columns, int rows, bool closed, const Place& place) {
  std::vector<TriangleMesh::VertexHandle> vertices;
  for (int j = 0; j < rows; ++j) {
    for (int i = 0; i < columns; ++i) {
      const glm::dvec3 p =
          place(static_cast<double>(i) / (closed ? columns : columns - 1), j / (rows - 1.0));
      vertices.push_back(mesh_->add_vertex(
          {static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)}));
    }
  }
  const auto add = [&](auto a, auto b, auto c) {
    // None at the poles of a ball, where a row is a point.
    const auto& p = mesh_->point(a);
    const auto& q = mesh_->point(b);
    const auto& r = mesh_->point(c);
    if ((q - p).cross(r - p).sqrnorm() > 0.0f) mesh_->add_face(a, b, c);
  };
  for (int j = 0; j + 1 < rows; ++j) {
    for (int i = 0; i < (closed ? columns : columns - 1); ++i) {
      const auto vertex_at = [&](int column, int row) {
        return vertices[static_cast<std::size_t>(row * columns + column % columns)];
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
  const auto first_face = static_cast<int>(mesh_->n_faces());
  const int columns = static_cast<int>(std::sqrt(static_cast<double>(vertices)));
  grid(columns, static_cast<int>(vertices) / columns, false, place);
  for (int face = first_face; size() < end; ++face) {
    const TriangleMesh::FaceHandle handle(face);
    mesh_->split(handle, mesh_->calc_face_centroid(handle));
  }
}

std::shared_ptr<const TriangleMesh> MeshBuilder::finish() {
  mesh_->request_face_normals();
  mesh_->request_vertex_normals();
  mesh_->update_normals();
  mesh_->release_face_normals();
  return std::move(mesh_);
}

}  // namespace brume
