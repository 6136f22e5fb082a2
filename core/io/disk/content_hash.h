#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>

namespace brume {

// A 64-bit hash of bytes, to name files that we made ourselves and to detect damage. The
// same on every little-endian machine. No defence against someone who wants two contents to agree.
class ContentHash {
 public:
  // Values of a type without padding.
  template <class Value>
  void add(std::span<const Value> values) {
    const std::span<const std::byte> bytes = std::as_bytes(values);
    mix(bytes.size());
    for (std::size_t i = 0; i < bytes.size(); i += sizeof(std::uint64_t)) {
      std::uint64_t word = 0;
      std::memcpy(&word, bytes.data() + i, std::min(sizeof(word), bytes.size() - i));
      mix(word);
    }
  }
  template <class Value>
  void add(const Value& value) {
    add(std::span<const Value>(&value, 1));
  }

  [[nodiscard]] std::uint64_t value() const { return hash_; }

 private:
  // The finalizer of splitmix64 (Steele, Lea and Flood 2014): any bit changes half of the others.
  void mix(std::uint64_t word) {
    std::uint64_t z = (hash_ ^ word) + 0x9e3779b97f4a7c15u;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    hash_ = z ^ (z >> 31);
  }

  std::uint64_t hash_ = 0;
};

}  // namespace brume
