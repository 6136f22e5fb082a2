// The corners of a grid's cell that count beside surfaces, as grid_cells-inl.h has them.
#include "constants.glsl"

// The corner of a cell that decides: the one towards the eye. `layers`: NodeVisibility::Layers, with the
// sides as bits of the fourth.
int eye_corner(vec3 to_eye, ivec3 cell, ivec4 layers) {
  int corner = 0;
  for (int k = 0; k < 3; ++k) {
    const bool is_high = cell[k] == layers[k] ? ((layers.w >> k) & 1) != 0 : to_eye[k] > 0.0;
    corner |= is_high ? 1 << k : 0;
  }
  return corner;
}

// Drops the corners that surfaces hide from it, or from the next that is in no solid. The including
// file has corner_bits(): GridOcclusion::blocked() of the node whose values begin at `first`.
uint corner_bits(int first);

void hide_corners(int decides, int firsts[8], inout float weights[8]) {
  uint blocked = corner_bits(firsts[decides]);
  if (blocked == 0u) return;
  const int nearest = decides;
  for (int k = 0; k < 7 && (blocked & enclosed_bit) != 0u; ++k) {
    const int flips[7] = int[](1, 2, 4, 3, 5, 6, 7);
    const uint bits = corner_bits(firsts[nearest ^ flips[k]]);
    if ((bits & enclosed_bit) != 0u) continue;
    decides = nearest ^ flips[k];
    blocked = bits;
  }
  const ivec3 from = ivec3(decides & 1, (decides >> 1) & 1, decides >> 2);
  float sum = 0.0;
  for (int c = 0; c < 8; ++c) {
    const ivec3 offset = ivec3(c & 1, (c >> 1) & 1, c >> 2) - from + 1;
    const int link = (offset.z * 3 + offset.y) * 3 + offset.x;
    if (((blocked >> link) & 1u) != 0u) weights[c] = 0.0;
    sum += weights[c];
  }
  if (sum > 0.0) {
    for (int c = 0; c < 8; ++c) weights[c] /= sum;
  } else {
    weights[decides] = 1.0;
  }
}
