#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <glm/vec3.hpp>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace brume {

// The content of a mesh file before it becomes a TriangleMesh. Where the file has no normal for a
// vertex its entry is zero; `normals` is empty or as long as `points`.
struct RawMesh {
  std::vector<glm::dvec3> points;
  std::vector<glm::dvec3> normals;
  std::vector<std::array<std::uint32_t, 3>> triangles;
};

// Brume reads meshes itself: OpenMesh's readers trust counts and indices of the file, and merge
// the normals of a crease. Each reader takes the bytes of a file (its name is for errors only),
// checks counts, indices and coordinates, and throws InputError naming the line, row or byte.
RawMesh read_obj(const std::filesystem::path& file, std::string_view bytes);
RawMesh read_off(const std::filesystem::path& file, std::string_view bytes);
RawMesh read_ply_mesh(const std::filesystem::path& file, std::string_view bytes);
RawMesh read_stl(const std::filesystem::path& file, std::string_view bytes);

// What the readers share. `place` is a line or a row, for errors.
class TextScanner;
glm::dvec3 read_point(const std::filesystem::path& file, TextScanner& scanner);
glm::dvec3 read_normal(TextScanner& scanner);
void check_point(const std::filesystem::path& file, const std::string& place,
                 const glm::dvec3& point);
void add_polygon(RawMesh& mesh, std::span<const std::uint32_t> corners);

}  // namespace brume
