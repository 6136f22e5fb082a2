#pragma once

struct aiScene;

namespace brume {

// Cuts the polygons of a scene's meshes into triangles as those of mesh files are (triangulate()):
// assimp's own step fills some concave ones. The indices of the faces have been checked.
void cut_polygons(aiScene& scene);

}  // namespace brume
