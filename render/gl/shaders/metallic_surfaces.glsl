// Surface shading with all materials, metallic-roughness ones as materials.glsl has found them.
const bool glossy = true;
const bool metallic = true;
#include "shade_surfaces.glsl"
