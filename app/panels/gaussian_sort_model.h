#pragma once

#include <QSortFilterProxyModel>
#include <vector>

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
  void sort(int column, Qt::SortOrder order) override;

  [[nodiscard]] GaussianId id(int row) const;
  [[nodiscard]] std::optional<int> row(GaussianId id) const;  // nullopt: does not pass

 protected:
  [[nodiscard]] bool filterAcceptsRow(int row, const QModelIndex& parent) const override;
  [[nodiscard]] bool lessThan(const QModelIndex& left, const QModelIndex& right) const override;

 private:
  void take_keys(int column);
  // In the medium; nullopt where that is ahead of the table, which is yet to be told.
  [[nodiscard]] std::optional<std::size_t> index_of(int source_row) const;

  const Document& document_;
  GaussianTableModel& rows_;
  GaussianFilter filter_;
  // What all rows are sorted by, at hand when there are many to sort; empty once any has changed.
  std::vector<double> keys_;
  int keys_column_ = -1;
};

}  // namespace brume
