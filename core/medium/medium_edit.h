#pragma once

#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "core/medium/medium.h"

namespace brume {

// A change of a medium as a value: what was added, removed and changed. It holds both sides of
// every change, so inverted() is a swap and applying an edit and then its inverse restores the
// medium exactly. Its size is that of the change, not of the medium.
class MediumEdit {
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

  // Makers. Ids that the medium does not hold are a broken invariant (assert).
  static MediumEdit add(const Medium& medium, std::span<const Gaussian> gaussians);
  static MediumEdit remove(const Medium& medium, std::span<const GaussianId> ids);
  // after[k] is the new value of ids[k]; a Gaussian that stays as it is makes no change.
  static MediumEdit change(const Medium& medium, std::span<const GaussianId> ids,
                           std::span<const Gaussian> after);
  static MediumEdit set_homogeneous_density(const Medium& medium, double b0);

  [[nodiscard]] bool empty() const;
  [[nodiscard]] MediumEdit inverted() const;
  void apply(Medium& medium) const;

  // Makes this edit followed by `later` into one edit, for drags and strokes that are one step.
  // What comes back to where it was leaves nothing. Costs the size of both edits.
  void merge(const MediumEdit& later);

  [[nodiscard]] const std::vector<Entry>& added() const { return added_; }
  [[nodiscard]] const std::vector<Entry>& removed() const { return removed_; }
  [[nodiscard]] const std::vector<Change>& changed() const { return changed_; }

 private:
  // What an edit does to one Gaussian; nullopt: it is not there.
  struct Step {
    GaussianId id = 0;
    std::optional<Gaussian> before;
    std::optional<Gaussian> after;
  };
  [[nodiscard]] std::vector<Step> steps() const;  // ordered by id
  void append(const Step& step);

  // All three are ordered by id.
  std::vector<Entry> added_;
  std::vector<Entry> removed_;
  std::vector<Change> changed_;
  std::optional<std::pair<double, double>> homogeneous_density_;  // before, after
};

}  // namespace brume
