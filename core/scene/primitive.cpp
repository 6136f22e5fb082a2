#include "brume/primitive.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>

#include "brume/mesh_arrays.h"

namespace brume {
namespace {

constexpr unsigned flat_cells = 16;    // along each side of a plane
constexpr unsigned box_cells = 8;      // along each side of a face
constexpr unsigned segments = 48;      // around an axis
constexpr unsigned sphere_rings = 24;  // from pole to pole
constexpr unsigned wall_rings = 8;     // of a cylinder
constexpr unsigned cap_rings = 4;

// Shapes of size 1, scaled at the end; a normal is scaled by the inverse.
class ShapeBuilder {
 public:
  explicit ShapeBuilder(const glm::dvec3& size) : size_(size) {}

  // A grid of columns x rows cells: point(s, t), normal(s, t) and texture coordinates for s, t in
  // [0, 1]. Triangles face the side from which s runs right where t runs up.
  void add_grid(unsigned columns, unsigned rows, auto&& point, auto&& normal, auto&& texcoord) {
    const auto first = static_cast<unsigned>(arrays_.points.size());
    for (unsigned j = 0; j <= rows; ++j) {
      for (unsigned i = 0; i <= columns; ++i) {
        const double s = static_cast<double>(i) / columns;
        const double t = static_cast<double>(j) / rows;
        arrays_.points.emplace_back(point(s, t) * size_);
        arrays_.normals.emplace_back(glm::normalize(normal(s, t) / size_));
        arrays_.texcoords.emplace_back(texcoord(s, t));
      }
    }
    for (unsigned j = 0; j < rows; ++j) {
      for (unsigned i = 0; i < columns; ++i) {
        const unsigned a = first + j * (columns + 1) + i;
        const unsigned b = a + columns + 1;
        add_triangle({a, a + 1, b + 1});
        add_triangle({a, b + 1, b});
      }
    }
  }

  // A flat square of side 1 around `center`, spanned by half edges u and v, facing u x v. `right`
  // and `up`, unit, say how a texture lies on it.
  void add_square(unsigned cells, const glm::dvec3& center, const glm::dvec3& u,
                  const glm::dvec3& v, const glm::dvec3& right, const glm::dvec3& up) {
    const glm::dvec3 normal = glm::cross(u, v);
    const auto offset = [&](double s, double t) {
      return (2.0 * s - 1.0) * u + (2.0 * t - 1.0) * v;
    };
    add_grid(
        cells, cells, [&](double s, double t) { return center + offset(s, t); },
        [&](double, double) { return normal; },
        [&](double s, double t) { return flat_texcoord(offset(s, t), right, up); });
  }

  // `offset`: from the middle of a texture of side 1.
  static glm::dvec2 flat_texcoord(const glm::dvec3& offset, const glm::dvec3& right,
                                  const glm::dvec3& up) {
    return 0.5 + glm::dvec2(glm::dot(offset, right), glm::dot(offset, up));
  }

  std::shared_ptr<const TriangleMesh> finish() { return to_mesh(arrays_); }

 private:
  // At poles and the middles of caps, where corners meet, some have no area.
  void add_triangle(const glm::uvec3& corners) {
    const auto& p = arrays_.points;
    if (p[corners.x] == p[corners.y] || p[corners.y] == p[corners.z] ||
        p[corners.z] == p[corners.x]) {
      return;
    }
    arrays_.triangles.push_back(corners);
  }

  glm::dvec3 size_;
  MeshArrays arrays_;
};

// On the unit circle in the plane y = 0, exactly closed; runs from +z to +x.
glm::dvec3 on_circle(double turn) {
  const double angle = glm::two_pi<double>() * (turn == 1.0 ? 0.0 : turn);
  return {std::sin(angle), 0.0, std::cos(angle)};
}

void add_box(ShapeBuilder& builder) {
  for (int k = 0; k < 3; ++k) {
    glm::dvec3 u(0.0);
    glm::dvec3 v(0.0);
    u[(k + 1) % 3] = v[(k + 2) % 3] = 0.5;
    const glm::dvec3 out = 2.0 * glm::cross(u, v);
    // Upright on the sides; on top and bottom with the lower edge next to +z and -z.
    for (const double side : {1.0, -1.0}) {
      const glm::dvec3 up = k == 1 ? glm::dvec3(0.0, 0.0, -side) : glm::dvec3(0.0, 1.0, 0.0);
      const glm::dvec3 right = glm::cross(up, 2.0 * side * out);
      side > 0.0 ? builder.add_square(box_cells, out, u, v, right, up)
                 : builder.add_square(box_cells, -out, v, u, right, up);
    }
  }
}

glm::dvec2 grid_texcoord(double s, double t) {
  return {s, t};
}

void add_sphere(ShapeBuilder& builder) {
  const auto on_sphere = [](double s, double t) {
    if (t == 0.0 || t == 1.0) return glm::dvec3(0.0, 2.0 * t - 1.0, 0.0);
    const double latitude = glm::pi<double>() * (t - 0.5);
    return std::cos(latitude) * on_circle(s) + glm::dvec3(0.0, std::sin(latitude), 0.0);
  };
  builder.add_grid(
      segments, sphere_rings, [&](double s, double t) { return 0.5 * on_sphere(s, t); }, on_sphere,
      grid_texcoord);
}

void add_cylinder(ShapeBuilder& builder) {
  builder.add_grid(
      segments, wall_rings,
      [](double s, double t) { return 0.5 * on_circle(s) + glm::dvec3(0.0, t - 0.5, 0.0); },
      [](double s, double) { return on_circle(s); }, grid_texcoord);
  for (const double side : {1.0, -1.0}) {
    const glm::dvec3 normal(0.0, side, 0.0);
    const auto offset = [&](double s, double t) {
      // From the rim inwards above, outwards below, so that both face outwards.
      return 0.5 * (side > 0.0 ? 1.0 - t : t) * on_circle(s);
    };
    builder.add_grid(
        segments, cap_rings, [&](double s, double t) { return offset(s, t) + 0.5 * normal; },
        [&](double, double) { return normal; },
        [&](double s, double t) {
          return ShapeBuilder::flat_texcoord(offset(s, t), {1.0, 0.0, 0.0}, {0.0, 0.0, -side});
        });
  }
}

}  // namespace

std::shared_ptr<const TriangleMesh> mesh_of(const Primitive& primitive) {
  ShapeBuilder builder(primitive.size);
  switch (primitive.shape) {
    case Primitive::Shape::plane:
      builder.add_square(flat_cells, glm::dvec3(0.0), {0.0, 0.0, 0.5}, {0.5, 0.0, 0.0},
                         {1.0, 0.0, 0.0}, {0.0, 0.0, -1.0});
      break;
    case Primitive::Shape::box:
      add_box(builder);
      break;
    case Primitive::Shape::sphere:
      add_sphere(builder);
      break;
    case Primitive::Shape::cylinder:
      add_cylinder(builder);
      break;
  }
  return builder.finish();
}

}  // namespace brume
