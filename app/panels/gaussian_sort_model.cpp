#include "app/panels/gaussian_sort_model.h"

#include "app/document/document.h"
#include "app/panels/gaussian_table_model.h"

namespace brume {

GaussianSortModel::GaussianSortModel(const Document& document, GaussianTableModel& rows,
                                     QObject* parent)
    : QSortFilterProxyModel(parent), document_(document), rows_(rows) {
  setSourceModel(&rows);
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
  return !index || filter_.passes(document_.medium().gaussian(*index));
}

bool GaussianSortModel::lessThan(const QModelIndex& left, const QModelIndex& right) const {
  const auto a = index_of(left.row());
  const auto b = index_of(right.row());
  if (!a || !b) return b.has_value();
  const Medium& medium = document_.medium();
  const GaussianField field = gaussian_fields[static_cast<std::size_t>(left.column())];
  return field_value(medium.gaussian(*a), field) < field_value(medium.gaussian(*b), field);
}

}  // namespace brume
