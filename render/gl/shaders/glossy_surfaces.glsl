// The light that surfaces send to the eye where some are not diffuse: a shader of its own, since it
// needs several times as much memory for each pixel.
const bool glossy = true;
#include "shade_surfaces.glsl"
