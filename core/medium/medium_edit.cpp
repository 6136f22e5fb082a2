#include "brume/edits.h"

#include <algorithm>
#include <cassert>
#include <limits>

namespace brume {
namespace {

// Removes the elements at sorted indices.
template <class T>
void erase(SharedColumn<T>& column, const std::vector<std::size_t>& dropped) {
  const std::size_t left = column.size() - dropped.size();
  if (dropped.front() < left) {
    const std::span<T> all = column.write();
    std::size_t target = dropped.front();
    std::size_t next = 0;
    for (std::size_t source = target; source < all.size(); ++source) {
      if (next < dropped.size() && dropped[next] == source) {
        ++next;
      } else {
        all[target++] = all[source];
      }
    }
  }
  column.resize(left);
}

// Makes room at sorted indices, which count what is inserted before them.
template <class T>
void insert(SharedColumn<T>& column, const std::vector<std::size_t>& added) {
  std::size_t source = column.size();
  column.resize(source + added.size());
  const std::span<T> all = column.write();
  // From the back: every element moves at most once.
  std::size_t remaining = added.size();
  for (std::size_t target = all.size(); remaining > 0;) {
    --target;
    if (added[remaining - 1] == target) {
      --remaining;
    } else {
      all[target] = all[--source];
    }
  }
}

// Index of an id, found at once if the ids come in the order of the medium without gaps.
class IndexFinder {
 public:
  explicit IndexFinder(const Medium& medium) : medium_(medium) {}

  std::optional<std::size_t> operator()(GaussianId id) {
    if (next_ >= medium_.size() || medium_.ids()[next_] != id) {
      const auto found = medium_.index_of(id);
      if (!found) return std::nullopt;
      next_ = *found;
    }
    return next_++;
  }

