#pragma once

#include <string>
#include <string_view>

namespace brume {

// The kind of a file's bytes, in words, where an image that is read was expected: "a WebP image",
// "a Git LFS pointer ...".
std::string image_kind(std::string_view bytes);

}  // namespace brume
