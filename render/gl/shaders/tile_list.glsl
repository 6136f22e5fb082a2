// Gaussians relative to the eye, and the list of each tile.
#include "constants.glsl"
#include "structs.glsl"

layout(local_size_x = group_size) in;

layout(std430, binding = 2) restrict readonly buffer Seen { SeenGaussian seen[]; };
layout(std430, binding = 3) restrict readonly buffer Offsets { uint offsets[]; };
layout(std430, binding = 4) restrict readonly buffer Entries { uint list[]; };
