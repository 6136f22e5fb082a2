#include "core/io/mesh/mesh_file.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <numeric>
#include <string>
#include <tuple>
#include <vector>

#include "brume/error.h"
#include "brume/limits.h"
#include "brume/mesh_arrays.h"
#include "core/io/file_bytes.h"
#include "core/io/mesh/mesh_readers.h"
#include "core/io/text_scanner.h"
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
  const std::string bytes = read_bytes(file);
  if (bytes.empty()) throw InputError(file, "", "is empty");
  return reader(file, bytes);
}

// The unit vector along v, or zero where v has no direction.
glm::dvec3 unit_or_zero(const glm::dvec3& v) {
  const double max_component = std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
  if (!(max_component > 0.0 && max_component <= 1e300)) return glm::dvec3(0.0);
  const glm::dvec3 scaled = v / max_component;  // so that no square underflows
  return scaled / glm::length(scaled);
}

// Vertices at one place are the seam of a smooth surface if their normals differ by less than 60
// degrees (patches tessellated one by one), else an edge that is meant to be seen.
constexpr double cos_seam = 0.5;

// Adds to every vertex's sum those of the vertices at the same place that it forms a seam with.
void smooth_seams(const RawMesh& raw, std::vector<glm::dvec3>& sums) {
  std::vector<std::uint32_t> order(sums.size());
  std::iota(order.begin(), order.end(), 0u);
  const auto place = [&](std::uint32_t i) {
    return std::tie(raw.points[i].x, raw.points[i].y, raw.points[i].z);
  };
  std::sort(order.begin(), order.end(),
            [&](std::uint32_t a, std::uint32_t b) { return place(a) < place(b); });
  const std::vector<glm::dvec3> own = sums;
  // A place where very many vertices meet is no seam, and pairs would take long.
  constexpr std::ptrdiff_t limit = 64;
  for (auto first = order.begin(); first != order.end();) {
    const auto last = std::find_if(first, order.end(),
                                   [&](std::uint32_t i) { return place(i) != place(*first); });
    for (auto i = first; last - first <= limit && i != last; ++i) {
      for (auto j = first; j != last; ++j) {
        if (i == j) continue;
        const bool is_split =
            !raw.file_points.empty() && raw.file_points[*i] == raw.file_points[*j];
        const double cosine = glm::dot(unit_or_zero(own[*i]), unit_or_zero(own[*j]));
        if (is_split || cosine > cos_seam) sums[*i] += own[*j];
      }
    }
    first = last;
  }
}

// Unit normals: the file's, else the sum of the adjacent triangles' normals weighted by area.
std::vector<glm::dvec3> unit_normals(const RawMesh& raw) {
  std::vector<glm::dvec3> smooth(raw.points.size(), glm::dvec3(0.0));
  for (const auto& [a, b, c] : raw.triangles) {
    const glm::dvec3 area =
        glm::cross(raw.points[b] - raw.points[a], raw.points[c] - raw.points[a]);
    for (const std::uint32_t vertex : {a, b, c}) smooth[vertex] += area;
  }
  if (raw.normals.empty()) smooth_seams(raw, smooth);
  for (std::size_t i = 0; i < smooth.size(); ++i) {
    glm::dvec3 normal = raw.normals.empty() ? glm::dvec3(0.0) : unit_or_zero(raw.normals[i]);
    if (normal == glm::dvec3(0.0)) normal = unit_or_zero(smooth[i]);
    if (normal == glm::dvec3(0.0)) normal = {0.0, 1.0, 0.0};  // of no visible triangle
    smooth[i] = normal;
  }
  return smooth;
}

std::shared_ptr<TriangleMesh> to_triangle_mesh(const std::filesystem::path& file,
                                               const RawMesh& raw) {
  MeshArrays arrays;
  arrays.points.assign(raw.points.begin(), raw.points.end());
  const std::vector<glm::dvec3> normals = unit_normals(raw);
  arrays.normals.assign(normals.begin(), normals.end());
  for (const auto& [a, b, c] : raw.triangles) arrays.triangles.emplace_back(a, b, c);
  arrays.texcoords = raw.texcoords;
  auto mesh = to_mesh(arrays, limits::scene_bytes);
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

void add_polygon(RawMesh& mesh, std::span<const std::uint32_t> corners) {
  for (std::size_t i = 2; i < corners.size(); ++i) {
    const std::array triangle{corners[0], corners[i - 1], corners[i]};
    if (triangle[0] != triangle[1] && triangle[1] != triangle[2] && triangle[2] != triangle[0]) {
      mesh.triangles.push_back(triangle);
    }
  }
}

std::shared_ptr<const TriangleMesh> read_mesh(const std::filesystem::path& file) {
  const RawMesh raw = read_raw(file);
  if (raw.triangles.empty()) throw InputError(file, "", "the mesh has no faces");
  return to_triangle_mesh(file, raw);
}

}  // namespace brume
