// Surface shading with diffuse materials only.
const bool glossy = false;
#include "shade_surfaces.glsl"
