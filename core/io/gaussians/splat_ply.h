#pragma once

#include <filesystem>
#include <span>
#include <string>

#include "brume/gaussian.h"
#include "core/io/gaussians/splat_output.h"

namespace brume {

// Writes Gaussians as the splats of a binary little-endian PLY of floats, as "3D Gaussian Splatting
// for Real-Time Radiance Field Rendering" (Kerbl et al. 2023) stores them: x y z, normals of 0,
// f_dc_0 to f_dc_2, the logit of the opacity, logarithms of the standard deviations, and a
// quaternion, real part first. With colors of their own f_rest_0 to f_rest_44 follow f_dc, of each
// channel bands 1 to 3, in the signs of the Condon-Shortley phase. Ids are the last property, uint.
// read_gaussians_ply() reads their shapes, densities and ids back.
std::string splats_ply(std::span<const Gaussian> gaussians, const SplatOutput& output = {});
void write_splats_ply(const std::filesystem::path& file, std::span<const Gaussian> gaussians,
                      const SplatOutput& output = {});

}  // namespace brume
