#pragma once

#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "brume/export.h"
#include "brume/medium.h"

namespace brume {

// A change of a medium as a value: Gaussians added, removed and changed. It stores both sides, so
// inverted() is a swap, and applying an edit and its inverse restores the medium exactly. Its size
// is that of the change.
class BRUME_EXPORT MediumEdit {
 public:
  struct Entry {
    GaussianId id = 0;
    Gaussian gaussian;
  };
  struct Change {
    GaussianId id = 0;
    Gaussian before;
    Gaussian after;
  };

  // Factories. Ids must be in the medium (assert).
  static MediumEdit add(const Medium& medium, std::span<const Gaussian> gaussians);
  // The same with ids that ascend and are not in the medium, as a file has them.
  static MediumEdit add(const Medium& medium, std::span<const Gaussian> gaussians,
                        std::span<const GaussianId> ids);
  static MediumEdit remove(const Medium& medium, std::span<const GaussianId> ids);
  // after[k] is the new value of ids[k]; unchanged Gaussians are skipped.
  static MediumEdit change(const Medium& medium, std::span<const GaussianId> ids,
                           std::span<const Gaussian> after);
  static MediumEdit set_homogeneous_density(const Medium& medium, double b0);

  [[nodiscard]] bool empty() const;
  [[nodiscard]] MediumEdit inverted() const;
  void apply(Medium& medium) const;

  // Appends a later edit, for drags and strokes that are one undo step. Changes that cancel are
  // dropped. Linear in the size of both.
  void merge(const MediumEdit& later);

  [[nodiscard]] const std::vector<Entry>& added() const { return added_; }
  [[nodiscard]] const std::vector<Entry>& removed() const { return removed_; }
  [[nodiscard]] const std::vector<Change>& changed() const { return changed_; }

 private:
  // All three are ordered by id.
  std::vector<Entry> added_;
  std::vector<Entry> removed_;
  std::vector<Change> changed_;
  std::optional<std::pair<double, double>> homogeneous_density_;  // before, after
};

}  // namespace brume
