#pragma once

#include <span>
#include <vector>

#include "core/medium/gaussian.h"

namespace brume {

// The numbers of a sequence's Gaussians: those of the frame before go on, those that were renewed
// get numbers that were never used.
class GaussianNumbers {
 public:
  // The first frame, or one that has nothing to do with the one before.
  void begin(std::size_t count) {
    ids_.resize(count);
    for (GaussianNumber& id : ids_) id = next_++;
  }

  // The next frame; answers how many are new.
  std::size_t renew(const std::vector<bool>& renewed) {
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
