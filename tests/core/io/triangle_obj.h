#pragma once

namespace brume {

// An OBJ file of one triangle.
inline constexpr const char* triangle_obj = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";

}  // namespace brume
