#include "core/io/mesh/obj_corner.h"

#include <algorithm>
#include <utility>

#include "brume/error.h"
#include "core/io/text_scanner.h"

namespace brume {
namespace {

// The 1-based or, from the end of what stands before, negative index of an OBJ as one from 0.
std::optional<std::uint32_t> resolved(std::string_view token, std::size_t before, std::size_t all) {
  const std::optional<std::int64_t> index = parse_integer(token);
  if (!index || *index == 0) return std::nullopt;
  if (*index > 0 && static_cast<std::uint64_t>(*index) > all) return std::nullopt;
  if (*index < 0 && *index < -static_cast<std::int64_t>(before)) return std::nullopt;
  const std::int64_t first = *index > 0 ? -1 : static_cast<std::int64_t>(before);
  return static_cast<std::uint32_t>(first + *index);
}

}  // namespace

void ObjCounts::add(std::string_view keyword) {
  if (keyword == "v") ++points;
  if (keyword == "vt") ++texcoords;
  if (keyword == "vn") ++normals;
  if (keyword == "f") ++faces;
  if (keyword == "l") ++lines;
  if (keyword == "p") ++point_elements;
}

void check_has_faces(const std::filesystem::path& file, const ObjCounts& counts) {
  if (counts.faces > 0) return;
  std::string found;
  for (const auto& [name, count] : {std::pair("vertices (", counts.points),
                                    {"lines (", counts.lines},
                                    {"points (", counts.point_elements}}) {
    if (count > 0) found += (found.empty() ? "" : ", ") + (name + std::to_string(count)) + ")";
  }
  throw InputError(
      file, "", "the mesh has no faces" + (found.empty() ? " and no vertices" : ", only " + found));
}

ObjCounts count_obj(std::string_view text) {
  TextScanner scanner(text, true);
  ObjCounts counts;
  while (scanner.next_line()) counts.add(scanner.next_token());
  return counts;
}

ObjCorner read_obj_corner(std::string_view token, const ObjCounts& before, const ObjCounts& all) {
  const std::size_t slash = token.find('/');
  ObjCorner corner{resolved(token.substr(0, slash), before.points, all.points), {}, {}};
  if (slash == token.npos) return corner;
  const std::size_t second = token.find('/', slash + 1);
  corner.texcoord =
      resolved(token.substr(slash + 1, second - slash - 1), before.texcoords, all.texcoords);
  if (second == token.npos) return corner;
  corner.normal = resolved(token.substr(second + 1), before.normals, all.normals);
  return corner;
}

bool is_obj_face(std::span<const ObjCorner> corners) {
  return corners.size() >= 3 && std::ranges::all_of(corners, [](const ObjCorner& corner) {
           return corner.point.has_value();
         });
}

std::string bad_obj_faces(std::size_t count) {
  return "found a face with fewer than three vertices, or with one that the file does not have; " +
         (count == 1 ? "it is left out"
                     : "such faces are left out, " + std::to_string(count) + " in all");
}

}  // namespace brume
