#pragma once

#include <string>

namespace brume::gl {

// What shaders have room for: slices per ray that a user may ask for, and where slices of a tile
// may begin and end in all.
constexpr int most_slices = 256;
constexpr int most_boundaries = 1024;
// Slices whose sums are in registers at a time.
constexpr int slice_chunk = 8;

// The numbers that shaders share with render/cpu, as GLSL: made from the C++ ones, so that no
// formula has two sets of them. Arrays become `const float name[n]`.
std::string shader_constants();

}  // namespace brume::gl
