#pragma once

#include <cstddef>
#include <string>

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

}  // namespace brume
