#pragma once

#include <string>

namespace brume::gl {

// Capacities of shaders: maximum slices per ray, and width and height of the texture of slice
// boundaries in floats.
constexpr int max_slices = 256;
constexpr int node_texture_width = 16384;
// Slices accumulated in registers at a time.
constexpr int slice_chunk = 8;
// Texels per row of the optics of Gaussians: rows for all that a scene may have.
constexpr int optics_width = 4096;

// Maximum radii of an optical depth table.
constexpr int max_table_radii = 1024;
// Work groups take so many times so many neighbouring rays from one point.
constexpr int bundle_side = 8;

// Work shared out by tile binning: entries that its counter of memory counts at once, and
// invocations per Gaussian.
constexpr unsigned coarse_entries = 256;
constexpr unsigned invocations_per_gaussian = 8;

// GLSL source of the constants shared with the CPU renderer, generated from the C++ ones. Arrays
// become `const float name[n]`.
std::string shader_constants();

}  // namespace brume::gl
