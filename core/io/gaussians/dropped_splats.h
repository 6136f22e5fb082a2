#pragma once

#include <array>
#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "brume/gaussian.h"

namespace brume {

// The names of a splat's numbers in a file.
struct SplatNames {
  std::array<std::string_view, 3> position;
  std::array<std::string_view, 3> scale;
  std::string_view opacity;
  std::array<std::string_view, 3> color;
};

// Why a Gaussian that was made of a splat is none, in a file's own names; empty if it is one.
std::string splat_fault(const Gaussian& gaussian, const SplatNames& names);

// Counts the splats of a file that are left out since their numbers make no Gaussian, as trained
// captures have some. A file that is damaged has many of them, and is refused.
class DroppedSplats {
 public:
  void add(const std::string& place, const std::string& why);
  // Appends to `warnings`, if any, how many of `total` splats are left out, and the first place.
  // Throws InputError naming that if they are half of them or more.
  void report(const std::filesystem::path& file, std::size_t total,
              std::vector<std::string>* warnings) const;

 private:
  std::size_t count_ = 0;
  std::string first_place_;
  std::string first_reason_;
};

}  // namespace brume
