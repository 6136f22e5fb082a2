#pragma once

#include <string>

namespace brume {

// The name of the processor, as Linux tells it.
std::string device_name();

}  // namespace brume
