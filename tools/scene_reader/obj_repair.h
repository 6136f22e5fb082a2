#pragma once

#include <cstddef>
#include <string>

namespace brume {

// What assimp refuses an OBJ for: faces that are none (core/io/mesh/obj_corner.h), which blanks
// replace, and indices of texture coordinates or normals that the file does not have, which go from
// their faces with all others of that kind.
struct ObjRepair {
  std::size_t bad_faces = 0;
  std::string first_line;  // where the first of them is
  bool has_changed = false;
};
ObjRepair repair_obj(std::string& text);

}  // namespace brume
