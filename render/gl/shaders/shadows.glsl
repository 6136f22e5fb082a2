// Shadows of surfaces in the medium, after lights.glsl.
layout(std430, binding = 6) readonly buffer Shadows { float shadows[]; };

// The share of the light that no surface stops, mixed over four cells.
float lit(int l, vec3 q, float distance_) {
  const MapPosition at = map_position(lights[l].shadows, q, distance_);
  const float near = distance_ * lights[l].shadow_share;
  const int row = map_stride(lights[l].shadows);
  const int first = lights[l].shadows.cells.z + at.cell;
  const vec4 free = vec4(greaterThanEqual(
      vec4(shadows[first], shadows[first + 1], shadows[first + row], shadows[first + row + 1]),
      vec4(near)));
  return mix(mix(free.x, free.y, at.f.x), mix(free.z, free.w, at.f.x), at.f.y);
}
