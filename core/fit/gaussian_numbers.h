#pragma once

#include <span>
#include <vector>

#include "core/medium/gaussian.h"

namespace brume {

// Persistent ids of a sequence's Gaussians: kept from frame to frame, except that relocated
// Gaussians get new, unused ids.
class GaussianNumbers {
 public:
  // Starts a sequence.
  void begin(std::size_t count) {
    ids_.resize(count);
    for (GaussianNumber& id : ids_) id = next_++;
  }

  // Advances to the next frame; returns the number of new ids.
  std::size_t relocate(const std::vector<bool>& renewed) {
    std::size_t count = 0;
    for (std::size_t i = 0; i < renewed.size(); ++i) {
      if (!renewed[i]) continue;
      ids_[i] = next_++;
      ++count;
    }
    return count;
  }

  [[nodiscard]] std::span<const GaussianNumber> ids() const { return ids_; }

 private:
  std::vector<GaussianNumber> ids_;
  GaussianNumber next_ = 0;
};

}  // namespace brume
