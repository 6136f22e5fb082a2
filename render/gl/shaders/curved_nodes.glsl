// Lists the nodes of curved cells: HalvedCells::nodes() of render/cpu/halved_cells.h, for one tile,
// after interpolate.glsl.
#include "upsampling.glsl"

// The flags of the cell right of and below a sample.
uint cell_flags(ivec2 sample_) {
  const ivec2 size = ivec2(tile_width, tile_height);
  const ivec2 tile = sample_ / size;
  if (any(greaterThanEqual(tile, tiles))) return 0u;
  const ivec2 place = sample_ % size;
  return curved_cells[(tile.y * tiles.x + tile.x) * group_size + place.y * tile_width + place.x];
}

void main() {
  const int id = int(gl_LocalInvocationID.x);
  const int tile = int(linear_group());
  if (tile >= tiles.x * tiles.y) return;  // uniform within the group
  const ivec2 sample_ = ivec2(tile % tiles.x, tile / tiles.x) * ivec2(tile_width, tile_height) +
                        ivec2(id % tile_width, id / tile_width);
  uint bits = 0u;
  if ((cell_flags(sample_) & curved_is_cell) != 0u) {
    // In five columns. Those on the right and below may be another cell's.
    bits = 1u << 2 | 1u << 10 | 1u << 12;
    const uint right = cell_flags(sample_ + ivec2(1, 0));
    const uint below = cell_flags(sample_ + ivec2(0, 1));
    if ((right & (curved_is_cell | evaluates_left)) == 0u) bits |= 1u << 14;
    if ((below & (curved_is_cell | evaluates_top)) == 0u) bits |= 1u << 22;
  }
  list_requests(tile, bits, sample_ * scale, 5);
}
