#pragma once

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_sort.h>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace brume {

// The finalizer of MurmurHash3 (Appleby 2011, public domain).
inline std::uint64_t mixed_bits(std::uint64_t bits) {
  bits = (bits ^ bits >> 33) * 0xff51afd7ed558ccdULL;
  bits = (bits ^ bits >> 33) * 0xc4ceb9fe1a85ec53ULL;
  return bits ^ bits >> 33;
}

// Sorts the indices below `count` by 32 bits of hash(index), which is called in parallel. Calls
// alone(index) for those with a hash of their own, and several(indices), ascending, for those that
// share one: they may be equal or not. Equal ones sort fast, for hardly any others share a hash.
void for_each_alike(std::size_t count, auto&& hash, auto&& alone, auto&& several) {
  constexpr std::uint64_t index_bits = 0xffffffffULL;
  std::vector<std::uint64_t> entries(count);  // the hash, and the index below it
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, count, 4096), [&](const auto& range) {
    for (std::size_t i = range.begin(); i < range.end(); ++i) {
      entries[i] = (hash(static_cast<std::uint32_t>(i)) & ~index_bits) | i;
    }
  });
  tbb::parallel_sort(entries);
  std::vector<std::uint32_t> alike;
  for (std::size_t first = 0; first < count;) {
    std::size_t last = first + 1;
    while (last < count && entries[last] >> 32 == entries[first] >> 32) ++last;
    if (last - first == 1) {
      alone(static_cast<std::uint32_t>(entries[first] & index_bits));
    } else {
      alike.clear();
      for (std::size_t i = first; i < last; ++i) {
        alike.push_back(static_cast<std::uint32_t>(entries[i] & index_bits));
      }
      several(std::span(alike));
    }
    first = last;
  }
}

}  // namespace brume
