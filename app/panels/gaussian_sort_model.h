#pragma once

#include <QSortFilterProxyModel>

#include "app/panels/gaussian_filter.h"
#include "core/medium/gaussian.h"

namespace brume {

class Document;
class GaussianTableModel;

// The rows of the Gaussians as the user wants to see them: sorted by a column, or in the medium's
// order (column -1), and only those that pass a filter.
class GaussianSortModel : public QSortFilterProxyModel {
  Q_OBJECT
 public:
  GaussianSortModel(const Document& document, GaussianTableModel& rows, QObject* parent);

  void set_filter(GaussianFilter filter);

  [[nodiscard]] GaussianId id(int row) const;
  [[nodiscard]] std::optional<int> row(GaussianId id) const;  // nullopt: does not pass

 protected:
  [[nodiscard]] bool filterAcceptsRow(int row, const QModelIndex& parent) const override;
  [[nodiscard]] bool lessThan(const QModelIndex& left, const QModelIndex& right) const override;

 private:
  // In the medium; nullopt where that is ahead of the table, which is yet to be told.
  [[nodiscard]] std::optional<std::size_t> index_of(int source_row) const;

  const Document& document_;
  GaussianTableModel& rows_;
  GaussianFilter filter_;
};

}  // namespace brume
