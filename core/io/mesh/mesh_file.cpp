#include "core/io/mesh/mesh_file.h"

#include <algorithm>
#include <utility>

#include "brume/error.h"
#include "brume/mesh_arrays.h"
#include "core/io/disk/file_bytes.h"
#include "core/io/mesh/mesh_normals.h"
#include "core/io/mesh/mesh_readers.h"
#include "core/io/mesh/triangulate.h"
#include "core/io/text_scanner.h"
#include "core/io/unicode_text.h"
#include "core/math/srgb.h"
#include "core/number_domain.h"

namespace brume {
namespace {

RawMesh read_raw(const std::filesystem::path& file) {
  const std::string extension = lower_case_extension(file);
  const auto reader = extension == ".obj"   ? read_obj
                      : extension == ".off" ? read_off
                      : extension == ".ply" ? read_ply_mesh
                      : extension == ".stl" ? read_stl
                                            : nullptr;
  regular_file_size(file);  // report a missing file before its extension
  if (reader == nullptr) {
    throw InputError(
        file, "",
        "found a mesh of format " + quoted_text(extension) + "; allowed: .obj, .ply, .stl, .off");
  }
  std::string bytes = read_bytes(file);
  if (extension == ".obj") bytes = as_utf8(std::move(bytes));
  if (bytes.empty()) throw InputError(file, "", "is empty");
  return reader(file, bytes);
}

std::shared_ptr<TriangleMesh> to_triangle_mesh(const std::filesystem::path& file, RawMesh raw,
                                               Triangulation faces) {
  MeshArrays arrays;
  {
    const std::vector<glm::dvec3> normals = vertex_normals(raw, faces);
    arrays.normals.assign(normals.begin(), normals.end());
  }
  arrays.points.assign(raw.points.begin(), raw.points.end());
  arrays.triangles = std::move(faces.triangles);
  arrays.texcoords = std::move(raw.texcoords);
  arrays.colors = std::move(raw.colors);
  auto mesh = to_mesh(std::move(arrays), limits::scene_bytes);
  if (mesh) return mesh;
  throw InputError(file, "",
                   "the mesh needs more than the allowed " + std::to_string(limits::scene_bytes) +
                       " bytes of memory");
}

}  // namespace

void check_point(const std::filesystem::path& file, const std::string& place,
                 const glm::dvec3& point) {
  for (int axis = 0; axis < 3; ++axis) {
    if (!domain::coordinate.contains(point[axis])) {
      throw InputError(file, place, domain::coordinate.refusal(point[axis]));
    }
  }
}

glm::dvec3 read_point(const std::filesystem::path& file, TextScanner& scanner) {
  glm::dvec3 point;
  for (int axis = 0; axis < 3; ++axis) {
    const std::string_view token = scanner.next_token();
    const std::optional<double> value = parse_number(token);
    if (!value) {
      throw InputError(file, scanner.place(),
                       "found " + quoted_text(token) + "; allowed: a number");
    }
    point[axis] = *value;
  }
  check_point(file, scanner.place(), point);
  return point;
}

glm::dvec3 read_normal(TextScanner& scanner) {
  glm::dvec3 normal;
  for (int axis = 0; axis < 3; ++axis) {
    normal[axis] = parse_number(scanner.next_token()).value_or(0.0);
  }
  return normal;
}

glm::vec2 finite_texcoord(double u, double v) {
  // Beyond this, float has no digits left within the texture.
  constexpr double max_texcoord = 1e6;
  const auto is_valid = [](double x) { return x >= -max_texcoord && x <= max_texcoord; };
  return is_valid(u) && is_valid(v) ? glm::vec2(u, v) : glm::vec2(0.0f);
}

glm::vec2 read_texcoord(TextScanner& scanner) {
  const double u = parse_number(scanner.next_token()).value_or(0.0);
  const double v = parse_number(scanner.next_token()).value_or(0.0);
  return finite_texcoord(u, v);
}

glm::vec4 linear_color(const glm::dvec4& rgba) {
  const auto nearest = [](double x) { return x > 0.0 ? std::min(x, 1.0) : 0.0; };
  glm::vec4 color;
  for (int k = 0; k < 3; ++k) color[k] = static_cast<float>(srgb_decoded(nearest(rgba[k])));
  color.a = static_cast<float>(nearest(rgba.a));
  return color;
}

void add_polygon(RawMesh& mesh, std::span<const std::uint32_t> corners) {
  const std::size_t begin = mesh.corners.size();
  for (std::size_t i = 0; i < corners.size(); ++i) {
    if (corners[i] != corners[i > 0 ? i - 1 : corners.size() - 1])
      mesh.corners.push_back(corners[i]);
  }
  if (mesh.corners.size() - begin < 3) {
    mesh.corners.resize(begin);
  } else {
    mesh.polygon_ends.push_back(mesh.corners.size());
  }
}

std::shared_ptr<const TriangleMesh> read_mesh(const std::filesystem::path& file,
                                              std::vector<std::string>* warnings) {
  RawMesh raw = read_raw(file);
  if (warnings != nullptr) {
    warnings->insert(warnings->end(), raw.warnings.begin(), raw.warnings.end());
  }
  Triangulation faces = triangulate(raw);
  if (faces.triangles.empty()) {
    const std::string why = raw.warnings.empty() ? "" : ": " + raw.warnings.front();
    throw InputError(file, "", "the mesh has no faces" + why);
  }
  return to_triangle_mesh(file, std::move(raw), std::move(faces));
}

}  // namespace brume
