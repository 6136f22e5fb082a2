#pragma once

#include <filesystem>
#include <glm/mat4x4.hpp>
#include <string>

#include "brume/camera.h"
#include "brume/mesh_arrays.h"

namespace brume {

// Moves a mesh from its node into the file's coordinates, whatever the transform: normals stay
// perpendicular, triangles face the same side when mirrored. Normals become unit; where one has no
// direction, that of its triangles is taken, 0 if those have none in all. Throws InputError
// (`place` for errors): a point that is no coordinate of a scene.
void apply_transform(const glm::dmat4& to_world, const std::filesystem::path& file,
                     const std::string& place, MeshArrays& mesh);

// The camera of a node: it looks along -z, +y is up. Its target is as far as `pivot`, if that is in
// front of it.
Camera camera_of_node(const glm::dmat4& to_world, const glm::dvec3& pivot, double vertical_fov);

}  // namespace brume
