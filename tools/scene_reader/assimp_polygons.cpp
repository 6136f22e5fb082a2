#include "tools/scene_reader/assimp_polygons.h"

#include <assimp/scene.h>

#include <algorithm>
#include <span>
#include <utility>
#include <vector>

#include "core/io/mesh/triangulate.h"

namespace brume {
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
