#pragma once

#include <span>
#include <vector>

#include "brume/gaussian.h"

namespace brume {

// Persistent ids of a sequence's Gaussians: kept from frame to frame, except that relocated
// Gaussians get new ids, counted up by `counter`.
class GaussianNumbers {
 public:
  // Starts a sequence.
  void begin(std::size_t count, GaussianNumber& counter) {
    ids_.resize(count);
    for (GaussianNumber& id : ids_) id = counter++;
  }

  // Advances to the next frame; returns the number of new ids.
  std::size_t relocate(const std::vector<bool>& renewed, GaussianNumber& counter) {
    std::size_t count = 0;
    for (std::size_t i = 0; i < renewed.size(); ++i) {
      if (!renewed[i]) continue;
      ids_[i] = counter++;
      ++count;
    }
    return count;
  }

  [[nodiscard]] std::span<const GaussianNumber> ids() const { return ids_; }

 private:
  std::vector<GaussianNumber> ids_;
};

}  // namespace brume
