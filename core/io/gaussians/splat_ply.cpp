#include "core/io/gaussians/splat_ply.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <vector>

#include "core/io/byte_reader.h"
#include "core/io/disk/atomic_file.h"
#include "core/math/spherical_harmonics.h"
#include "core/medium/splat.h"

namespace brume {
namespace {

// The logit of the opacity 1 - exp(-depth). What is in no way opaque has a finite one, from which
// its depth is read back as 0.
double opacity_logit(double depth) {
  constexpr double transparent = -1000.0;
  return depth > 0.0 ? std::max(depth + std::log(opacity_of_depth(depth)), transparent)
                     : transparent;
}

// f_dc and f_rest. Viewers add 0.5 to what the coefficients sum to. To turn by half about z changes
// the same signs as the Condon-Shortley phase does.
void append_colors(const SplatColor& color, bool is_turned, std::string& bytes) {
  constexpr float constant_harmonic = 0.28209479177387814f;
  for (int c = 0; c < 3; ++c) append_little_endian(bytes, color[0][c] - 0.5f / constant_harmonic);
  for (int c = 0; c < 3; ++c) {
    for (int l = 1; l < 4; ++l) {
      for (int m = -l; m <= l; ++m) {
        const float value = color[sh_index(l, m)][c];
        append_little_endian(bytes, m % 2 == 0 || is_turned ? value : -value);
      }
    }
  }
}

}  // namespace

std::string splats_ply(std::span<const Gaussian> gaussians, const SplatOutput& output) {
  std::vector<std::string> properties{"x",  "y",      "z",      "nx",    "ny",
                                      "nz", "f_dc_0", "f_dc_1", "f_dc_2"};
  const bool has_colors = !output.colors.empty();
  for (int i = 0; has_colors && i < 45; ++i) properties.push_back("f_rest_" + std::to_string(i));
  for (const char* property :
       {"opacity", "scale_0", "scale_1", "scale_2", "rot_0", "rot_1", "rot_2", "rot_3"}) {
    properties.emplace_back(property);
  }
  std::string bytes = "ply\nformat binary_little_endian 1.0\n";
  bytes += "element vertex " + std::to_string(gaussians.size()) + "\n";
  for (const std::string& property : properties) bytes += "property float " + property + "\n";
  if (!output.ids.empty()) bytes += "property uint id\n";
  bytes += "end_header\n";
  bytes.reserve(bytes.size() + gaussians.size() * (properties.size() + 1) * sizeof(float));
  const auto append = [&](std::initializer_list<double> values) {
    for (const double value : values) append_little_endian(bytes, static_cast<float>(value));
  };
  for (std::size_t i = 0; i < gaussians.size(); ++i) {
    Gaussian gaussian = gaussians[i];
    if (output.y_down) turn_half(gaussian);
    const Splat splat = splat_of(gaussian, output.along);
    const glm::dvec3 scale = glm::log(splat.deviations);
    const glm::dquat& q = splat.rotation;
    append({splat.center.x, splat.center.y, splat.center.z, 0.0, 0.0, 0.0});
    if (has_colors) {
      append_colors(output.colors[i], output.y_down, bytes);
    } else {
      const glm::dvec3 color = sh_color(gaussians[i], output);
      append({color.x, color.y, color.z});
    }
    append({opacity_logit(splat.depth), scale.x, scale.y, scale.z, q.w, q.x, q.y, q.z});
    if (!output.ids.empty()) append_little_endian(bytes, output.ids[i]);
  }
  return bytes;
}

void write_splats_ply(const std::filesystem::path& file, std::span<const Gaussian> gaussians,
                      const SplatOutput& output) {
  write_atomically(file, splats_ply(gaussians, output));
}

}  // namespace brume
