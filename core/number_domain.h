#pragma once

#include <algorithm>
#include <glm/vec3.hpp>
#include <string>

#include "brume/limits.h"

namespace brume {

// The allowed interval of a number in a file. NaN is never allowed.
struct NumberDomain {
  double min_value;
  double max_value;
  const char* allowed;  // description for error messages
  bool open = false;    // excludes its ends

  [[nodiscard]] constexpr bool contains(double value) const {
    return open ? value > min_value && value < max_value : value >= min_value && value <= max_value;
  }
  // The nearest allowed value; of an open interval by a millionth of it from the end.
  [[nodiscard]] constexpr double nearest(double value) const {
    const double margin = open ? 1e-6 * (max_value - min_value) : 0.0;
    return std::clamp(value, min_value + margin, max_value - margin);
  }
  // "found -0.5; allowed: a number > 0"
  [[nodiscard]] std::string refusal(double value) const;
};

// A number in error messages: the shortest text that round-trips.
std::string quoted_text(double value);

namespace domain {

inline constexpr NumberDomain coordinate{-limits::coordinate, limits::coordinate,
                                         "a number from -1e12 to 1e12"};
inline constexpr NumberDomain length{limits::min_length, limits::max_length,
                                     "a number > 0 (from 1e-12 to 1e12)"};
inline constexpr NumberDomain stretch{limits::min_stretch, 1.0, "a number from 1e-4 to 1"};
inline constexpr NumberDomain density{0.0, limits::density, "a number >= 0 (up to 1e12)"};
inline constexpr NumberDomain intensity{0.0, limits::intensity, "a number >= 0 (up to 1e20)"};
inline constexpr NumberDomain normal_scale{0.0, 1000.0, "a number in [0, 1000]"};
inline constexpr NumberDomain unit{0.0, 1.0, "a number in [0, 1]"};
inline constexpr NumberDomain albedo{1e-6, 1.0, "a number in (0, 1] (from 1e-6)"};
inline constexpr NumberDomain albedo_offset{-1.0, 1.0, "a number in [-1, 1]"};
inline constexpr NumberDomain anisotropy{-0.95, 0.95, "a number in [-0.95, 0.95]"};
inline constexpr NumberDomain field_of_view{0.0, 180.0, "a number in (0, 180) degrees", true};
inline constexpr NumberDomain cone_angle{0.0, 180.0, "a number in [0, 180] degrees"};
inline constexpr NumberDomain elevation{-90.0, 90.0, "a number in [-90, 90] degrees"};
inline constexpr NumberDomain turbidity{1.0, 10.0, "a number in [1, 10]"};
inline constexpr NumberDomain angular_diameter{0.0, 89.99999999999999,
                                               "a number in [0, 90) degrees"};
inline constexpr NumberDomain turn{0.0, 360.0, "a number of degrees from 0 to 360"};
inline constexpr NumberDomain temperature{800.0, 40000.0, "a number from 800 to 40000 K"};
inline constexpr NumberDomain not_negative{0.0, 1e12, "a number >= 0 (up to 1e12)"};
inline constexpr NumberDomain brush_spacing{0.05, 100.0, "a number from 0.05 to 100"};
inline constexpr NumberDomain brush_scatter{0.0, 10.0, "a number from 0 to 10"};
inline constexpr NumberDomain elongation{1.0, 1.0 / limits::min_stretch, "a number from 1 to 1e4"};
inline constexpr NumberDomain brush_stretch{1.0, 5.0, "a number from 1 to 5"};
inline constexpr NumberDomain seconds{-1e9, 1e9, "a number of seconds from -1e9 to 1e9"};
inline constexpr NumberDomain slope{-limits::slope, limits::slope,
                                    "a number per second from -1e30 to 1e30"};
inline constexpr NumberDomain rate{1e-3, 1e6, "a number from 1e-3 to 1e6"};
inline constexpr NumberDomain frame_rate{1.0, 1000.0, "a number from 1 to 1000"};
inline constexpr NumberDomain shutter{-2.0, 2.0, "a number of frames from -2 to 2"};
inline constexpr NumberDomain stops{-60.0, 60.0, "a number of stops from -60 to 60"};
inline constexpr NumberDomain degrees{-1e12, 1e12, "a number of degrees from -1e12 to 1e12"};

}  // namespace domain

// Why an ellipsoid may not have these radii, each of domain::length; empty if it may.
std::string refused_radii(const glm::dvec3& radii);

}  // namespace brume
