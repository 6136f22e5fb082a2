#pragma once

#include <memory>

#include "brume/keys.h"
#include "brume/medium.h"
#include "python/vectors.h"

namespace brume::python {

// A medium whose columns are shown as arrays of numpy, which do not copy: each keeps the medium
// alive, and while there are any, no Gaussian is added or removed.
class ArrayMedium {
 public:
  explicit ArrayMedium(Medium medium = {}) : medium_(std::move(medium)) {}
  ArrayMedium(const ArrayMedium&) = delete;
  ArrayMedium& operator=(const ArrayMedium&) = delete;

  // Writing to arrays, there still or not, counts as a change.
  [[nodiscard]] const Medium& medium() {
    if (views_ > 0 || was_written_) static_cast<void>(medium_.columns());
    was_written_ = false;
    return medium_;
  }
  // A copy that does not share with it what arrays may write to.
  [[nodiscard]] Medium copy() {
    Medium copied = medium();
    if (views_ > 0) static_cast<void>(copied.columns());
    return copied;
  }
  // To change how many Gaussians there are. Throws Python's BufferError while there are arrays.
  [[nodiscard]] Medium& resizable();
  // To change all else.
  [[nodiscard]] Medium& changeable() { return medium_; }

  // Keyframes of the homogeneous density.
  [[nodiscard]] Keys<double>& density_keys() { return density_keys_; }

  // A capsule that keeps the medium alive for an array.
  static pybind11::capsule view_of(const std::shared_ptr<ArrayMedium>& medium);

 private:
  Medium medium_;
  Keys<double> density_keys_;
  std::size_t views_ = 0;
  bool was_written_ = false;
};

void bind_medium(pybind11::module_& module);

}  // namespace brume::python
