#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "brume/gaussian.h"
#include "brume/limits.h"

namespace brume {

// Reads Gaussians from a table (CsvTable) whose heading names the columns, among them x, y, z,
// radius and density (or alternatives, see gaussian_columns.h) in any order; other columns are
// skipped. `ids` and `groups` get the numbers of the columns id and group, where there are such.
// Throws InputError naming file and line, also for more than `max_count`.
std::vector<Gaussian> read_gaussians_csv(const std::filesystem::path& file,
                                         std::vector<GaussianNumber>* ids = nullptr,
                                         std::size_t max_count = limits::gaussians,
                                         std::vector<GaussianNumber>* groups = nullptr);
// The same of its bytes; the name is for errors.
std::vector<Gaussian> parse_gaussians_csv(const std::filesystem::path& file, std::string bytes,
                                          std::vector<GaussianNumber>* ids = nullptr,
                                          std::size_t max_count = limits::gaussians,
                                          std::vector<GaussianNumber>* groups = nullptr);

// Writes x,y,z,radius,density, and optics and shapes where there are any, with the fewest digits
// that read back the same.
void write_gaussians_csv(const std::filesystem::path& file, std::span<const Gaussian> gaussians,
                         std::span<const GaussianNumber> ids = {});

}  // namespace brume
