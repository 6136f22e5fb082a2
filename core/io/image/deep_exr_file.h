#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <glm/vec3.hpp>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/io/image/image_file.h"

namespace brume {

// A sample of a deep pixel. Between z and z_back a volume of constant extinction and colour; at
// z = z_back a surface. As OpenEXR's "Interpreting Deep Pixels" has it, all but the share x of a
// volume's length has the alpha 1 - (1 - alpha)^x, and of its colour as much as of its alpha.
struct DeepSample {
  float z = 0.0f;           // [u]
  float z_back = 0.0f;      // [u], >= z
  glm::vec3 color{0.0f};    // RGB, premultiplied: as seen from z
  glm::vec3 alpha{0.0f};    // of R, G and B
  float mean_alpha = 0.0f;  // A
};

// Rows of a deep image: the samples of all pixels, row by row, front to back in each pixel.
struct DeepRows {
  int first = 0;                      // the uppermost, from the top
  std::vector<std::uint32_t> counts;  // of samples, per pixel
  std::vector<DeepSample> samples;
};

struct DeepExrHeader {
  int width = 0;
  int height = 0;
  // Whether alphas differ between channels: then AR, AG and AB are written beside A.
  bool has_colored_alpha = false;
  std::map<std::string, std::string> metadata;
  std::optional<ExrView> view{};  // is written, not read
};

// Takes whole rows, from the top, none twice.
using TakeDeepRows = std::function<void(const DeepRows& rows)>;

// Writes deep scan lines, 32-bit float, compressed row by row, as `produce` hands them over: it
// holds no more of them. An existing file is replaced only by a complete one; what `produce` throws
// leaves it as it was. Throws InputError.
void write_deep_exr(const std::filesystem::path& file, const DeepExrHeader& header,
                    const std::function<void(const TakeDeepRows& take)>& produce);

// All rows of such a file. Throws InputError where it is none; not for files of others, whose sizes
// it trusts.
DeepRows read_deep_exr(const std::filesystem::path& file, DeepExrHeader& header);

}  // namespace brume
