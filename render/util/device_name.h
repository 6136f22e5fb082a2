#pragma once

#include <string>

namespace brume {

// The CPU's name as reported by Linux.
std::string device_name();

}  // namespace brume
