#pragma once

#include <Qt>
#include <array>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>

#include "brume/camera.h"

namespace brume {

class CameraRays;

// Camera navigation; each function returns the moved camera. The scene's up axis stays upright.

// Turns eye and target about a pivot: the target orbits it, the eye looks around. Angles in
// radians, positive ones move what is at the pivot right and down.
Camera orbit(const Camera& camera, const glm::dvec3& pivot, glm::dvec2 angles);

// Moves eye and target to the right, up and forth in the picture [u].
Camera fly(const Camera& camera, const glm::dvec3& way);

// Moves eye and target across the view so that the target follows the mouse by `pixels`.
Camera pan(const Camera& camera, const Film& film, glm::dvec2 pixels);

// Multiplies the distance to the target.
Camera zoom(const Camera& camera, double factor);

// Moves the camera along its view so that a sphere just fits the film.
Camera frame_sphere(const Camera& camera, const Film& film, const glm::dvec3& center,
                    double radius);

double target_distance(const Camera& camera);
// How far away a point seems: its distance from the eye; of an orthographic camera that from which
// the usual angle of view sees as much.
double viewing_distance(const CameraRays& rays, const glm::dvec3& point);

// Mouse bindings of navigation: Brume's own, or those of other programs.
enum class NavigationPreset { brume, blender, maya };
inline constexpr std::array navigation_presets{NavigationPreset::brume, NavigationPreset::blender,
                                               NavigationPreset::maya};

enum class NavigationDrag { orbit, pan, zoom };
// The navigation of a drag; nullopt: none.
std::optional<NavigationDrag> navigation_drag(NavigationPreset preset, Qt::MouseButton button,
                                              Qt::KeyboardModifiers modifiers);

}  // namespace brume
