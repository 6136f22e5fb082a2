#include <algorithm>
#include <bit>
#include <cctype>
#include <cstring>
#include <unordered_map>

#include "brume/error.h"
#include "core/io/mesh/mesh_readers.h"
#include "core/io/text_scanner.h"

namespace brume {
namespace {

constexpr std::size_t binary_header = 84;    // 80 bytes of comment and the count
constexpr std::size_t binary_triangle = 50;  // normal, three corners, two bytes of attributes

template <typename Number>
Number little_endian(const char* bytes) {
  static_assert(std::endian::native == std::endian::little, "STL is little-endian");
  Number value;
  std::memcpy(&value, bytes, sizeof(Number));
  return value;
}

// STL repeats the corners of each triangle: equal ones become one vertex, so that smooth normals
// can be computed. Its facet normals are redundant and often wrong; they are not used.
class Welder {
 public:
  std::uint32_t vertex(const glm::dvec3& point) {
    const auto [it, is_new] =
        known_.try_emplace(point + 0.0, static_cast<std::uint32_t>(mesh.points.size()));
    if (is_new) mesh.points.push_back(point);
    return it->second;
  }

  RawMesh mesh;

 private:
  struct Hash {
    std::size_t operator()(const glm::dvec3& p) const {
      std::size_t hash = 0;
      for (int axis = 0; axis < 3; ++axis) {
        hash = hash * 0x9e3779b97f4a7c15u + std::hash<double>{}(p[axis]);
      }
      return hash ^ hash >> 32;
    }
  };
  std::unordered_map<glm::dvec3, std::uint32_t, Hash> known_;
};

RawMesh read_binary(const std::filesystem::path& file, std::string_view bytes) {
  const std::size_t count = little_endian<std::uint32_t>(bytes.data() + 80);
  Welder welder;
  for (std::size_t i = 0; i < count; ++i) {
    const char* position = bytes.data() + binary_header + i * binary_triangle + 12;
    std::array<std::uint32_t, 3> corners{};
    for (std::uint32_t& corner : corners) {
      const glm::dvec3 point(little_endian<float>(position), little_endian<float>(position + 4),
                             little_endian<float>(position + 8));
      check_point(file, "triangle " + std::to_string(i), point);
      corner = welder.vertex(point);
      position += 12;
    }
    add_polygon(welder.mesh, corners);
  }
  return std::move(welder.mesh);
}

std::string upper_case(std::string_view text) {
  std::string result(text);
  std::ranges::transform(result, result.begin(),
                         [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  return result;
}

RawMesh read_ascii(const std::filesystem::path& file, std::string_view bytes) {
  TextScanner scanner(bytes);
  Welder welder;
  std::vector<std::uint32_t> corners;
  bool has_ended = false;  // the last of the solids
  for (std::string_view token = scanner.token_ahead(); !token.empty();
       token = scanner.token_ahead()) {
    const std::string keyword = upper_case(token);
    if (keyword == "VERTEX") {
      corners.push_back(welder.vertex(read_point(file, scanner)));
    } else if (keyword == "ENDFACET") {
      if (corners.size() != 3) {
        throw InputError(
            file, scanner.place(),
            "found a facet of " + std::to_string(corners.size()) + " vertices; allowed: 3");
      }
      add_polygon(welder.mesh, corners);
      corners.clear();
    } else if (keyword == "NORMAL") {
      read_normal(scanner);
    } else if (keyword == "SOLID" || keyword == "ENDSOLID") {
      has_ended = keyword == "ENDSOLID";
      scanner.skip_line();  // its name
    } else if (keyword != "FACET" && keyword != "OUTER" && keyword != "LOOP" &&
               keyword != "ENDLOOP") {
      throw InputError(file, scanner.place(), "unknown keyword " + quoted_text(token));
    }
  }
  if (!has_ended) throw InputError(file, scanner.place(), "the file ends without endsolid");
  return std::move(welder.mesh);
}

// Whether a file begins with "solid" and goes on as text: the comment of binary ones may, too.
bool is_ascii(std::string_view bytes) {
  if (upper_case(TextScanner(bytes).token_ahead()) != "SOLID") return false;
  const std::string_view begin = bytes.substr(0, 1024);
  return begin.find('\0') == begin.npos;
}

}  // namespace

RawMesh read_stl(const std::filesystem::path& file, std::string_view bytes) {
  std::size_t expected = 0;
  if (bytes.size() >= binary_header) {
    expected = binary_header +
               std::size_t{little_endian<std::uint32_t>(bytes.data() + 80)} * binary_triangle;
    if (bytes.size() == expected) return read_binary(file, bytes);
  }
  if (is_ascii(bytes)) return read_ascii(file, bytes);
  // Some programs add something at the end.
  if (expected > binary_header && bytes.size() > expected) return read_binary(file, bytes);
  throw InputError(
      file, "header",
      "found " + std::to_string(bytes.size()) + " bytes; allowed: an ascii STL, or " +
          (expected == 0 ? "a binary one of 84 bytes or more"
                         : std::to_string(expected) + " bytes for its triangle count"));
}

}  // namespace brume