 private:
  const Medium& medium_;
  std::size_t next_ = 0;
};

template <class T>
void by_id(std::vector<T>& entries) {
  if (!std::ranges::is_sorted(entries, {}, &T::id)) std::ranges::sort(entries, {}, &T::id);
}

}  // namespace

MediumEdit MediumEdit::add(const Medium& medium, std::span<const Gaussian> gaussians) {
  MediumEdit edit;
  GaussianId id = medium.next_id();
  for (const Gaussian& gaussian : gaussians) edit.added_.push_back({id++, gaussian});
  return edit;
}

MediumEdit MediumEdit::remove(const Medium& medium, std::span<const GaussianId> ids) {
  MediumEdit edit;
  edit.removed_.reserve(ids.size());
  IndexFinder index_of(medium);
  for (const GaussianId id : ids) {
    const auto index = index_of(id);
    assert(index && "MediumEdit::remove: no such Gaussian");
    edit.removed_.push_back({id, medium.gaussian(*index)});
  }
  by_id(edit.removed_);
  return edit;
}

MediumEdit MediumEdit::change(const Medium& medium, std::span<const GaussianId> ids,
                              std::span<const Gaussian> after) {
  assert(ids.size() == after.size());
  MediumEdit edit;
  edit.changed_.reserve(ids.size());
  IndexFinder index_of(medium);
  for (std::size_t k = 0; k < ids.size(); ++k) {
    const auto index = index_of(ids[k]);
    assert(index && "MediumEdit::change: no such Gaussian");
    const Gaussian before = medium.gaussian(*index);
    if (!(before == after[k])) edit.changed_.push_back({ids[k], before, after[k]});
  }
  by_id(edit.changed_);
  return edit;
}

MediumEdit MediumEdit::set_homogeneous_density(const Medium& medium, double b0) {
  MediumEdit edit;
  if (b0 != medium.homogeneous_density()) {
    edit.homogeneous_density_ = {medium.homogeneous_density(), b0};
  }
  return edit;
}

bool MediumEdit::empty() const {
  return added_.empty() && removed_.empty() && changed_.empty() && !homogeneous_density_;
}

MediumEdit MediumEdit::inverted() const {
  MediumEdit inverse = *this;
  std::swap(inverse.added_, inverse.removed_);
  for (Change& change : inverse.changed_) std::swap(change.before, change.after);
  if (inverse.homogeneous_density_) {
    std::swap(inverse.homogeneous_density_->first, inverse.homogeneous_density_->second);
  }
  return inverse;
}

void MediumEdit::apply(Medium& medium) const {
  if (empty()) return;
  const auto each_column = [&medium](auto visit) {
    visit(medium.centers_);
    visit(medium.radii_);
    visit(medium.densities_);
    visit(medium.ids_);
    if (!medium.optics_.empty()) visit(medium.optics_);
    if (!medium.groups_.empty()) visit(medium.groups_);
  };
  const auto put = [&medium](std::size_t index, const Gaussian& gaussian) {
    medium.centers_.set(index, gaussian.center);
    medium.radii_.set(index, gaussian.radius);
    medium.densities_.set(index, gaussian.density);
    medium.set_optics(index, gaussian.optics);
    medium.set_group(index, gaussian.group);
  };

  if (!removed_.empty()) {
    std::vector<std::size_t> dropped;
    dropped.reserve(removed_.size());
    IndexFinder index_of(medium);
    for (const Entry& entry : removed_) {
      const auto index = index_of(entry.id);
      assert(index && "MediumEdit::apply: the Gaussian to remove is not there");
      dropped.push_back(*index);
    }
    each_column([&](auto& column) { erase(column, dropped); });
  }
  IndexFinder index_of(medium);
  for (const Change& change : changed_) {
    const auto index = index_of(change.id);
    assert(index && "MediumEdit::apply: the Gaussian to change is not there");
    put(*index, change.after);
  }
  if (!added_.empty()) {
    if (medium.empty() || medium.ids().back() < added_.front().id) {
      for (const Entry& entry : added_) medium.push_back(entry.id, entry.gaussian);
    } else {
      std::vector<std::size_t> added;
      added.reserve(added_.size());
      const std::span<const GaussianId> ids = medium.ids();
      auto place = ids.begin();
      for (const Entry& entry : added_) {
        place = std::lower_bound(place, ids.end(), entry.id);
        added.push_back(static_cast<std::size_t>(place - ids.begin()) + added.size());
      }
      each_column([&](auto& column) { insert(column, added); });
      for (std::size_t k = 0; k < added.size(); ++k) {
        medium.ids_.set(added[k], added_[k].id);
        put(added[k], added_[k].gaussian);
      }
    }
    medium.next_id_ = std::max(medium.next_id_, added_.back().id + 1);
  }
  if (homogeneous_density_) medium.homogeneous_density_ = homogeneous_density_->second;
  medium.revision_ = new_revision();
}

std::vector<MediumEdit::Step> MediumEdit::steps() const {
  std::vector<Step> steps;
  const std::size_t count = added_.size() + removed_.size() + changed_.size();
  steps.reserve(count);
  auto added = added_.begin();
  auto removed = removed_.begin();
  auto changed = changed_.begin();
  const auto id_of = [](auto entry, const auto& entries) {
    return entry == entries.end() ? std::numeric_limits<GaussianId>::max() : entry->id;
  };
  while (steps.size() < count) {
    const GaussianId a = id_of(added, added_);
    const GaussianId r = id_of(removed, removed_);
    const GaussianId c = id_of(changed, changed_);
    if (a < r && a < c) {
      steps.push_back({a, std::nullopt, added++->gaussian});
    } else if (r < c) {
      steps.push_back({r, removed++->gaussian, std::nullopt});
    } else {
      steps.push_back({c, changed->before, changed->after});
      ++changed;
    }
  }
  return steps;
}

void MediumEdit::append(const Step& step) {
  if (step.before == step.after) return;
  if (!step.before) {
    added_.push_back({step.id, *step.after});
  } else if (!step.after) {
    removed_.push_back({step.id, *step.before});
  } else {
    changed_.push_back({step.id, *step.before, *step.after});
  }
}

void MediumEdit::merge(const MediumEdit& later) {
  const std::vector<Step> first = steps();
  const std::vector<Step> second = later.steps();
  added_.clear();
  removed_.clear();
  changed_.clear();
  auto next = second.begin();
  for (const Step& step : first) {
    while (next != second.end() && next->id < step.id) append(*next++);
    const bool again = next != second.end() && next->id == step.id;
    append(again ? Step{step.id, step.before, (next++)->after} : step);
  }
  while (next != second.end()) append(*next++);

  if (later.homogeneous_density_) {
    const double before =
        homogeneous_density_ ? homogeneous_density_->first : later.homogeneous_density_->first;
    homogeneous_density_ = {before, later.homogeneous_density_->second};
    if (before == homogeneous_density_->second) homogeneous_density_.reset();
  }
}

}  // namespace brume
