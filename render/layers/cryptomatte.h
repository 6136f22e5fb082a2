#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "core/io/image/image_file.h"

namespace brume {

// Mattes of names by coverage (Friedman and Jones, "Fully automatic ID mattes with support for
// motion blur and transparency", 2015; Cryptomatte specification 1.2.0).

// MurmurHash3_x86_32 (Appleby) with seed 0, little-endian.
std::uint32_t murmur_hash3(std::string_view text);
// The bits of a float that is neither 0, denormal, infinite nor NaN.
std::uint32_t cryptomatte_hash(std::string_view name);

// Which names cover pixels, and how much of each.
class CoverageFilm {
 public:
  // Names of a pixel, by coverage. What comes to a pixel with as many others already is left out.
  static constexpr std::size_t ranks = 6;

  // `names`: of ids 0, 1, ...
  CoverageFilm(std::size_t pixels, std::vector<std::string> names);

  // A share of a pixel, of all weights of a pixel at most 1. Pixels may be filled in parallel.
  void add(std::size_t pixel, std::uint32_t id, float weight);

  // Adds the channels LAYER00.R/G/B/A, LAYER01, LAYER02, hash and coverage in turn, and the
  // metadata, with all names as the manifest.
  void write(const std::string& layer, ImageLayers& image) const;

 private:
  struct Share {
    std::uint32_t id = 0;
    float weight = 0.0f;  // 0: none
  };
  using Pixel = std::array<Share, ranks>;

  std::vector<Pixel> pixels_;
  std::vector<std::string> names_;
};

}  // namespace brume
