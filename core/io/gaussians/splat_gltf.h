#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "brume/gaussian.h"
#include "brume/limits.h"
#include "core/io/gaussians/splat_output.h"

namespace brume {

// Splats of glTF 2.0 as the extension KHR_gaussian_splatting has them, with the kernel `ellipse`:
// points whose attributes are positions, quaternions (real part last), standard deviations and
// opacities in [0, 1]. y is up, as in Brume.

// Reads the splats of all nodes of the file's scene, where these place them; one of opacity 1 is as
// deep as a float below 1 can tell, 17.3. Throws InputError naming the JSON path, also for more
// than `max_count` and for splats that are compressed; splats that are none are left out
// (DroppedSplats).
std::vector<Gaussian> read_splats_gltf(const std::filesystem::path& file,
                                       std::size_t max_count = limits::gaussians,
                                       const SplatInput& input = {},
                                       std::vector<std::string>* warnings = nullptr);

// Whether a file says that it has splats, of whatever kind: read_splats_gltf() may refuse them.
bool has_splats_gltf(const std::filesystem::path& file);

// How many splats read_splats_gltf() would read.
std::size_t splat_count_gltf(const std::filesystem::path& file);

// Writes one node of splats, of floats: binary if the extension is .glb, else text with the numbers
// in it. An opacity has the precision of a float below 1: a depth d is read back with a relative
// error of 6e-8 exp(d) / d, and one above 17.3 as that.
void write_splats_gltf(const std::filesystem::path& file, std::span<const Gaussian> gaussians,
                       const SplatOutput& output = {});

}  // namespace brume
