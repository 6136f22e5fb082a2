#include <unordered_map>

#include "brume/error.h"
#include "core/io/mesh/mesh_readers.h"
#include "core/io/mesh/obj_corner.h"
#include "core/io/text_scanner.h"

namespace brume {
namespace {

class ObjReader {
 public:
  ObjReader(const std::filesystem::path& file, std::string_view bytes)
      : file_(file), scanner_(bytes, true), counts_(count_obj(bytes)) {}

  RawMesh read() {
    check_has_faces(file_, counts_);
    while (scanner_.next_line()) {
      const std::string_view keyword = scanner_.next_token();
      if (keyword == "v") {
        points_.push_back(read_point(file_, scanner_));
        read_color();
      } else if (keyword == "vn") {
        normals_.push_back(read_normal(scanner_));
      } else if (keyword == "vt") {
        texcoords_.push_back(read_texcoord(scanner_));
      } else if (keyword == "f") {
        read_face();
      }  // everything else is no shape: group, material, line
    }
    fill_vertices();
    if (bad_faces_ > 0) {
      mesh_.warnings.emplace_back(
          InputError(file_, bad_face_line_, bad_obj_faces(bad_faces_)).what());
    }
    return std::move(mesh_);
  }

 private:
  struct Hash {
    std::size_t operator()(const ObjCorner& corner) const {
      std::uint64_t hash = 0;
      for (const auto& index : {corner.point, corner.normal, corner.texcoord}) {
        hash = (hash ^ (index ? *index + std::uint64_t{1} : 0)) * 0x9e3779b97f4a7c15u;
      }
      return hash ^ hash >> 32;
    }
  };

  // Reads what may follow a point, `r g b`; all vertices before the first with a color are white.
  void read_color() {
    glm::dvec4 color(1.0);
    for (int k = 0; k < 3; ++k) {
      const std::optional<double> value = parse_number(scanner_.next_token());
      if (!value) {
        if (!colors_.empty()) colors_.emplace_back(1.0f);
        return;
      }
      color[k] = *value;
    }
    colors_.resize(points_.size() - 1, glm::vec4(1.0f));
    colors_.push_back(linear_color(color));
  }

  void read_face() {
    const std::string line = scanner_.place();
    const ObjCounts before{points_.size(), texcoords_.size(), normals_.size()};
    face_.clear();
    for (std::string_view token = scanner_.next_token(); !token.empty() && token[0] != '#';
         token = scanner_.next_token()) {
      // Many programs write indices of texture coordinates and normals without any: those count for
      // nothing.
      face_.push_back(read_obj_corner(token, before, counts_));
    }
    if (!is_obj_face(face_)) {
      if (++bad_faces_ == 1) bad_face_line_ = line;
      return;
    }
    polygon_.clear();
    for (const ObjCorner& corner : face_) polygon_.push_back(vertex_of(corner));
    add_polygon(mesh_, polygon_);
  }

  // The vertex that joins a point, a normal and texture coordinates: a point on a crease has
  // several normals, on a seam several coordinates, and becomes several vertices.
  std::uint32_t vertex_of(const ObjCorner& corner) {
    const auto [it, is_new] =
        vertices_.try_emplace(corner, static_cast<std::uint32_t>(corners_.size()));
    if (is_new) corners_.push_back(corner);
    return it->second;
  }

  void fill_vertices() {
    mesh_.points.reserve(corners_.size());
    if (!normals_.empty()) mesh_.normals.reserve(corners_.size());
    if (!texcoords_.empty()) mesh_.texcoords.reserve(corners_.size());
    if (!colors_.empty()) mesh_.colors.reserve(corners_.size());
    for (const ObjCorner& corner : corners_) {
      if (!colors_.empty()) mesh_.colors.push_back(colors_[*corner.point]);
      mesh_.points.push_back(points_[*corner.point]);
      if (!normals_.empty()) {
        mesh_.normals.push_back(corner.normal ? normals_[*corner.normal] : glm::dvec3(0.0));
      }
      if (texcoords_.empty()) continue;
      mesh_.texcoords.push_back(corner.texcoord ? texcoords_[*corner.texcoord] : glm::vec2(0.0f));
      mesh_.file_points.push_back(*corner.point);
    }
  }

  const std::filesystem::path& file_;
  TextScanner scanner_;
  ObjCounts counts_;
  std::vector<glm::dvec3> points_;
  std::vector<glm::dvec3> normals_;
  std::vector<glm::vec4> colors_;
  std::vector<glm::vec2> texcoords_;
  std::vector<ObjCorner> corners_;
  std::unordered_map<ObjCorner, std::uint32_t, Hash> vertices_;
  std::vector<ObjCorner> face_;
  std::vector<std::uint32_t> polygon_;
  std::size_t bad_faces_ = 0;
  std::string bad_face_line_;
  RawMesh mesh_;
};

}  // namespace

RawMesh read_obj(const std::filesystem::path& file, std::string_view bytes) {
  return ObjReader(file, bytes).read();
}

}  // namespace brume
