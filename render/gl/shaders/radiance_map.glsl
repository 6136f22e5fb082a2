// Where a direction lies in an equirectangular map: radiance_of() in core/scene/lights/radiance_map.cpp.
#include "constants.glsl"

struct MapTexels {
  ivec4 index;  // upper left, upper right, lower left, lower right
  vec2 f;       // how far to the right and down
};

MapTexels map_texels(ivec2 size, vec3 d) {
  const float polar = atan(length(d.xz), d.y);
  const float azimuth = atan(d.x, -d.z);
  const vec2 position = vec2(0.5 + azimuth / (2.0 * pi), polar / pi) * vec2(size) - 0.5;
  const vec2 low = floor(position);
  const int x0 = (int(low.x) + size.x) % size.x;
  const int x1 = (x0 + 1) % size.x;
  const int y0 = clamp(int(low.y), 0, size.y - 1) * size.x;
  const int y1 = clamp(int(low.y) + 1, 0, size.y - 1) * size.x;
  return MapTexels(ivec4(y0 + x0, y0 + x1, y1 + x0, y1 + x1), position - low);
}

// The direction in a map that is turned about y; `rotation`: cosine and sine.
vec3 turned_to_map(vec2 rotation, vec3 w) {
  return vec3(rotation.x * w.x - rotation.y * w.z, w.y, rotation.y * w.x + rotation.x * w.z);
}
