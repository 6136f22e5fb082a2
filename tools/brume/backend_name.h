#pragma once

#include <string>

#include "render/gl_renderer.h"

namespace brume {

// What --backend names. Throws UsageError.
Backend parse_backend(const std::string& name);

}  // namespace brume
