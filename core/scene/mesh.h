#pragma once

#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>

namespace brume {

// Triangles with vertex normals, unit or 0 (the triangle's own), and perhaps texture coordinates
// (texcoord2D; u to the right, v up), in the mesh file's own coordinates [u]. A class of its own so
// that other headers can name it without OpenMesh's headers (forward declaration).
struct TriangleMesh : OpenMesh::TriMesh_ArrayKernelT<OpenMesh::DefaultTraits> {};

}  // namespace brume
