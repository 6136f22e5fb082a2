#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <atomic>
#include <utility>

#include "brume/error.h"
#include "core/io/mesh/mesh_readers.h"
#include "core/io/ply.h"
#include "core/number_domain.h"

namespace brume {
namespace {

using Columns = std::array<std::optional<std::size_t>, 3>;

Columns scalar_columns(const PlyFile::Element& element, std::array<const char*, 3> names) {
  Columns columns;
  for (std::size_t i = 0; i < 3; ++i) {
    columns[i] = element.property(names[i]);
    if (columns[i] && element.properties[*columns[i]].list_count) columns[i].reset();
  }
  return columns;
}

// Texture coordinates, by the names in use.
std::optional<std::array<std::size_t, 2>> texcoord_columns(const PlyFile::Element& element) {
  constexpr std::array<std::array<const char*, 2>, 4> names{
      {{"s", "t"}, {"u", "v"}, {"texture_u", "texture_v"}, {"s0", "t0"}}};
  for (const auto& [u_name, v_name] : names) {
    const auto u = element.property(u_name);
    const auto v = element.property(v_name);
    if (!u || !v || element.properties[*u].list_count || element.properties[*v].list_count)
      continue;
    return std::array{*u, *v};
  }
  return std::nullopt;
}

bool all(const Columns& columns) {
  return columns[0] && columns[1] && columns[2];
}

// Reads the colors of vertices.
class PlyColors {
 public:
  explicit PlyColors(const PlyFile::Element& vertices) {
    for (const char* name : {"red", "green", "blue", "alpha"}) {
      const auto column = vertices.property(name);
      if (!column || vertices.properties[*column].list_count) break;
      columns_.push_back({*column, white(vertices.properties[*column].type)});
    }
  }
  [[nodiscard]] bool has_any() const { return columns_.size() >= 3; }
  // `value` of a property.
  [[nodiscard]] glm::vec4 color(const auto& value) const {
    glm::dvec4 rgba(1.0);
    for (std::size_t k = 0; k < columns_.size(); ++k) {
      rgba[static_cast<int>(k)] = value(columns_[k].index) / columns_[k].white;
    }
    return linear_color(rgba);
  }

 private:
  struct Column {
    std::size_t index;
    double white;
  };
  static double white(PlyFile::Type type) {
    using enum PlyFile::Type;
    return type == float32 || type == float64 ? 1.0 : type == uint16 ? 65535.0 : 255.0;
  }
  std::vector<Column> columns_;
};

glm::dvec3 values(const auto& value, const Columns& columns) {
  return {value(*columns[0]), value(*columns[1]), value(*columns[2])};
}

// The places of the values of a vertex.
struct VertexColumns {
  Columns position;
  Columns normal;
  std::optional<std::array<std::size_t, 2>> texcoord;
  PlyColors colors;

  explicit VertexColumns(const PlyFile::Element& vertices)
      : position(scalar_columns(vertices, {"x", "y", "z"})),
        normal(scalar_columns(vertices, {"nx", "ny", "nz"})),
        texcoord(texcoord_columns(vertices)),
        colors(vertices) {}

