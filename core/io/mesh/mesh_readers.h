#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace brume {

// The content of a mesh file before conversion to TriangleMesh. Missing normals are zero;
// `normals`, `texcoords` and `colors` are empty or as long as `points`.
struct RawMesh {
  std::vector<glm::dvec3> points;
  std::vector<glm::dvec3> normals;
  std::vector<std::uint32_t> corners;     // of the polygons, one after the other
  std::vector<std::size_t> polygon_ends;  // within `corners`
  std::vector<glm::vec2> texcoords;       // u to the right, v up; missing ones are 0
  std::vector<glm::vec4> colors;          // linear RGBA in [0, 1]
  // Vertices with the same number are one point of the file, split where its texture coordinates
  // are: normals that are computed are smooth across. Empty: none is split.
  std::vector<std::uint32_t> file_points;
  std::vector<std::string> warnings;  // one line each, with the file's name
};

// Each takes the bytes of a file (the name is for errors), checks counts, indices and coordinates,
// and throws InputError naming line, row or byte.
RawMesh read_obj(const std::filesystem::path& file, std::string_view bytes);
RawMesh read_off(const std::filesystem::path& file, std::string_view bytes);
RawMesh read_ply_mesh(const std::filesystem::path& file, std::string_view bytes);
RawMesh read_stl(const std::filesystem::path& file, std::string_view bytes);

// Shared by the readers. `place`: line or row, for errors.
class TextScanner;
glm::dvec3 read_point(const std::filesystem::path& file, TextScanner& scanner);
glm::dvec3 read_normal(TextScanner& scanner);
// Finite, or 0.
glm::vec2 read_texcoord(TextScanner& scanner);
glm::vec2 finite_texcoord(double u, double v);
// An sRGB-encoded RGBA color in [0, 1], as formats without a color space have them, as a linear
// one; what is beyond is taken as the nearest. Blender reads and writes them by default as sRGB,
// too.
glm::vec4 linear_color(const glm::dvec4& rgba);
void check_point(const std::filesystem::path& file, const std::string& place,
                 const glm::dvec3& point);
// Leaves out corners that are the one before, and what has fewer than three.
void add_polygon(RawMesh& mesh, std::span<const std::uint32_t> corners);

}  // namespace brume
