// Surface shading with non-diffuse materials: a separate shader, since it needs several times as
// many registers.
const bool glossy = true;
const bool metallic = false;
#include "shade_surfaces.glsl"
