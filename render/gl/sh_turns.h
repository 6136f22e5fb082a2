#pragma once

#include <string>

namespace brume::gl {

// The text of sh_turns.glsl, for reflection.glsl: reflected_light(), the sum over bands of the
// light from around (light_around()), turned into a SurfaceFrame by three angles about z and two
// quarter turns about x, times reflectance(). Every coefficient is a variable of its own.
std::string sh_turns();

}  // namespace brume::gl
