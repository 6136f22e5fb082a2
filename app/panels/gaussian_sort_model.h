#pragma once

#include <QSortFilterProxyModel>
#include <map>
#include <vector>

#include "app/panels/gaussian_filter.h"
#include "brume/gaussian.h"

namespace brume {

class Document;
class GaussianTableModel;

// Sorts the table by a column, or in medium order (column -1), and filters it.
class GaussianSortModel : public QSortFilterProxyModel {
  Q_OBJECT
 public:
  GaussianSortModel(const Document& document, GaussianTableModel& rows, QObject* parent);

  void set_filter(GaussianFilter filter);
  void sort(int column, Qt::SortOrder order) override;

  [[nodiscard]] GaussianId id(int row) const;
  [[nodiscard]] std::optional<int> row(GaussianId id) const;  // nullopt: filtered out

 protected:
  [[nodiscard]] bool filterAcceptsRow(int row, const QModelIndex& parent) const override;
  [[nodiscard]] bool lessThan(const QModelIndex& left, const QModelIndex& right) const override;

 private:
  void cache_keys(int column);
  void rank_groups();
  [[nodiscard]] double key(std::size_t index, int column) const;
  // Index in the medium; nullopt if the table is not up to date.
  [[nodiscard]] std::optional<std::size_t> index_of(int source_row) const;

  const Document& document_;
  GaussianTableModel& rows_;
  GaussianFilter filter_;
  // Cached sort keys of all rows; empty after any change.
  std::vector<double> keys_;
  int keys_column_ = -1;
  std::map<GroupId, double> group_ranks_;  // by name; 0 of none
};

}  // namespace brume
