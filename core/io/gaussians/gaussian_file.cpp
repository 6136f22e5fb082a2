#include "core/io/gaussians/gaussian_file.h"

#include <algorithm>

#include "brume/error.h"
#include "core/io/file_bytes.h"
#include "core/io/gaussians/gaussian_columns.h"
#include "core/io/gaussians/gaussian_csv.h"
#include "core/io/gaussians/gaussian_ply.h"
#include "core/io/gaussians/splat_ply.h"

namespace brume {
namespace {

std::vector<Gaussian> read_numbered(const std::filesystem::path& file,
                                    std::vector<GaussianNumber>* numbers, std::size_t max_count,
                                    std::string_view number_name, OpacityAlong along) {
  return read_first_bytes(file, 3) == "ply"
             ? read_gaussians_ply(file, numbers, max_count, number_name, along)
             : read_gaussians_csv(file, numbers, max_count, number_name);
}

}  // namespace

std::vector<Gaussian> read_gaussians(const std::filesystem::path& file,
                                     std::vector<GaussianNumber>* ids, std::size_t max_count,
                                     OpacityAlong along) {
  return read_numbered(file, ids, max_count, gaussian_columns::id_name, along);
}

std::size_t max_gaussian_count(const std::filesystem::path& file) {
  if (read_first_bytes(file, 3) == "ply") return max_gaussian_count_ply(file);
  const std::string bytes = read_bytes(file);
  return static_cast<std::size_t>(std::ranges::count(bytes, '\n')) + 1;
}

std::vector<Gaussian> read_grouped_gaussians(const std::filesystem::path& file,
                                             std::size_t max_count, std::size_t max_group) {
  std::vector<GaussianNumber> groups;
  std::vector<Gaussian> gaussians =
      read_numbered(file, &groups, max_count, gaussian_columns::group_name, OpacityAlong::mean);
  for (std::size_t i = 0; i < groups.size(); ++i) {
    if (groups[i] > max_group) {
      throw InputError(file, "Gaussian " + std::to_string(i),
                       "group: found " + std::to_string(groups[i]) +
                           "; allowed: an integer from 0 to " + std::to_string(max_group) +
                           ", the number of the scene's groups");
    }
    gaussians[i].group = groups[i];
  }
  return gaussians;
}

void write_gaussians(const std::filesystem::path& file, std::span<const Gaussian> gaussians,
                     std::span<const GaussianNumber> ids) {
  if (lower_case_extension(file) == ".csv") {
    write_gaussians_csv(file, gaussians, ids);
  } else {
    write_gaussians_ply(file, gaussians, ids);
  }
}

void write_splats(const std::filesystem::path& file, std::span<const Gaussian> gaussians,
                  const SplatOutput& output) {
  write_splats_ply(file, gaussians, output);
}

}  // namespace brume
