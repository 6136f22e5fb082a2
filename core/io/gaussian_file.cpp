#include "core/io/gaussian_file.h"

#include "core/io/gaussian_csv.h"
#include "core/io/gaussian_ply.h"
#include "core/io/file_bytes.h"

namespace brume {

std::vector<Gaussian> read_gaussians(const std::filesystem::path& file) {
  return read_first_bytes(file, 3) == "ply" ? read_gaussians_ply(file) : read_gaussians_csv(file);
}

void write_gaussians(const std::filesystem::path& file, std::span<const Gaussian> gaussians) {
  if (lower_case_extension(file) == ".csv") {
    write_gaussians_csv(file, gaussians);
  } else {
    write_gaussians_ply(file, gaussians);
  }
}

}  // namespace brume
