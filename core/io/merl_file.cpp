#include "core/io/merl_file.h"

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <string>

#include "brume/error.h"
#include "core/io/disk/file_bytes.h"
#include "core/number_domain.h"

namespace brume {
namespace {

static_assert(std::endian::native == std::endian::little, "a MERL .binary is read as it lies");

constexpr std::size_t header_size = 3 * sizeof(std::int32_t);
constexpr std::uintmax_t file_size = header_size + 3 * sizeof(double) * MeasuredBrdf::samples;
constexpr std::array<double, 3> scale = {1.0 / 1500.0, 1.15 / 1500.0, 1.66 / 1500.0};

}  // namespace

std::shared_ptr<const MeasuredBrdf> read_merl(const std::filesystem::path& file) {
  const std::string header = read_first_bytes(file, header_size);
  std::array<std::int32_t, 3> dims{};
  if (header.size() == header_size) std::memcpy(dims.data(), header.data(), header_size);
  if (dims[0] != MeasuredBrdf::theta_h_cells || dims[1] != MeasuredBrdf::theta_d_cells ||
      dims[2] != MeasuredBrdf::phi_d_cells) {
    throw InputError(file, "header",
                     "found the dimensions " + std::to_string(dims[0]) + " x " +
                         std::to_string(dims[1]) + " x " + std::to_string(dims[2]) +
                         "; allowed: 90 x 90 x 180, a MERL .binary");
  }
  if (const std::uintmax_t found = regular_file_size(file); found != file_size) {
    throw InputError(file, "",
                     "found " + std::to_string(found) + " bytes; allowed: " +
                         std::to_string(file_size) + ", the size of a MERL .binary");
  }
  const std::string bytes = read_bytes(file);
  if (bytes.size() != file_size) throw InputError(file, "", "cannot be read completely");
  std::vector<glm::vec3> values(MeasuredBrdf::samples);
  const char* position = bytes.data() + header_size;
  for (int color = 0; color < 3; ++color) {
    for (std::size_t i = 0; i < values.size(); ++i, position += sizeof(double)) {
      double value = 0.0;
      std::memcpy(&value, position, sizeof(double));
      if (!(std::abs(value) <= 1e12)) {
        throw InputError(file, "sample " + std::to_string(i),
                         "found " + quoted_text(value) + "; allowed: a number from -1e12 to 1e12");
      }
      values[i][color] = static_cast<float>(value * scale[static_cast<std::size_t>(color)]);
    }
  }
  return std::make_shared<const MeasuredBrdf>(std::move(values));
}

}  // namespace brume
