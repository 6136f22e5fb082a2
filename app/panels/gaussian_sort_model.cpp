#include "app/panels/gaussian_sort_model.h"

#include <limits>

#include "app/document/document.h"
#include "app/panels/gaussian_table_model.h"

namespace brume {

GaussianSortModel::GaussianSortModel(const Document& document, GaussianTableModel& rows,
                                     QObject* parent)
    : QSortFilterProxyModel(parent), document_(document), rows_(rows) {
  // Heard of before the base class does, which then sorts.
  connect(&rows, &QAbstractItemModel::modelReset, this, [this] { cache_keys(sortColumn()); });
  const auto forget = [this] { keys_.clear(); };
  connect(&rows, &QAbstractItemModel::dataChanged, this, forget);
  connect(&rows, &QAbstractItemModel::rowsInserted, this, forget);
  connect(&rows, &QAbstractItemModel::rowsRemoved, this, forget);
  setSourceModel(&rows);
  connect(&document, &Document::groups_changed, this, [this] {
    rank_groups();
    if (sortColumn() == GaussianTableModel::group_column || filter_.is_of_groups()) invalidate();
  });
}

void GaussianSortModel::rank_groups() {
  std::map<QString, GroupId> by_name;
  for (const Group& group : document_.scene().groups) {
    by_name[QString::fromStdString(group.name).toLower()] = group.id;
  }
  group_ranks_.clear();
  double rank = 0.0;
  for (const auto& [name, id] : by_name) group_ranks_[id] = ++rank;
}

double GaussianSortModel::key(std::size_t index, int column) const {
  if (column == GaussianTableModel::group_column) {
    const auto rank = group_ranks_.find(document_.medium().group(index));
    return rank == group_ranks_.end() ? 0.0 : rank->second;
  }
  return attribute_value(document_.effective_gaussian(index),
                         gaussian_attributes[static_cast<std::size_t>(column)]);
}

void GaussianSortModel::sort(int column, Qt::SortOrder order) {
  cache_keys(column);
  QSortFilterProxyModel::sort(column, order);
}

void GaussianSortModel::cache_keys(int column) {
  keys_.clear();
  keys_column_ = column;
  if (column < 0) return;
  rank_groups();
  for (int row = 0; row < rows_.rowCount(); ++row) {
    const auto index = index_of(row);
    keys_.push_back(index ? key(*index, column) : -std::numeric_limits<double>::infinity());
  }
}

void GaussianSortModel::set_filter(GaussianFilter filter) {
  filter_ = std::move(filter);
  invalidateFilter();
}

GaussianId GaussianSortModel::id(int row) const {
  return rows_.id(mapToSource(index(row, 0)).row());
}

std::optional<int> GaussianSortModel::row(GaussianId id) const {
  const auto source = rows_.row(id);
  if (!source) return std::nullopt;
  const QModelIndex mapped = mapFromSource(rows_.index(*source, 0));
  return mapped.isValid() ? std::optional(mapped.row()) : std::nullopt;
}

std::optional<std::size_t> GaussianSortModel::index_of(int source_row) const {
  const GaussianId id = rows_.id(source_row);
  const auto ids = document_.medium().ids();
  // Nearly always rows are as in the medium.
  const auto same = static_cast<std::size_t>(source_row);
  if (same < ids.size() && ids[same] == id) return same;
  return document_.medium().index_of(id);
}

bool GaussianSortModel::filterAcceptsRow(int row, const QModelIndex& /*parent*/) const {
  if (filter_.is_empty()) return true;
  const auto index = index_of(row);
  return !index || filter_.passes(document_.effective_gaussian(*index), document_.scene().groups);
}

bool GaussianSortModel::lessThan(const QModelIndex& left, const QModelIndex& right) const {
  if (!keys_.empty() && left.column() == keys_column_) {
    return keys_[static_cast<std::size_t>(left.row())] <
           keys_[static_cast<std::size_t>(right.row())];
  }
  const auto a = index_of(left.row());
  const auto b = index_of(right.row());
  if (!a || !b) return b.has_value();
  return key(*a, left.column()) < key(*b, left.column());
}

}  // namespace brume
