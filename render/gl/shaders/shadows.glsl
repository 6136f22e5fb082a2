// Shadows of surfaces in the medium, after lights.glsl.
layout(std430, binding = 6) restrict readonly buffer Shadows { float shadows[]; };

// Visibility, bilinear over four cells (percentage-closer filtering).
float lit(int l, vec3 q, float distance_) {
  const MapPosition position = map_position(lights[l].shadows, q, lights[l].in_shadows.xyz, distance_);
  const float depth = lights[l].shadows.axis.w > 0.5
      ? distance_ : dot(q, lights[l].shadows.axis.xyz) + lights[l].in_shadows.w;
  const float biased_depth = depth - distance_ * lights[l].shadow_bias;
  const int row = map_stride(lights[l].shadows);
  const int first = lights[l].shadows.cells.z + position.cell;
  const vec4 free = vec4(greaterThanEqual(
      vec4(shadows[first], shadows[first + 1], shadows[first + row], shadows[first + row + 1]),
      vec4(biased_depth)));
  return mix(mix(free.x, free.y, position.f.x), mix(free.z, free.w, position.f.x), position.f.y);
}
