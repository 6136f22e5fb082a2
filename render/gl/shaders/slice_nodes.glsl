// Where a texture has the boundaries of nodes, one after the other: of each their number and room for
// `stride` of them.
ivec2 node_texel(int place) { return ivec2(place % node_texture_width, place / node_texture_width); }
