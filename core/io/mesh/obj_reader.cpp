#include <limits>
#include <unordered_map>

#include "brume/error.h"
#include "core/io/mesh/mesh_readers.h"
#include "core/io/text_scanner.h"

namespace brume {
namespace {

constexpr std::int64_t none = -1;

// A 1-based or, from the end of what was read so far, negative OBJ index as one from 0.
std::optional<std::int64_t> resolved(std::string_view token, std::size_t count) {
  const std::optional<std::int64_t> index = parse_integer(token);
  if (!index || *index == 0 || *index > std::numeric_limits<std::int32_t>::max()) return {};
  if (*index > 0) return *index - 1;
  const std::int64_t from_end = *index + static_cast<std::int64_t>(count);
  return from_end >= 0 ? std::optional(from_end) : std::nullopt;
}

class ObjReader {
 public:
  ObjReader(const std::filesystem::path& file, std::string_view bytes)
      : file_(file), scanner_(bytes) {}

  RawMesh read() {
    while (scanner_.next_line()) {
      const std::string_view keyword = scanner_.next_token();
      if (keyword == "v") {
        points_.push_back(read_point(file_, scanner_));
      } else if (keyword == "vn") {
        normals_.push_back(read_normal(scanner_));
      } else if (keyword == "vt") {
        texcoords_.push_back(read_texcoord(scanner_));
      } else if (keyword == "f") {
        read_face();
      }  // everything else is no shape: group, material, line
    }
    check_range(max_point_, points_.size(), "vertex", point_line_);
    check_range(max_normal_, normals_.size(), "normal", normal_line_);
    fill_vertices();
    return std::move(mesh_);
  }

 private:
  struct Corner {
    std::int64_t point;
    std::int64_t normal;
    std::int64_t texcoord;

    bool operator==(const Corner&) const = default;
  };
  struct Hash {
    std::size_t operator()(const Corner& corner) const {
      std::uint64_t hash = 0;
      for (const std::int64_t index : {corner.point, corner.normal, corner.texcoord}) {
        hash = (hash ^ static_cast<std::uint64_t>(index)) * 0x9e3779b97f4a7c15u;
      }
      return hash ^ hash >> 32;
    }
  };

  [[noreturn]] void fail(const std::string& message) {
    throw InputError(file_, scanner_.place(), message);
  }

  // v, v/t, v//n or v/t/n
  void read_face() {
    face_.clear();
    for (std::string_view token = scanner_.next_token(); !token.empty() && token[0] != '#';
         token = scanner_.next_token()) {
      const std::size_t slash = token.find('/');
      const std::size_t second = slash == token.npos ? token.npos : token.find('/', slash + 1);
      const auto point = resolved(token.substr(0, slash), points_.size());
      Corner corner{none, none, none};
      if (!point) fail("found the vertex index " + quoted_text(token) + "; allowed: " + allowed());
      corner.point = *point;
      if (second != token.npos && second + 1 < token.size()) {
        const auto normal = resolved(token.substr(second + 1), normals_.size());
        if (!normal) fail("found the normal index " + quoted_text(token) + "; allowed: 1 or more");
        corner.normal = *normal;
      }
      if (slash != token.npos) {
        // Many programs write indices without any coordinates: those count for nothing.
        const std::string_view texcoord = token.substr(slash + 1, second - slash - 1);
        corner.texcoord = resolved(texcoord, texcoords_.size()).value_or(none);
      }
      face_.push_back(vertex_of(corner));
    }
    if (face_.size() < 3) {
      fail("found a face of " + std::to_string(face_.size()) + " vertices; allowed: 3 or more");
    }
    add_polygon(mesh_, face_);
  }

  // The vertex that joins a point, a normal and texture coordinates: a point on a crease has
  // several normals, on a seam several coordinates, and becomes several vertices. Positive indices
  // may run ahead, so ranges are checked at the end.
  std::uint32_t vertex_of(const Corner& corner) {
    if (corner.point > max_point_) {
      max_point_ = corner.point;
      point_line_ = scanner_.place();
    }
    if (corner.normal > max_normal_) {
      max_normal_ = corner.normal;
      normal_line_ = scanner_.place();
    }
    const auto [it, is_new] =
        vertices_.try_emplace(corner, static_cast<std::uint32_t>(corners_.size()));
    if (is_new) corners_.push_back(corner);
    return it->second;
  }

  [[nodiscard]] std::string allowed() const {
    return "1 to the number of vertices, or -1 to -" + std::to_string(points_.size());
  }

  void check_range(std::int64_t max_index, std::size_t count, const char* label,
                   const std::string& line) const {
    if (max_index < static_cast<std::int64_t>(count)) return;
    throw InputError(file_, line,
                     std::string("found the ") + label + " index " + std::to_string(max_index + 1) +
                         "; allowed: at most " + std::to_string(count));
  }

  void fill_vertices() {
    mesh_.points.reserve(corners_.size());
    if (!normals_.empty()) mesh_.normals.reserve(corners_.size());
    if (!texcoords_.empty()) mesh_.texcoords.reserve(corners_.size());
    for (const Corner& corner : corners_) {
      mesh_.points.push_back(points_[static_cast<std::size_t>(corner.point)]);
      if (!normals_.empty()) mesh_.normals.push_back(at(normals_, corner.normal, glm::dvec3(0.0)));
      if (texcoords_.empty()) continue;
      mesh_.texcoords.push_back(at(texcoords_, corner.texcoord, glm::vec2(0.0f)));
      mesh_.file_points.push_back(static_cast<std::uint32_t>(corner.point));
    }
  }

  template <class Value>
  static Value at(const std::vector<Value>& values, std::int64_t index, const Value& missing) {
    const auto i = static_cast<std::size_t>(index);
    return index != none && i < values.size() ? values[i] : missing;
  }

  const std::filesystem::path& file_;
  TextScanner scanner_;
  std::vector<glm::dvec3> points_;
  std::vector<glm::dvec3> normals_;
  std::vector<glm::vec2> texcoords_;
  std::vector<Corner> corners_;
  std::unordered_map<Corner, std::uint32_t, Hash> vertices_;
  std::vector<std::uint32_t> face_;
  std::int64_t max_point_ = none;
  std::int64_t max_normal_ = none;
  std::string point_line_;
  std::string normal_line_;
  RawMesh mesh_;
};

}  // namespace

RawMesh read_obj(const std::filesystem::path& file, std::string_view bytes) {
  return ObjReader(file, bytes).read();
}

}  // namespace brume
