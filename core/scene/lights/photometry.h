#pragma once

#include <glm/vec3.hpp>
#include <optional>

#include "brume/scene.h"
#include "core/number_domain.h"

namespace brume {

// Photometric units beside the scene's radiometric ones: the one place that converts.

// One watt of RGB light is 683 lumens times its relative luminance (Rec. 709): what renderers that
// know no spectra take, among them Blender's glTF exporter.
inline constexpr double lumens_per_watt = 683.0;

// Relative luminance of linear Rec. 709 RGB.
double luminance(const glm::dvec3& rgb);

// Luminous intensity of a point light or spot on its axis [cd]; illuminance of a directional light
// [lx]; luminance of an area light [cd/u^2].
double photometric_strength(const Light& light);

// The flux in all directions [lm]; a directional light has none.
std::optional<double> luminous_flux(const Light& light);

// Colour of a black body, linear Rec. 709, its greatest channel 1; channels outside that gamut are
// 0. The temperature is clamped to
// domain::temperature [K]. Planck's law; chromaticities are within 0.003
// (core/math/color_matching.h).
glm::dvec3 black_body_color(double temperature);

// Radiance of a black body, linear Rec. 709 [W/(sr m^2)], in the RGB watts of lumens_per_watt;
// channels outside that gamut are 0. Black below 800 K, where nothing glows visibly (the Draper
// point); clamped to domain::temperature above [K]. Interpolated: within 0.1% of the sum over
// wavelengths.
glm::dvec3 black_body_radiance(double temperature);

// The temperature whose colour is nearest to a colour whose greatest channel is 1 [K].
double nearest_temperature(const glm::dvec3& color);

}  // namespace brume
