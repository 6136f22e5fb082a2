// Homogeneous fog where view rays are: see BatchFog.
#include "formulas.glsl"

uniform float b0;
uniform vec3 fog_center;   // relative to the eye
uniform float fog_radius;  // 0: everywhere

FogInterval fog_on_ray(vec3 w) { return fog_interval(-from_ray(fog_center), w, fog_radius); }
