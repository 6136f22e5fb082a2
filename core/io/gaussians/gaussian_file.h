#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "brume/gaussian.h"
#include "brume/limits.h"
#include "brume/medium.h"
#include "brume/splat.h"
#include "core/io/gaussians/splat_output.h"

namespace brume {

// Reads Gaussians from PLY, CSV or glTF (of splats), detected by the first bytes. Throws InputError
// naming file and place. `ids` gets the persistent ids of a sequence's Gaussians, if present. More
// than `max_count` are an error. Splats that are none (DroppedSplats) are left out, which
// `warnings` tells.
std::vector<Gaussian> read_gaussians(const std::filesystem::path& file,
                                     std::vector<GaussianNumber>* ids = nullptr,
                                     std::size_t max_count = limits::gaussians,
                                     const SplatInput& splats = {},
                                     std::vector<std::string>* warnings = nullptr);

// The same of a file whose ids may be missing, or no ids but another program's words: then there
// are none in `ids`.
std::vector<Gaussian> read_with_ids(const std::filesystem::path& file,
                                    std::vector<GaussianNumber>& ids, const SplatInput& splats = {},
                                    std::vector<std::string>* warnings = nullptr);

// The ids of a medium's Gaussians, to be written with them: none if they are 1, 2, 3 and so on, as
// those of a file without ids become, or beyond 32 bits.
std::vector<GaussianNumber> written_ids(const Medium& medium);

// How many Gaussians a file has at most, without reading them all: by the header of a PLY, by the
// lines of a CSV, by the JSON of a glTF. Throws InputError.
std::size_t max_gaussian_count(const std::filesystem::path& file);

// Whether it has splats: by the header of a PLY, by the JSON of a glTF, where read_gaussians() may
// still refuse them. Throws InputError.
bool has_splats(const std::filesystem::path& file);

// Reads Gaussians of a scene with `max_group` groups: the column `group`, if there are groups and
// it is present, has the numbers that become theirs. `ids`: as of read_with_ids().
std::vector<Gaussian> read_grouped_gaussians(const std::filesystem::path& file,
                                             std::size_t max_count, std::size_t max_group,
                                             std::vector<GaussianNumber>& ids,
                                             std::vector<std::string>* warnings = nullptr);

// Writes CSV if the extension is .csv, else PLY, lossless; but splats if it is .glb or .gltf.
void write_gaussians(const std::filesystem::path& file, std::span<const Gaussian> gaussians,
                     std::span<const GaussianNumber> ids = {});

// Writes them as splats, for programs of Gaussian splatting: glTF if the extension is .glb or
// .gltf, else PLY.
void write_splats(const std::filesystem::path& file, std::span<const Gaussian> gaussians,
                  const SplatOutput& output = {});

}  // namespace brume
