#pragma once

#include <glm/vec3.hpp>

namespace brume {

// Linear Rec. 709 of a watt of light of a wavelength [nm]; its relative luminance is that of the
// CIE 1931 observer, at most 1. Channels outside the gamut are negative. The observer as fitted by
// Wyman, Sloan and Shirley (2013).
glm::dvec3 rec709_of_wavelength(double nm);

}  // namespace brume
