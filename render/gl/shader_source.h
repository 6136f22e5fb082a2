#pragma once

#include <string>
#include <string_view>

namespace brume::gl {

// The text of a file of render/gl/shaders, embedded by the build. Null: there is none.
const char* embedded_shader(std::string_view name);

// A whole shader: the version, and that file with every line `#include "NAME"` replaced by the file
// of that name, each file once. "constants.glsl" is not a file: shader_constants() makes it. Throws
// Error for a file that is not there.
std::string shader_source(const std::string& name);

}  // namespace brume::gl
