#include "brume/error.h"
#include "core/io/mesh/mesh_readers.h"
#include "core/io/ply.h"

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
  [[nodiscard]] glm::vec4 of(const PlyFile::Row& row) const {
    glm::dvec4 rgba(1.0);
    for (std::size_t k = 0; k < columns_.size(); ++k) {
      rgba[static_cast<int>(k)] = row.scalars[columns_[k].index] / columns_[k].white;
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

glm::dvec3 values(const PlyFile::Row& row, const Columns& columns) {
  return {row.scalars[*columns[0]], row.scalars[*columns[1]], row.scalars[*columns[2]]};
}

// A strip of triangles, each of a vertex and the two before it, every second one turned round.
// Lists of strips, as Stanford's programs write them, end each with -1.
void add_strip(RawMesh& mesh, std::span<const std::uint32_t> strip) {
  for (std::size_t i = 2; i < strip.size(); ++i) {
    const std::size_t odd = i % 2;
    add_polygon(mesh, std::array{strip[i - 2 + odd], strip[i - 1 - odd], strip[i]});
  }
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
  const Columns position = scalar_columns(*vertices, {"x", "y", "z"});
  const Columns normal = scalar_columns(*vertices, {"nx", "ny", "nz"});
  const auto texcoord = texcoord_columns(*vertices);
  const PlyColors colors(*vertices);
  if (!all(position)) throw InputError(file, "element vertex", "there are no properties x y z");
  std::optional<std::size_t> corners = faces->property("vertex_indices");
  if (!corners) corners = faces->property("vertex_index");
  if (!corners || !faces->properties[*corners].list_count) {
    throw InputError(file, "element face", "there is no list vertex_indices");
  }

  RawMesh mesh;
  mesh.warnings = ply.warnings();
  std::vector<std::uint32_t> face;
  ply.for_each_row(
      [&](const PlyFile::Element& element, std::uint64_t index, const PlyFile::Row& row) {
        if (&element == vertices) {
          mesh.points.push_back(values(row, position));
          check_point(file, "vertex " + std::to_string(index), mesh.points.back());
          if (all(normal)) mesh.normals.push_back(values(row, normal));
          if (colors.has_any()) mesh.colors.push_back(colors.of(row));
          if (texcoord) {
            const auto& [u, v] = *texcoord;
            mesh.texcoords.push_back(finite_texcoord(row.scalars[u], row.scalars[v]));
          }
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
