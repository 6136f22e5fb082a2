#include "tools/scene_reader/assimp_lights.h"

#include <assimp/commonMetaData.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <numbers>
#include <string_view>

#include "brume/limits.h"

namespace brume {
namespace {

light::Spot spot_of(const aiLight& source, const glm::dvec3& direction) {
  // The file's angles are those of the whole cone.
  const double outer = glm::degrees(0.5 * static_cast<double>(source.mAngleOuterCone));
  const double inner = glm::degrees(0.5 * static_cast<double>(source.mAngleInnerCone));
  light::Spot spot{direction};
  if (outer > 0.0 && outer <= 180.0) spot.outer_angle = outer;
  spot.inner_angle = inner >= 0.0 ? std::min(inner, spot.outer_angle) : 0.0;
  return spot;
}

// W/sr of a light of intensity 1, or W/m² of a directional one.
double watts(const aiLight& source, const LightUnits& units, double distance) {
  const bool is_directional = source.mType == aiLightSource_DIRECTIONAL;
  if (units.are_watts) return is_directional ? 1.0 : 0.25 * std::numbers::inv_pi;
  if (is_directional) return std::numbers::pi;
  distance = std::max(distance, units.length);
  return std::numbers::pi * distance * distance *
         std::pow(units.length / distance, decay_exponent(source));
}

}  // namespace

LightUnits light_units(const aiScene& scene, double unit) {
  aiString program;
  const bool is_known =
      scene.mMetaData != nullptr && scene.mMetaData->Get(AI_METADATA_SOURCE_GENERATOR, program);
  return {is_known && std::string_view(program.C_Str()).starts_with("Blender"), unit};
}

int decay_exponent(const aiLight& light) {
  // The attenuation is all that assimp's converter of FBX leaves of it; for 3 it sets one factor.
  const aiLight unset;
  if (light.mAttenuationLinear == unset.mAttenuationLinear && light.mAttenuationQuadratic == 1.0f) {
    return 3;
  }
  if (light.mAttenuationQuadratic != 0.0f) return 2;
  return light.mAttenuationLinear != 0.0f ? 1 : 0;
}

std::optional<Light> light_of(const aiLight& source, const LightUnits& units,
                              const glm::dmat4& to_world, const glm::dvec3& center) {
  Light light;
  light.position = glm::dvec3(to_world[3]);
  glm::dvec3 direction = -glm::dvec3(to_world[2]);
  const double length = glm::length(direction);
  direction = length > 0.0 ? direction / length : glm::dvec3(0.0, -1.0, 0.0);
  if (source.mType == aiLightSource_DIRECTIONAL) {
    light.kind = light::Directional{direction};
  } else if (source.mType == aiLightSource_SPOT) {
    light.kind = spot_of(source, direction);
  } else if (source.mType != aiLightSource_POINT) {
    return std::nullopt;
  }
  const double scale = watts(source, units, glm::distance(light.position, center));
  for (int k = 0; k < 3; ++k) {
    const double value =
        scale * static_cast<double>(source.mColorDiffuse[static_cast<unsigned>(k)]);
    light.intensity[k] = std::isfinite(value) ? std::clamp(value, 0.0, limits::intensity) : 0.0;
  }
  return light;
}

}  // namespace brume
