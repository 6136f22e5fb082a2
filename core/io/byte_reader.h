#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <string>
#include <string_view>

#include "brume/error.h"

namespace brume {

// Reads a file's bytes sequentially; numbers are little-endian. Reading past the end throws an
// InputError naming file and byte, so false counts cost nothing.
class ByteReader {
 public:
  // `bytes` must outlive this.
  ByteReader(std::filesystem::path file, std::string_view bytes)
      : file_(std::move(file)), bytes_(bytes) {}

  [[nodiscard]] std::size_t position() const { return position_; }
  void seek(std::uint64_t position) {
    if (position > bytes_.size()) fail("refers to byte " + std::to_string(position));
    position_ = static_cast<std::size_t>(position);
  }

  std::string_view read_bytes(std::uint64_t count) {
    if (count > bytes_.size() - position_) {
      fail("needs " + std::to_string(count) + " bytes; the file ends before");
    }
    const std::string_view taken = bytes_.substr(position_, static_cast<std::size_t>(count));
    position_ += taken.size();
    return taken;
  }

  template <class Number>
  Number number() {
    static_assert(std::endian::native == std::endian::little);
    Number value;
    std::memcpy(&value, read_bytes(sizeof(Number)).data(), sizeof(Number));
    return value;
  }

  [[noreturn]] void fail(const std::string& message) const {
    throw InputError(file_, "byte " + std::to_string(position_), message);
  }

 private:
  std::filesystem::path file_;
  std::string_view bytes_;
  std::size_t position_ = 0;
};

// Appends a number to the bytes of a file.
template <class Number>
void append_little_endian(std::string& bytes, Number value) {
  std::array<char, sizeof(Number)> raw;
  std::memcpy(raw.data(), &value, sizeof(Number));
  if constexpr (std::endian::native == std::endian::big) std::reverse(raw.begin(), raw.end());
  bytes.append(raw.data(), raw.size());
}

}  // namespace brume
