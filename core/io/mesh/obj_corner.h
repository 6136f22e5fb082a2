#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace brume {

// How many points (v), texture coordinates (vt) and normals (vn) an OBJ has, as a whole or up to a
// line, and elements: faces (f), lines (l), and points that are drawn (p).
struct ObjCounts {
  std::size_t points = 0;
  std::size_t texcoords = 0;
  std::size_t normals = 0;
  std::size_t faces = 0;
  std::size_t lines = 0;
  std::size_t point_elements = 0;

  void add(std::string_view keyword);
};
ObjCounts count_obj(std::string_view text);
// Throws InputError that says what a file has instead, if it has no faces.
void check_has_faces(const std::filesystem::path& file, const ObjCounts& counts);

// A corner of a face of an OBJ, written v, v/t, v//n or v/t/n: indices from 0, nullopt where the
// file has no such point, texture coordinates or normal.
struct ObjCorner {
  std::optional<std::uint32_t> point;
  std::optional<std::uint32_t> texcoord;
  std::optional<std::uint32_t> normal;

  bool operator==(const ObjCorner&) const = default;
};
// `before`: what stands before the face, from whose end negative indices count; positive ones may
// run ahead.
ObjCorner read_obj_corner(std::string_view token, const ObjCounts& before, const ObjCounts& all);

// Whether these are three or more corners, each at a point of the file.
bool is_obj_face(std::span<const ObjCorner> corners);
// A warning of so many faces that are none, at the first of them.
std::string bad_obj_faces(std::size_t count);

}  // namespace brume
