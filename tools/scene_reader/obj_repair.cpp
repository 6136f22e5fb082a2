#include "tools/scene_reader/obj_repair.h"

#include <assimp/scene.h>
#include <algorithm>
#include <span>
#include <utility>
#include <vector>

#include "core/io/mesh/obj_corner.h"
#include "core/io/mesh/triangulate.h"
#include "core/io/text_scanner.h"

namespace brume {
namespace {

class Repair {
 public:
  explicit Repair(std::string& text) : text_(text), scanner_(text, true), all_(count_obj(text)) {}

  ObjRepair run() {
    while (scanner_.next_line()) {
      const std::string_view keyword = scanner_.next_token();
      if (keyword == "f") repair_face(keyword);
      if (keyword == "l" || keyword == "p") blank_element(keyword);
      before_.add(keyword);
    }
    return result_;
  }

 private:
  void repair_face(std::string_view keyword) {
    const std::string line = scanner_.place();
    tokens_.clear();
    corners_.clear();
    bool has_bad_index = false;
    for (std::string_view token = scanner_.next_token(); !token.empty() && token[0] != '#';
         token = scanner_.next_token()) {
      const ObjCorner& corner = corners_.emplace_back(read_obj_corner(token, before_, all_));
      tokens_.push_back(token);
      const auto slashes = std::ranges::count(token, '/');
      const bool has_texcoord = slashes > 0 && token.find("//") == token.npos;
      has_bad_index =
          has_bad_index || (has_texcoord && !corner.texcoord) || (slashes == 2 && !corner.normal);
    }
    const bool is_face = is_obj_face(corners_);
    if (is_face && !has_bad_index) return;
    result_.has_changed = true;
    if (!is_face) {
      blank(keyword);
      if (++result_.bad_faces == 1) result_.first_line = line;
    }
    for (const std::string_view token : tokens_) {
      blank(is_face ? token.substr(std::min(token.find('/'), token.size())) : token);
    }
  }

  void blank_element(std::string_view keyword) {
    result_.has_changed = true;
    for (std::string_view token = keyword; !token.empty(); token = scanner_.next_token()) {
      blank(token);
    }
  }

  void blank(std::string_view part) {
    std::fill_n(text_.begin() + (part.data() - text_.data()), part.size(), ' ');
  }

  std::string& text_;
  TextScanner scanner_;
  ObjCounts all_;
  ObjCounts before_;
  ObjRepair result_;
  std::vector<std::string_view> tokens_;
  std::vector<ObjCorner> corners_;
};

}  // namespace

ObjRepair repair_obj(std::string& text) {
  return Repair(text).run();
}

namespace {

bool is_polygon(const aiFace& face) {
  return face.mNumIndices > 3;
}

aiFace to_face(const glm::uvec3& triangle) {
  aiFace face;
  face.mNumIndices = 3;
  face.mIndices = new unsigned[3]{triangle.x, triangle.y, triangle.z};
  return face;
}

void cut_polygons(aiMesh& mesh) {
  std::span faces(mesh.mFaces, mesh.mNumFaces);
  if (std::ranges::none_of(faces, is_polygon)) return;
  RawMesh polygons;
  for (unsigned i = 0; i < mesh.mNumVertices; ++i) {
    const aiVector3D& p = mesh.mVertices[i];
    polygons.points.emplace_back(p.x, p.y, p.z);
  }
  std::vector<aiFace> cut;
  for (aiFace& face : faces) {
    if (is_polygon(face)) {
      add_polygon(polygons, std::span<const unsigned>(face.mIndices, face.mNumIndices));
    } else {
      std::swap(cut.emplace_back(), face);
    }
  }
  for (const glm::uvec3& triangle : triangulate(polygons).triangles) {
    cut.push_back(to_face(triangle));
  }
  delete[] mesh.mFaces;
  mesh.mNumFaces = static_cast<unsigned>(cut.size());
  mesh.mFaces = new aiFace[cut.size()];
  std::ranges::swap_ranges(cut, std::span(mesh.mFaces, mesh.mNumFaces));
  mesh.mPrimitiveTypes &= ~static_cast<unsigned>(aiPrimitiveType_POLYGON);
  mesh.mPrimitiveTypes |= aiPrimitiveType_TRIANGLE;
}

}  // namespace

void cut_polygons(aiScene& scene) {
  for (aiMesh* const mesh : std::span(scene.mMeshes, scene.mNumMeshes)) cut_polygons(*mesh);
}

}  // namespace brume
