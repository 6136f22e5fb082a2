#pragma once

#include <assimp/light.h>
#include <assimp/scene.h>

#include <glm/mat4x4.hpp>
#include <optional>

#include "brume/lights.h"

namespace brume {

// The unit of the numbers of an FBX's lights, which no field of the file says; a light's Intensity
// is a percentage of them (ufbx: ufbx_light::intensity).
struct LightUnits {
  // Blender writes watts of its lights (W/m² of its suns). For other programs, such as Maya, a
  // white surface that faces a light of intensity 1 has the radiance 1, at a unit of length where
  // the light decays.
  bool are_watts = false;
  double length = 0.01;  // the file's unit [m]
};
LightUnits light_units(const aiScene& scene, double unit);

// The power of the distance by which a light decays: 0 to 3.
int decay_exponent(const aiLight& light);

// A point, spot or directional light; nullopt for others. `to_world` places it, shining along -z.
// Lights here decay by the square of the distance; another one is as bright as in its file at
// `center`.
std::optional<Light> light_of(const aiLight& source, const LightUnits& units,
                              const glm::dmat4& to_world, const glm::dvec3& center);

}  // namespace brume
