// The light that surfaces send to the eye where all of them are diffuse.
const bool glossy = false;
#include "shade_surfaces.glsl"
