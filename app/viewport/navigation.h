#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "core/scene/camera.h"

namespace brume {

// How a view moves: each answers the moved camera. The up axis of the scene stays upright.

// Turns around the target; angles in radians, positive moves the picture right and down.
Camera orbit(const Camera& camera, glm::dvec2 angles);

// Moves eye and target across the view so that the target follows the mouse by `pixels`.
Camera pan(const Camera& camera, const Film& film, glm::dvec2 pixels);

// Multiplies the distance to the target.
Camera zoom(const Camera& camera, double factor);

// Moves the camera along its view so that a sphere just fits the film.
Camera frame_sphere(const Camera& camera, const Film& film, const glm::dvec3& center,
                    double radius);

double target_distance(const Camera& camera);

}  // namespace brume
