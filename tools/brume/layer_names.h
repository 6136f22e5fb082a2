#pragma once

#include <string>

#include "brume/output.h"

namespace brume {

// --layers: those by default, and the names of `text`, separated by commas. Throws UsageError.
OutputLayers parse_layers(const std::string& text);

}  // namespace brume
