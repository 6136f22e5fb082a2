#include "core/io/gaussians/splat_ply.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "core/io/atomic_file.h"
#include "core/io/little_endian.h"
#include "core/medium/splat.h"

namespace brume {
namespace {

// Of the opacity 1 - exp(-depth). What is in no way opaque has a finite one, from which its depth
// is read back as 0.
double opacity_logit(double depth) {
  constexpr double transparent = -1000.0;
  return depth > 0.0 ? std::max(depth + std::log(opacity_of_depth(depth)), transparent)
                     : transparent;
}

}  // namespace

void write_splats_ply(const std::filesystem::path& file, std::span<const Gaussian> gaussians,
                      const SplatOutput& output) {
  constexpr const char* properties[] = {
      "x",       "y",       "z",       "nx",      "ny",    "nz",    "f_dc_0", "f_dc_1", "f_dc_2",
      "opacity", "scale_0", "scale_1", "scale_2", "rot_0", "rot_1", "rot_2",  "rot_3"};
  std::string bytes = "ply\nformat binary_little_endian 1.0\n";
  bytes += "element vertex " + std::to_string(gaussians.size()) + "\n";
  for (const char* property : properties) bytes += "property float " + std::string(property) + "\n";
  bytes += "end_header\n";
  bytes.reserve(bytes.size() + gaussians.size() * std::size(properties) * sizeof(float));
  for (const Gaussian& gaussian : gaussians) {
    const Splat splat = splat_of(gaussian, output.along);
    const glm::dvec3 color = sh_color(gaussian, output);
    const glm::dvec3 scale = glm::log(splat.deviations);
    const glm::dquat& q = splat.rotation;
    for (const double value :
         {splat.center.x, splat.center.y, splat.center.z, 0.0, 0.0, 0.0, color.x, color.y, color.z,
          opacity_logit(splat.depth), scale.x, scale.y, scale.z, q.w, q.x, q.y, q.z}) {
      append_little_endian(bytes, static_cast<float>(value));
    }
  }
  write_atomically(file, bytes);
}

}  // namespace brume
