#include "brume/edits.h"

#include <algorithm>
#include <cassert>

namespace brume {
namespace {

// Closes the gaps that elements at sorted indices leave.
template <class T>
void close_gaps(std::span<T> all, const std::vector<std::size_t>& dropped) {
  std::size_t target = dropped.front();
  for (std::size_t k = 0; k < dropped.size(); ++k) {
    const std::size_t first = dropped[k] + 1;
    const std::size_t last = k + 1 < dropped.size() ? dropped[k + 1] : all.size();
    for (std::size_t source = first; source < last; ++source) all[target++] = all[source];
  }
}

// Removes the elements at sorted indices.
template <class T>
void drop(std::vector<T>& entries, const std::vector<std::size_t>& dropped) {
  close_gaps(std::span(entries), dropped);
  entries.resize(entries.size() - dropped.size());
}
template <class T>
void drop(SharedColumn<T>& column, const std::vector<std::size_t>& dropped) {
  const std::size_t left = column.size() - dropped.size();
  if (dropped.front() < left) close_gaps(column.write(), dropped);
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

// Entries ordered by id, of which some go and others come, all at once in the end.
template <class T>
class Splice {
 public:
  explicit Splice(std::vector<T>& entries) : entries_(entries) {}

  [[nodiscard]] T* find(GaussianId id) {
    const auto entry = std::ranges::lower_bound(entries_, id, {}, &T::id);
    return entry == entries_.end() || entry->id != id ? nullptr : &*entry;
  }
  void erase(const T& entry) {
    dropped_.push_back(static_cast<std::size_t>(&entry - entries_.data()));
  }
  void insert(const T& entry) { more_.push_back(entry); }

  void finish() {
    std::ranges::sort(dropped_);
    if (!dropped_.empty()) drop(entries_, dropped_);
    if (more_.empty()) return;
    std::ranges::sort(more_, {}, &T::id);
    const auto count = static_cast<std::ptrdiff_t>(entries_.size());
    entries_.insert(entries_.end(), more_.begin(), more_.end());
    const auto middle = entries_.begin() + count;
    const auto first =
        std::ranges::lower_bound(entries_.begin(), middle, more_.front().id, {}, &T::id);
    std::ranges::inplace_merge(first, middle, entries_.end(), {}, &T::id);
  }

 private:
  std::vector<T>& entries_;
  std::vector<std::size_t> dropped_;
  std::vector<T> more_;
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

MediumEdit MediumEdit::add([[maybe_unused]] const Medium& medium,
                           std::span<const Gaussian> gaussians, std::span<const GaussianId> ids) {
  assert(ids.size() == gaussians.size() && std::ranges::is_sorted(ids));
  MediumEdit edit;
  for (std::size_t k = 0; k < ids.size(); ++k) {
    assert(!medium.index_of(ids[k]) && "MediumEdit::add: the id is taken");
    edit.added_.push_back({ids[k], gaussians[k]});
  }
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
    if (!medium.shapes_.empty()) visit(medium.shapes_);
  };
  const auto put = [&medium](std::size_t index, const Gaussian& gaussian) {
    medium.centers_.set(index, gaussian.center);
    medium.radii_.set(index, gaussian.radius);
    medium.densities_.set(index, gaussian.density);
    medium.set_optics(index, gaussian.optics);
    medium.set_group(index, gaussian.group);
    medium.set_shape(index, gaussian.shape);
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
    each_column([&](auto& column) { drop(column, dropped); });
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

void MediumEdit::merge(const MediumEdit& later) {
  Splice<Entry> added(added_);
  Splice<Entry> removed(removed_);
  Splice<Change> changed(changed_);
  for (const Entry& entry : later.added_) {
    const Entry* before = removed.find(entry.id);
    if (!before) {
      added.insert(entry);
    } else {
      if (before->gaussian != entry.gaussian) {
        changed.insert({entry.id, before->gaussian, entry.gaussian});
      }
      removed.erase(*before);
    }
  }
  for (const Entry& entry : later.removed_) {
    if (const Entry* before = added.find(entry.id)) {
      added.erase(*before);
    } else if (const Change* change = changed.find(entry.id)) {
      removed.insert({entry.id, change->before});
      changed.erase(*change);
    } else {
      removed.insert(entry);
    }
  }
  for (const Change& change : later.changed_) {
    if (Entry* before = added.find(change.id)) {
      before->gaussian = change.after;
    } else if (Change* first = changed.find(change.id)) {
      first->after = change.after;
      if (first->before == first->after) changed.erase(*first);
    } else {
      changed.insert(change);
    }
  }
  added.finish();
  removed.finish();
  changed.finish();

  if (later.homogeneous_density_) {
    const double before =
        homogeneous_density_ ? homogeneous_density_->first : later.homogeneous_density_->first;
    homogeneous_density_ = {before, later.homogeneous_density_->second};
    if (before == homogeneous_density_->second) homogeneous_density_.reset();
  }
}

}  // namespace brume
