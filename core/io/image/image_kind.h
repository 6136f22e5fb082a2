#pragma once

#include <string>
#include <string_view>

namespace brume {

// What the bytes of a file are, in words, where an image that is read was expected: "a WebP image",
// "a Git LFS pointer ...".
std::string image_kind(std::string_view bytes);

}  // namespace brume
