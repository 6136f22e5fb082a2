#pragma once

#include <string>

namespace brume::gl {

// What shaders have room for: slices per ray that a user may ask for, and floats in a row and in a
// column of the texture that holds their boundaries.
constexpr int most_slices = 256;
constexpr int node_texture_width = 16384;
// Slices whose sums are in registers at a time.
constexpr int slice_chunk = 8;

// The numbers that shaders share with render/cpu, as GLSL: made from the C++ ones, so that no
// formula has two sets of them. Arrays become `const float name[n]`.
std::string shader_constants();

}  // namespace brume::gl
