// Surface shading with diffuse materials only.
const bool glossy = false;
const bool metallic = false;
#include "shade_surfaces.glsl"
