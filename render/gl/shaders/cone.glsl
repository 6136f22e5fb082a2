// The cone around the rays of a work group that start at one point, and what touches it.
#include "constants.glsl"

// A sum of directions that is shorter has no center.
const float min_length = 1e-3;
// Roundings of cosines and distances.
const float cosine_rounding = 1e-6;
const float distance_share = 1.0001;

shared vec4 axis;                     // of the cone, and the cosine of its half angle
shared vec3 directions[bundle_size];  // of the rays, unit; 0: there is none

// Where this invocation's ray stands among those of all groups.
ivec2 place_in_bundle() {
  const int id = int(gl_LocalInvocationID.x);
  return ivec2(gl_WorkGroupID.xy) * bundle_side + ivec2(id % bundle_side, id / bundle_side);
}

// Called by one invocation when all directions are set.
void find_cone() {
  vec3 sum = vec3(0.0);
  for (int i = 0; i < bundle_size; ++i) sum += directions[i];
  // Rays all around have no middle; then everything touches them.
  const float length_ = length(sum);
  float cosine = -1.0;
  if (length_ > min_length) {
    sum /= length_;
    cosine = 1.0;
    for (int i = 0; i < bundle_size; ++i) {
      if (directions[i] != vec3(0.0)) cosine = min(cosine, dot(sum, directions[i]));
    }
  }
  axis = vec4(sum, cosine - cosine_rounding);
}

// A ball around b, seen from where the rays start.
bool touches_cone(vec3 b, float cutoff_radius) {
  if (axis.w <= 0.0) return true;
  const float along = dot(b, axis.xyz);
  const float across = length(b - along * axis.xyz);
  return across * axis.w - along * sqrt(max(1.0 - axis.w * axis.w, 0.0)) <= distance_share * cutoff_radius;
}
