#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "brume/gaussian.h"
#include "brume/limits.h"
#include "brume/splat.h"

namespace brume {

// Gaussians as PLY points, ascii or binary of either byte order; other properties and elements are
// skipped. A vertex has x y z radius density, or what Gaussian splatting stores: x y z, scale_0 to
// scale_2 (logarithms of standard deviations), rot_0 to rot_3 (a quaternion, real part first), and
// the logit of an opacity o, so that the depth is -ln(1 - o); see gaussian_of() for `along`.
// Without rot_0 to rot_3 nothing is turned, without scale_2 splats are discs, without scale_1
// balls. f_dc_0 to f_dc_2 become albedos if these are wanted, other colors are skipped. Throws
// InputError naming file and vertex; splats that are none are left out (DroppedSplats).
//
// `ids` and `groups` get the numbers of the properties id and group, where points have them. More
// than `max_count` are refused.
std::vector<Gaussian> read_gaussians_ply(const std::filesystem::path& file,
                                         std::vector<GaussianNumber>* ids = nullptr,
                                         std::size_t max_count = limits::gaussians,
                                         std::vector<GaussianNumber>* groups = nullptr,
                                         const SplatInput& splats = {},
                                         std::vector<std::string>* warnings = nullptr);

// Whether its header tells of splats.
bool has_splats_ply(const std::filesystem::path& file);

// How many Gaussians its header tells of at most.
std::size_t max_gaussian_count_ply(const std::filesystem::path& file);

// Writes binary little-endian PLY in double precision, lossless, with ids if given (as many as
// Gaussians).
void write_gaussians_ply(const std::filesystem::path& file, std::span<const Gaussian> gaussians,
                         std::span<const GaussianNumber> ids = {});

}  // namespace brume
