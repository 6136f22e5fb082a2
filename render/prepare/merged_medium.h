#pragma once

#include <cstdint>
#include <optional>
#include <stop_token>
#include <vector>

#include "brume/medium.h"
#include "core/authoring/simplify.h"

namespace brume {

// Level of detail: of a medium of many small Gaussians that overlap, one of fewer with an error of
// optical depth up to a bound, see simplify(). An edit of some costs what it changes: what they
// were merged into is taken apart again, and they are as they are. Beyond many, all are merged
// anew.
class MergedMedium {
 public:
  // Of fewer Gaussians frames are fast, and merging them would be felt.
  static constexpr std::size_t min_gaussians = 20'000;
  static bool may_merge(const Medium& medium) { return medium.size() >= min_gaussians; }

  // Of a medium, within an error; 0: as it is. False, and as it was, if stopped.
  bool update(const Medium& medium, double max_error, const std::stop_token& stop);

  // After the last update(): the medium itself if merging would not make frames faster.
  [[nodiscard]] const Medium& medium() const { return medium_; }
  [[nodiscard]] bool is_merged() const { return is_merged_; }

 private:
  // False if stopped.
  bool merge(const Medium& medium, double max_error, const std::stop_token& stop);
  // Sets medium_: of source_ without `gone`, and with `more` (indices of `now`). Sorted.
  void assemble(const Medium& now, const std::vector<std::uint32_t>& gone,
                const std::vector<std::uint32_t>& more);

  Medium medium_;
  std::optional<Revision> made_from_;
  double max_error_ = 0.0;
  bool is_merged_ = false;

  Medium source_;  // what was merged, and how
  Simplified simplified_;
  std::vector<std::uint32_t> merged_into_;  // of source_: which of `merged`, or `not_merged`
};

}  // namespace brume
