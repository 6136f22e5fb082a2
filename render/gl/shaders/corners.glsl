// The triangles of a scene, relative to the middle of the surfaces.
#include "constants.glsl"
#include "structs.glsl"

// Per triangle three corners with the surface index; then per triangle three vertex normals with
// the vertex indices of the mesh.
layout(std430, binding = 5) restrict readonly buffer Corners { TriangleCorner corners[]; };

uniform double surfaces_radius;  // of the ball around the middle that holds them

vec3 corner_of(int triangle, int k) { return corners[3 * triangle + k].vector; }

// RayCaster::is_near()
bool is_near(dvec3 origin) { return length(origin) < near_radii * surfaces_radius; }
