#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace brume {

// The bytes of "data:...;base64,..." (RFC 2397); nullopt if it is no such text.
std::optional<std::string> decoded_data_uri(std::string_view uri);

// The inverse, for bytes of no particular kind.
std::string encoded_data_uri(std::string_view bytes);

// The relative path of a URI without scheme, %20 and the like decoded; nullopt for any other URI,
// and for control characters.
std::optional<std::string> decoded_relative_uri(std::string_view uri);

}  // namespace brume
