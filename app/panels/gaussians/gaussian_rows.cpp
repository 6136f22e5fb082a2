#include "app/panels/gaussians/gaussian_rows.h"

#include <QString>
#include <algorithm>
#include <utility>

#include "app/document/document.h"

namespace brume {

void GaussianRows::sort_by(int column, Qt::SortOrder order) {
  column_ = column;
  order_ = order;
  arrange();
}

void GaussianRows::set_filter(GaussianFilter filter) {
  filter_ = std::move(filter);
  arrange();
}

void GaussianRows::arrange() {
  const Medium& medium = document_.medium();
  places_.clear();
  if (is_as_in_medium()) {
    ids_.assign(medium.ids().begin(), medium.ids().end());
    return;
  }
  rank_groups();
  struct Entry {
    double key;
    GaussianId id;
  };
  std::vector<Entry> entries;
  for (std::size_t i = 0; i < medium.size(); ++i) {
    const bool passes =
        filter_.is_empty() ||
        filter_.passes(document_.effective_gaussian(i), document_.scene().groups, medium.ids()[i]);
    if (passes) entries.push_back({column_ < 0 ? 0.0 : key(i), medium.ids()[i]});
  }
  // Equal ones as in the medium, whose ids ascend.
  if (column_ >= 0 && order_ == Qt::AscendingOrder) {
    std::ranges::sort(entries, [](const Entry& a, const Entry& b) {
      return std::pair(a.key, a.id) < std::pair(b.key, b.id);
    });
  } else if (column_ >= 0) {
    std::ranges::sort(entries, [](const Entry& a, const Entry& b) {
      return std::pair(b.key, a.id) < std::pair(a.key, b.id);
    });
  }
  ids_.clear();
  ids_.reserve(entries.size());
  for (const Entry& entry : entries) ids_.push_back(entry.id);
}

void GaussianRows::insert(std::size_t first, std::size_t count) {
  const auto now = document_.medium().ids().subspan(first, count);
  ids_.insert(ids_.begin() + static_cast<std::ptrdiff_t>(first), now.begin(), now.end());
}

void GaussianRows::erase(std::size_t first, std::size_t count) {
  const auto range_begin = ids_.begin() + static_cast<std::ptrdiff_t>(first);
  ids_.erase(range_begin, range_begin + static_cast<std::ptrdiff_t>(count));
}

bool GaussianRows::depends_on(int column) const {
  if (column == column_) return true;
  if (column == id_column) return false;  // it stays
  return column == group_column ? filter_.is_of_groups() : !filter_.is_empty();
}

std::optional<int> GaussianRows::row(GaussianId id) const {
  if (column_ < 0) {
    const auto found = std::ranges::lower_bound(ids_, id);
    if (found == ids_.end() || *found != id) return std::nullopt;
    return static_cast<int>(found - ids_.begin());
  }
  if (places_.empty()) {
    places_.reserve(ids_.size());
    for (const GaussianId each : ids_) places_.push_back({each, static_cast<int>(places_.size())});
    std::ranges::sort(places_, {}, &Place::id);
  }
  const auto found = std::ranges::lower_bound(places_, id, {}, &Place::id);
  return found == places_.end() || found->id != id ? std::nullopt : std::optional(found->row);
}

void GaussianRows::rank_groups() {
  std::map<QString, GroupId> by_name;
  for (const Group& group : document_.scene().groups) {
    by_name[QString::fromStdString(group.name).toLower()] = group.id;
  }
  group_ranks_.clear();
  double rank = 0.0;
  for (const auto& [name, id] : by_name) group_ranks_[id] = ++rank;
}

double GaussianRows::key(std::size_t index) const {
  if (column_ == id_column) return static_cast<double>(document_.medium().ids()[index]);
  if (column_ == group_column) {
    const auto rank = group_ranks_.find(document_.medium().group(index));
    return rank == group_ranks_.end() ? 0.0 : rank->second;
  }
  return document_.value(index, gaussian_attributes[static_cast<std::size_t>(column_)]);
}

}  // namespace brume
