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

std::optional<Gaussian> GaussianSortModel::gaussian(int source_row) const {
  const auto at = document_.medium().index_of(rows_.id(source_row));
  return at ? std::optional(document_.medium().gaussian(*at)) : std::nullopt;
}

bool GaussianSortModel::filterAcceptsRow(int row, const QModelIndex& /*parent*/) const {
  if (filter_.is_empty()) return true;
  const auto found = gaussian(row);
  return !found || filter_.passes(*found);
}

bool GaussianSortModel::lessThan(const QModelIndex& left, const QModelIndex& right) const {
  const auto a = gaussian(left.row());
  const auto b = gaussian(right.row());
  const GaussianField field = gaussian_fields[static_cast<std::size_t>(left.column())];
  if (!a || !b) return b.has_value();
  return field_value(*a, field) < field_value(*b, field);
}

}  // namespace brume
