#include "core/io/image/exr_color.h"

#include <cmath>
#include <glm/matrix.hpp>
#include <glm/vec3.hpp>

namespace brume {
namespace {

constexpr double min_determinant = 1e-9;  // of primaries that span colours; Rec. 709 has 0.1

// Lam 1985: from XYZ to responses of the eye's cones.
const glm::dmat3 bradford(0.8951, -0.7502, 0.0389, 0.2664, 1.7135, -0.0685, -0.1614, 0.0367,
                          1.0296);

glm::dvec3 xyz_of(const Imath::V2f& chromaticity) {
  const glm::dvec2 xy(chromaticity.x, chromaticity.y);
  return {xy.x, xy.y, 1.0 - xy.x - xy.y};
}

glm::dvec3 white_of(const Imf::Chromaticities& chromaticities) {
  return xyz_of(chromaticities.white) / static_cast<double>(chromaticities.white.y);
}

glm::dmat3 diagonal(const glm::dvec3& v) {
  return {{v.x, 0.0, 0.0}, {0.0, v.y, 0.0}, {0.0, 0.0, v.z}};
}

// Finite, too.
bool is_positive(const glm::dvec3& v) {
  return v.x > 0.0 && v.y > 0.0 && v.z > 0.0 && std::isfinite(v.x + v.y + v.z);
}

// White, (1, 1, 1), has the luminance 1.
std::optional<glm::dmat3> rgb_to_xyz(const Imf::Chromaticities& chromaticities) {
  const glm::dmat3 primaries(xyz_of(chromaticities.red), xyz_of(chromaticities.green),
                             xyz_of(chromaticities.blue));
  if (!(std::abs(glm::determinant(primaries)) >= min_determinant)) return std::nullopt;
  const glm::dvec3 scale = glm::inverse(primaries) * white_of(chromaticities);
  if (!is_positive(scale)) return std::nullopt;
  return primaries * diagonal(scale);
}

bool is_xyz(const Imf::Chromaticities& c) {
  return c.red == Imath::V2f(1.0f, 0.0f) && c.green == Imath::V2f(0.0f, 1.0f) &&
         c.blue == Imath::V2f(0.0f, 0.0f);
}

}  // namespace

std::optional<glm::dmat3> to_rec709(const Imf::Chromaticities& chromaticities) {
  const Imf::Chromaticities rec709;  // OpenEXR's default
  const std::optional<glm::dmat3> to_xyz = rgb_to_xyz(chromaticities);
  if (!to_xyz) return std::nullopt;
  const glm::dmat3 from_xyz = glm::inverse(*rgb_to_xyz(rec709));
  if (is_xyz(chromaticities)) return from_xyz * *to_xyz;
  const glm::dvec3 cones = bradford * white_of(chromaticities);
  if (!is_positive(cones)) return std::nullopt;
  const glm::dmat3 adaptation =
      glm::inverse(bradford) * diagonal(bradford * white_of(rec709) / cones) * bradford;
  return from_xyz * adaptation * *to_xyz;
}

}  // namespace brume
