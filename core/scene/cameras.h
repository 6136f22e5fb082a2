#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "brume/scene.h"

namespace brume {

// The cameras of a scene by name, and their lenses.

// The member that is not allowed beside the others, each in its domain, and why.
struct RefusedMember {
  const char* member;
  const char* message;
};
std::optional<RefusedMember> refusal(const Camera& camera);

NamedCamera camera_in_use(const Scene& scene);

// Puts a camera in use; the one that was takes its place among the others. False: there is none of
// that name.
bool use_camera(Scene& scene, std::string_view name);

// `wanted`, or with a number after it if a camera has that name.
std::string free_camera_name(const Scene& scene, const std::string& wanted);

// Half the height of what a camera sees at its target [u].
double half_height(const Camera& camera);

// The same camera with parallel rays, and without: it sees as much at its target. Without a lens
// that blurs where rays are parallel.
Camera orthographic(const Camera& camera);
Camera perspective(const Camera& camera);

// Focal length [mm] of a lens before a sensor as wide as the film, 36 mm, and the vertical field of
// view [degrees] of such a lens.
inline constexpr double sensor_width = 36.0;
double focal_length(double vertical_fov, const Film& film);
double vertical_fov(double focal_length, const Film& film);

}  // namespace brume
