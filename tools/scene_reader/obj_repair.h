#pragma once

#include <cstddef>
#include <string>

struct aiScene;

namespace brume {

// Repairs what assimp may refuse an OBJ for: faces that are none (core/io/mesh/obj_corner.h), and
// points and lines, which are left out anyway, become blanks; faces with texture coordinates or
// normals that the file does not have lose theirs.
struct ObjRepair {
  std::size_t bad_faces = 0;
  std::string first_line;  // where the first of them is
  bool has_changed = false;
};
ObjRepair repair_obj(std::string& text);

// Cuts the polygons of a scene's meshes into triangles as those of mesh files are (triangulate()):
// assimp's own step fills some concave ones. The indices of the faces have been checked.
void cut_polygons(aiScene& scene);

}  // namespace brume
