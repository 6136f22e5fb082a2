#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <string>

namespace brume {

// Appends a number to the bytes of a file.
template <class Number>
void append_little_endian(std::string& bytes, Number value) {
  std::array<char, sizeof(Number)> raw;
  std::memcpy(raw.data(), &value, sizeof(Number));
  if constexpr (std::endian::native == std::endian::big) std::reverse(raw.begin(), raw.end());
  bytes.append(raw.data(), raw.size());
}

}  // namespace brume
