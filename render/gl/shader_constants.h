#pragma once

#include <string>

namespace brume::gl {

// The numbers that shaders share with render/cpu, as GLSL: made from the C++ ones, so that no
// formula has two sets of them. Arrays become `const float name[n]`.
std::string shader_constants();

}  // namespace brume::gl
