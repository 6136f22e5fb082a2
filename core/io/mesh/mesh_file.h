#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "brume/limits.h"
#include "core/scene/mesh.h"

namespace brume {

// Reads OBJ, PLY, STL or OFF by extension; polygons become triangles (triangulate()). Normals in
// the file are used, smooth ones (area-weighted, across seams of vertices at one place that are no
// edge of 60 degrees or more) computed where it has none (vertex_normals()). What is left out, as
// faces of an OBJ whose vertices are not there, is appended to `warnings`, a line each. Throws
// InputError: unreadable, no faces, coordinates that are not finite, a mesh of more than
// limits::scene_bytes.
std::shared_ptr<const TriangleMesh> read_mesh(const std::filesystem::path& file,
                                              std::vector<std::string>* warnings = nullptr);

}  // namespace brume
