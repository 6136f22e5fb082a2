#pragma once

#include <cstdint>

namespace brume {

// Random numbers of one light path: SplitMix64 (Steele, Lea and Flood, "Fast Splittable
// Pseudorandom Number Generators", OOPSLA 2014), started by a hash of what identifies the path. A
// path is the same whatever thread traces it, and after whichever others.
class PathRandom {
 public:
  PathRandom(std::uint64_t seed, std::uint64_t pixel, std::uint64_t sample, std::uint64_t stream)
      : state_(mix(mix(mix(mix(seed) ^ pixel) ^ sample) ^ stream)) {}

  std::uint64_t bits() {
    state_ += increment;
    return mix(state_);
  }

  // In the open interval (0, 1).
  double uniform() { return (static_cast<double>(bits() >> 12) + 0.5) * 0x1p-52; }

  // How many numbers were drawn since `earlier`, which is a copy from then.
  [[nodiscard]] std::uint64_t drawn_since(const PathRandom& earlier) const {
    return (state_ - earlier.state_) * inverse_increment;
  }

 private:
  static constexpr std::uint64_t increment = 0x9e3779b97f4a7c15;
  static constexpr std::uint64_t inverse_increment = 0xf1de83e19937733d;
  static_assert(increment * inverse_increment == 1);

  static std::uint64_t mix(std::uint64_t z) {
    z += increment;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9;
    z = (z ^ (z >> 27)) * 0x94d049bb133111eb;
    return z ^ (z >> 31);
  }

  std::uint64_t state_;
};

// Samples come in blocks that are stratified within and independent of each other: any number of
// them can follow, and the scatter of blocks tells the noise.
inline constexpr int path_block = 8;

// Two numbers in (0, 1) for sample k of a block: the eight points of a randomly shifted
// (0, 3, 2)-net in base 2, each uniform by itself. `block` is the same for all of them, `sample`
// each one's own.
struct StratifiedPair {
  double first, second;

  StratifiedPair(PathRandom block, unsigned k, PathRandom& sample) {
    const std::uint64_t shift = block.bits();
    const unsigned reversed = (k & 1u) << 2 | (k & 2u) | k >> 2;
    first = (static_cast<double>(k ^ (shift & 7u)) + sample.uniform()) / path_block;
    second = (static_cast<double>(reversed ^ (shift >> 3 & 7u)) + sample.uniform()) / path_block;
  }
};

}  // namespace brume
