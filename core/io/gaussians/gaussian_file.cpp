#include "core/io/gaussians/gaussian_file.h"

#include "core/io/file_bytes.h"
#include "core/io/gaussians/gaussian_csv.h"
#include "core/io/gaussians/gaussian_ply.h"

namespace brume {

std::vector<Gaussian> read_gaussians(const std::filesystem::path& file,
                                     std::vector<GaussianNumber>* ids, std::size_t max_count) {
  return read_first_bytes(file, 3) == "ply" ? read_gaussians_ply(file, ids, max_count)
                                            : read_gaussians_csv(file, ids, max_count);
}

void write_gaussians(const std::filesystem::path& file, std::span<const Gaussian> gaussians,
                     std::span<const GaussianNumber> ids) {
  if (lower_case_extension(file) == ".csv") {
    write_gaussians_csv(file, gaussians, ids);
  } else {
    write_gaussians_ply(file, gaussians, ids);
  }
}

}  // namespace brume
