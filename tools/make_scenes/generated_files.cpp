#include "tools/make_scenes/generated_files.h"

#include <bit>
#include <cassert>
#include <fstream>

#include "brume/error.h"
#include "tools/make_scenes/sample_scene.h"

namespace brume {
namespace {

void append_u16(std::string& bytes, std::uint16_t value) {
  bytes += static_cast<char>(value & 0xff);
  bytes += static_cast<char>(value >> 8);
}

// Little-endian on any machine.
void append_float(std::string& bytes, double value) {
  const auto bits = std::bit_cast<std::uint32_t>(static_cast<float>(rounded(value)));
  append_u16(bytes, static_cast<std::uint16_t>(bits & 0xffff));
  append_u16(bytes, static_cast<std::uint16_t>(bits >> 16));
}

void append_point(std::string& bytes, const glm::dvec3& point) {
  append_float(bytes, point.x);
  append_float(bytes, point.y);
  append_float(bytes, point.z);
}

std::string ply_vertex_header(std::size_t count) {
  return "ply\nformat binary_little_endian 1.0\nelement vertex " + std::to_string(count) +
         "\nproperty float x\nproperty float y\nproperty float z\n";
}

}  // namespace

void write_bytes(const std::filesystem::path& file, const std::string& bytes) {
  std::ofstream out(file, std::ios::binary);
  out.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  out.close();
  if (!out) throw InputError(file, "", "cannot be written");
}

void write_gaussian_ply(const std::filesystem::path& file, const std::vector<Gaussian>& gaussians) {
  std::string bytes = ply_vertex_header(gaussians.size()) +
                      "property float radius\nproperty float density\nend_header\n";
  for (const Gaussian& g : gaussians) {
    append_point(bytes, g.center);
    append_float(bytes, g.radius);
    append_float(bytes, g.density);
  }
  write_bytes(file, bytes);
}

void write_mesh_ply(const std::filesystem::path& file, const std::vector<glm::dvec3>& vertices,
                    const std::vector<std::array<std::uint16_t, 3>>& triangles) {
  assert(vertices.size() <= 65536);
  std::string bytes = ply_vertex_header(vertices.size()) + "element face " +
                      std::to_string(triangles.size()) +
                      "\nproperty list uchar ushort vertex_indices\nend_header\n";
  for (const glm::dvec3& vertex : vertices) append_point(bytes, vertex);
  for (const auto& triangle : triangles) {
    bytes += '\3';
    for (const std::uint16_t index : triangle) append_u16(bytes, index);
  }
  write_bytes(file, bytes);
}

void write_plane(const std::filesystem::path& file) {
  write_bytes(file,
              "v -1 0 1\nv 1 0 1\nv 1 0 -1\nv -1 0 -1\n"
              "f 1 2 3\nf 1 3 4\n");
}

void write_open_box(const std::filesystem::path& file) {
  write_bytes(file,
              "OFF\n16 8 0\n"
              "-1 0 1\n1 0 1\n1 0 -1\n-1 0 -1\n"    // floor
              "-1 0 -1\n1 0 -1\n1 1 -1\n-1 1 -1\n"  // back
              "-1 0 1\n-1 0 -1\n-1 1 -1\n-1 1 1\n"  // left
              "1 0 -1\n1 0 1\n1 1 1\n1 1 -1\n"      // right
              "3 0 1 2\n3 0 2 3\n3 4 5 6\n3 4 6 7\n"
              "3 8 9 10\n3 8 10 11\n3 12 13 14\n3 12 14 15\n");
}

}  // namespace brume
