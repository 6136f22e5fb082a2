#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <stop_token>
#include <vector>

#include "brume/medium.h"
#include "core/authoring/simplify.h"

namespace brume {

// Level of detail: of a medium of many small Gaussians that overlap, one of fewer with an error of
// optical depth up to a bound, see simplify(). By default a function of the medium and the limits
// alone. For frames in motion it may follow edits: those Gaussians that have changed are merged
// anew, with what they were merged with, and the result depends on the media before.
class MergedMedium {
 public:
  // Frames of fewer Gaussians are fast, and merging them would be felt.
  static constexpr std::size_t min_gaussians = 20'000;
  static bool may_merge(const Medium& medium) { return medium.size() >= min_gaussians; }

  // See Settings; an error of 0: as it is.
  struct Limits {
    double error = 0.0;
    double share = 1.0;
    // Edits are followed until more than this share of the Gaussians has changed. 0: never.
    double followed = 0.0;

    bool operator==(const Limits&) const = default;
  };

  // False, and of no use until the next, if stopped.
  bool update(const Medium& medium, const Limits& limits, const std::stop_token& stop);

  // After the last update(): the medium itself if merging would not make frames faster.
  [[nodiscard]] const Medium& medium() const { return medium_; }
  [[nodiscard]] bool is_merged() const { return is_merged_; }

 private:
  // Gaussians of source_, and one that stands for them.
  struct Part {
    Gaussian gaussian;
    std::vector<GaussianId> members;
  };

  // All of a medium; false if stopped.
  bool merge(const Medium& medium, const Limits& limits, const std::stop_token& stop);
  // Merges the changes since source_; false, and nothing merged, if there are too many, or if
  // stopped.
  bool follow(const Medium& medium, const Limits& limits, const std::stop_token& stop);
  void append(const Simplified& simplified, const Medium& medium, std::span<const GaussianId> ids);
  void remove_parts(std::span<const std::uint32_t> places);
  [[nodiscard]] std::uint32_t& part_of(GaussianId id) { return part_of_[id - first_id_]; }
  void assemble();

  // Whether merging pays, which takes about as long to find out as to merge. Where edits are
  // followed, the same is assumed of another medium of about the size, such as the next of a
  // sequence, until it is seen again.
  struct Decision {
    Limits limits;
    std::size_t size = 0;
    bool merges = false;
  };
  [[nodiscard]] bool is_like_last(const Medium& medium, const Limits& limits) const;
  [[nodiscard]] bool decide(const Medium& medium, const Limits& limits);

  Medium medium_;
  std::optional<Revision> made_from_;
  Limits limits_;
  bool is_merged_ = false;
  Decision decision_;  // the last
  bool is_assumed_ = false;

  Medium source_;  // made_from_, while it may be merged
  std::optional<AxisDepths> depths_;
  std::vector<Part> parts_;
  // By id, from the first on:
  GaussianId first_id_ = 0;
  std::vector<std::uint32_t> part_of_;  // of those that source_ has
  std::vector<bool> is_changed_;        // since merge()
  std::size_t changed_ = 0;             // how many are
};

}  // namespace brume
