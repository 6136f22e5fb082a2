#pragma once

#include <atomic>
#include <cstdint>

namespace brume {

// Identifies one state of one object: whatever changes takes a new one, so equal revisions mean
// equal content, and nobody compares the content. 0 is never given: it stands for "none yet".
using Revision = std::uint64_t;

inline Revision new_revision() {
  static std::atomic<Revision> last{0};
  return ++last;
}

}  // namespace brume
