#include "core/medium/medium.h"

#include <algorithm>
#include <utility>

#include "core/medium/medium_edit.h"

namespace brume {
namespace {

// Edits that a medium remembers: those between two frames of a slow renderer, at 125 mouse events a
// second.
constexpr std::size_t max_past_edits = 64;

// By halves: one after another would take as many passes over the largest.
MediumEdit merged(std::span<const MediumEdit* const> edits) {
  if (edits.size() == 1) return *edits[0];
  MediumEdit edit = merged(edits.first(edits.size() / 2));
  edit.merge(merged(edits.subspan(edits.size() / 2)));
  return edit;
}

}  // namespace

std::optional<std::size_t> Medium::index_of(GaussianId id) const {
  const auto it = std::lower_bound(ids_.begin(), ids_.end(), id);
  if (it == ids_.end() || *it != id) return std::nullopt;
  return static_cast<std::size_t>(it - ids_.begin());
}

GaussianId Medium::append(const Gaussian& gaussian) {
  centers_.push_back(gaussian.center);
  radii_.push_back(gaussian.radius);
  densities_.push_back(gaussian.density);
  ids_.push_back(next_id_);
  revision_ = new_revision();
  past_.clear();
  return next_id_++;
}

void Medium::reserve(std::size_t count) {
  centers_.reserve(count);
  radii_.reserve(count);
  densities_.reserve(count);
  ids_.reserve(count);
}

void Medium::set_homogeneous_density(double b0) {
  MediumEdit::set_homogeneous_density(*this, b0).apply(*this);
}

Medium Medium::divided_by(double divisor) const {
  Medium medium = *this;
  for (double& density : medium.densities_) density /= divisor;
  medium.homogeneous_density_ /= divisor;
  medium.revision_ = new_revision();
  medium.past_.clear();
  return medium;
}

// Called with the edit already applied. Edits of more than a quarter of the Gaussians together are
// forgotten: by then everything is computed anew, and the memory stays bounded.
void Medium::record(const MediumEdit& edit) {
  const Revision before = std::exchange(revision_, new_revision());
  const std::size_t max_gaussians = size() / 4 + 16;
  if (edit.size() > max_gaussians) {
    past_.clear();
    return;
  }
  past_.push_back({before, std::make_shared<const MediumEdit>(edit)});
  std::size_t gaussians = 0;
  std::size_t count = 0;
  while (count < std::min(past_.size(), max_past_edits)) {
    gaussians += past_[past_.size() - 1 - count].edit->size();
    if (gaussians > max_gaussians) break;
    ++count;
  }
  past_.erase(past_.begin(), past_.end() - static_cast<std::ptrdiff_t>(count));
}

std::optional<MediumEdit> Medium::edit_since(Revision revision) const {
  if (revision == revision_) return MediumEdit();
  const auto past = std::ranges::find(past_, revision, &Past::revision);
  if (past == past_.end()) return std::nullopt;
  std::vector<const MediumEdit*> edits;
  for (auto it = past; it != past_.end(); ++it) edits.push_back(it->edit.get());
  return merged(edits);
}

bool Medium::operator==(const Medium& other) const {
  if (revision_ == other.revision_) return true;
  return homogeneous_density_ == other.homogeneous_density_ && ids_ == other.ids_ &&
         centers_ == other.centers_ && radii_ == other.radii_ && densities_ == other.densities_;
}

}  // namespace brume
