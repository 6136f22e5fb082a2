#pragma once

#include <string>

#include "core/scene/output.h"

namespace brume {

// --layers: those by default, and the names of `text`, separated by commas. Throws UsageError.
OutputLayers parse_layers(const std::string& text);

}  // namespace brume
