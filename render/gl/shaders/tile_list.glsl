// Gaussians relative to the eye, and the list of each tile.
layout(local_size_x = 128) in;

layout(std430, binding = 2) readonly buffer Seen { vec4 seen[]; };
layout(std430, binding = 3) readonly buffer Offsets { uint offsets[]; };
layout(std430, binding = 4) readonly buffer Entries { uint list[]; };
