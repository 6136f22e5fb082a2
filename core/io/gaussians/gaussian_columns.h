#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <string>
#include <string_view>

#include "brume/gaussian.h"
#include "brume/limits.h"
#include "core/medium/written_radii.h"
#include "core/number_domain.h"

namespace brume::gaussian_columns {

// Column names of a Gaussian's attributes in files, in the order of Gaussian, and their domains.
inline constexpr std::array<std::string_view, 5> names{"x", "y", "z", "radius", "density"};
inline constexpr std::array<const NumberDomain*, 5> domains{
    &domain::coordinate, &domain::coordinate, &domain::coordinate, &domain::length,
    &domain::density};

// Alternative names: Houdini, CloudCompare, ParaView. Read only.
inline constexpr std::array<std::array<std::string_view, 2>, 5> other_names{
    {{"points:0", "points_0"},
     {"points:1", "points_1"},
     {"points:2", "points_2"},
     {"pscale", "scalar_radius"},
     {"scalar_density", ""}}};

// The columns of its optics, in files where a Gaussian has some; all six or none. An albedo of 0 0
// 0 is the medium's.
inline constexpr std::array<std::string_view, 6> optics_names{
    "albedo_r", "albedo_g", "albedo_b", "emission_r", "emission_g", "emission_b"};
inline constexpr NumberDomain albedo_domain{0.0, 1.0, "a number in (0, 1] (from 1e-6), or three 0"};

inline std::array<double, 6> optics_values(const GaussianOptics& optics) {
  const glm::dvec3 albedo = optics.albedo.value_or(glm::dvec3(0.0));
  const glm::dvec3& emission = optics.emission;
  return {albedo.x, albedo.y, albedo.z, emission.x, emission.y, emission.z};
}
// `refuse(i, why)` throws: value i is not allowed.
template <class Refuse>
GaussianOptics optics_of(const std::array<double, 6>& values, Refuse refuse) {
  const glm::dvec3 albedo(values[0], values[1], values[2]);
  for (std::size_t i = 0; i < values.size(); ++i) {
    const bool is_albedo = i < 3;
    const NumberDomain& domain = is_albedo ? albedo_domain : domain::intensity;
    const bool has_albedo = albedo != glm::dvec3(0.0);
    const bool is_allowed =
        is_albedo && has_albedo ? domain::albedo.contains(values[i]) : domain.contains(values[i]);
    if (!is_allowed) refuse(i, domain.refusal(values[i]));
  }
  GaussianOptics optics;
  if (albedo != glm::dvec3(0.0)) optics.albedo = albedo;
  optics.emission = {values[3], values[4], values[5]};
  return optics;
}
// Whether a file of them has those columns.
inline bool have_optics(std::span<const Gaussian> gaussians) {
  return std::ranges::any_of(gaussians,
                             [](const Gaussian& g) { return g.optics != GaussianOptics(); });
}

// The columns of its shape, in files where a Gaussian is an ellipsoid, whose greatest radius is its
// radius too; all seven or none. Radii along its own axes, and the quaternion that turns them.
inline constexpr std::array<std::string_view, 7> shape_names{
    "radius_x", "radius_y", "radius_z", "rotate_w", "rotate_x", "rotate_y", "rotate_z"};

inline std::array<double, 7> shape_values(const Gaussian& g) {
  const glm::dvec3 radii = written_radii(g);
  const glm::dquat& q = g.shape.rotation;
  return {radii.x, radii.y, radii.z, q.w, q.x, q.y, q.z};
}
// `refuse(i, why)` throws: value i is not allowed.
template <class Refuse>
void set_shape(Gaussian& gaussian, const std::array<double, 7>& values, Refuse refuse) {
  for (std::size_t i = 0; i < 3; ++i) {
    if (!domain::length.contains(values[i])) refuse(i, domain::length.refusal(values[i]));
  }
  const glm::dvec3 radii(values[0], values[1], values[2]);
  if (const std::string why = refused_radii(radii); !why.empty()) refuse(std::size_t{0}, why);
  const double greatest = std::max({radii.x, radii.y, radii.z});
  if (!(std::abs(gaussian.radius - greatest) <= 1e-5 * greatest)) {  // floats, or few digits
    refuse(std::size_t{0}, "found radii of at most " + quoted_text(greatest) +
                               " beside the radius " + quoted_text(gaussian.radius) +
                               "; allowed: their greatest as radius");
  }
  const glm::dquat rotation(values[3], values[4], values[5], values[6]);
  const double length = glm::length(rotation);
  if (!(std::abs(length - 1.0) < 1e-3)) {
    refuse(std::size_t{3},
           "found a quaternion of length " + quoted_text(length) + "; allowed: a unit quaternion");
  }
  gaussian.set_radii(radii, rotation);
}
// The first of these columns that is missing beside others of them, or "": a file of some is of no
// use, and of balls that were none. `has` tells whether there is a column of a name.
template <class Has>
std::string missing_of_shape(Has has) {
  if (std::ranges::none_of(shape_names, has)) return {};
  const auto missing = std::ranges::find_if_not(shape_names, has);
  return missing == shape_names.end() ? std::string() : std::string(*missing);
}
// Whether a file of them has those columns.
inline bool have_shapes(std::span<const Gaussian> gaussians) {
  return std::ranges::any_of(gaussians, [](const Gaussian& g) { return !g.is_ball(); });
}

// Persistent id of a Gaussian in a sequence; an integer.
inline constexpr std::string_view id_name = "id";
// Number of its group in the scene that the file is part of: 1 is the first, 0 none; an integer.
inline constexpr std::string_view group_name = "group";
inline constexpr NumberDomain id_domain{0.0, 4294967295.0, "an integer from 0 to 4294967295"};
constexpr bool is_id(double value) {
  return id_domain.contains(value) &&
         value == static_cast<double>(static_cast<std::uint32_t>(value));
}

// The allowed number of Gaussians of a file, for messages.
inline std::string allowed_count(std::size_t max_count) {
  return "at most " + std::to_string(max_count) +
         (max_count < limits::gaussians ? " in addition to the other Gaussians of the scene" : "");
}

// Calls find() with the name of column i, then its alternatives, until one yields a value.
template <class Find>
auto find_column(std::size_t i, Find find) {
  auto found = find(names[i]);
  for (const std::string_view name : other_names[i]) {
    if (!found && !name.empty()) found = find(name);
  }
  return found;
}

}  // namespace brume::gaussian_columns