  void resize(RawMesh& mesh, std::size_t count) const {
    mesh.points.resize(count);
    if (all(normal)) mesh.normals.resize(count);
    if (colors.has_any()) mesh.colors.resize(count);
    if (texcoord) mesh.texcoords.resize(count);
  }
  // Takes the values of a vertex by property.
  void read(RawMesh& mesh, std::size_t vertex, const auto& value) const {
    mesh.points[vertex] = values(value, position);
    if (all(normal)) mesh.normals[vertex] = values(value, normal);
    if (colors.has_any()) mesh.colors[vertex] = colors.color(value);
    if (texcoord) {
      const auto& [u, v] = *texcoord;
      mesh.texcoords[vertex] = finite_texcoord(value(u), value(v));
    }
  }
};

// A strip of triangles, each of a vertex and the two before it, every second one turned round.
// Lists of strips, as Stanford's programs write them, end each with -1.
void add_strip(RawMesh& mesh, std::span<const std::uint32_t> strip) {
  for (std::size_t i = 2; i < strip.size(); ++i) {
    const std::size_t odd = i % 2;
    add_polygon(mesh, std::array{strip[i - 2 + odd], strip[i - 1 - odd], strip[i]});
  }
}

void for_each_in_parallel(std::uint64_t count, const auto& visit) {
  tbb::parallel_for(tbb::blocked_range<std::uint64_t>(0, count, 4096), [&](const auto& range) {
    for (std::uint64_t i = range.begin(); i < range.end(); ++i) visit(i);
  });
}

// Reads rows of one size. False for a mesh that is not sound, as far as it was read.
bool read_equal_rows(RawMesh& mesh, const VertexColumns& columns,
                     const PlyFile::EqualRows& vertices, std::uint64_t vertex_count,
                     const PlyFile::EqualRows& faces, std::uint64_t face_count,
                     std::size_t corner_list) {
  std::atomic<bool> is_sound = true;
  columns.resize(mesh, vertex_count);
  for_each_in_parallel(vertex_count, [&](std::uint64_t i) {
    columns.read(mesh, i, [&](std::size_t property) { return vertices.value(i, property); });
    for (int axis = 0; axis < 3; ++axis) {
      if (!domain::coordinate.contains(mesh.points[i][axis])) is_sound = false;
    }
  });
  const std::size_t n = faces.length(corner_list);
  mesh.corners.resize(face_count * n);
  std::atomic<bool> has_repeated = n < 3;
  for_each_in_parallel(face_count, [&](std::uint64_t i) {
    for (std::size_t k = 0; k < n; ++k) {
      const double corner = faces.value(i, corner_list, k);
      if (!(corner >= 0.0 && corner < static_cast<double>(vertex_count))) {
        is_sound = false;
        return;
      }
      mesh.corners[i * n + k] = static_cast<std::uint32_t>(corner);
    }
    for (std::size_t k = 0; k < n; ++k) {
      if (mesh.corners[i * n + k] == mesh.corners[i * n + (k + 1) % n]) has_repeated = true;
    }
  });
  if (!is_sound) return false;
  if (has_repeated) {
    const std::vector<std::uint32_t> corners = std::exchange(mesh.corners, {});
    for (std::size_t i = 0; i < face_count; ++i) {
      add_polygon(mesh, std::span(corners).subspan(i * n, n));
    }
  } else {
    mesh.polygon_ends.resize(face_count);
    for_each_in_parallel(face_count, [&](std::uint64_t i) { mesh.polygon_ends[i] = (i + 1) * n; });
  }
  return true;
}

}  // namespace

RawMesh read_ply_mesh(const std::filesystem::path& file, std::string_view bytes) {
  const PlyFile ply(file, bytes);
  const PlyFile::Element* vertices = ply.element("vertex");
  const PlyFile::Element* faces = ply.element("face");
  const bool are_strips = faces == nullptr;
  if (are_strips) faces = ply.element("tristrips");
  if (vertices == nullptr) throw InputError(file, "header", "there is no element vertex");
  if (faces == nullptr) throw InputError(file, "header", "the mesh has no faces");
  const VertexColumns columns(*vertices);
  if (!all(columns.position))
    throw InputError(file, "element vertex", "there are no properties x y z");
  std::optional<std::size_t> corners = faces->property("vertex_indices");
  if (!corners) corners = faces->property("vertex_index");
  if (!corners || !faces->properties[*corners].list_count) {
    throw InputError(file, "element face", "there is no list vertex_indices");
  }

  RawMesh mesh;
  mesh.warnings = ply.warnings();
  if (const auto rows = ply.equal_rows(); rows && !are_strips) {
    const auto rows_of = [&](const PlyFile::Element* element) {
      return (*rows)[static_cast<std::size_t>(element - ply.elements().data())];
    };
    RawMesh plain = mesh;
    if (read_equal_rows(plain, columns, rows_of(vertices), vertices->count, rows_of(faces),
                        faces->count, *corners)) {
      return plain;
    }
  }
  std::vector<std::uint32_t> face;
  ply.for_each_row(
      [&](const PlyFile::Element& element, std::uint64_t index, const PlyFile::Row& row) {
        if (&element == vertices) {
          columns.resize(mesh, index + 1);
          columns.read(mesh, index, [&row](std::size_t property) { return row.scalars[property]; });
          check_point(file, "vertex " + std::to_string(index), mesh.points.back());
        } else if (&element == faces) {
          face.clear();
          for (const double corner : row.lists[*corners]) {
            if (are_strips && corner == -1.0) {
              add_strip(mesh, face);
              face.clear();
              continue;
            }
            if (!(corner >= 0.0 && corner < static_cast<double>(vertices->count))) {
              throw InputError(file, "face " + std::to_string(index),
                               "found the vertex index " + std::to_string(corner) +
                                   "; allowed: 0 to " + std::to_string(vertices->count - 1));
            }
            face.push_back(static_cast<std::uint32_t>(corner));
          }
          are_strips ? add_strip(mesh, face) : add_polygon(mesh, face);
        }
      });
  return mesh;
}

}  // namespace brume
