#pragma once

#include <QtCore/qnamespace.h>
#include <map>
#include <optional>
#include <vector>

#include "app/document/gaussian_attribute.h"
#include "app/panels/gaussians/gaussian_filter.h"
#include "brume/edits.h"

namespace brume {

class Document;

// Which Gaussians a table shows, and in which order: those that pass a filter, sorted by a column
// or as in the medium.
class GaussianRows {
 public:
  explicit GaussianRows(const Document& document) : document_(document) { arrange(); }

  static constexpr int group_column = static_cast<int>(gaussian_attributes.size());
  static constexpr int id_column = group_column + 1;
  static constexpr int no_column = -1;  // as in the medium

  void sort_by(int column, Qt::SortOrder order);
  void set_filter(GaussianFilter filter);
  // From the document as it is now.
  void arrange();
  // Rows of the medium's from `first` on, as they are now: without any filter or sorting only.
  void insert(std::size_t first, std::size_t count);
  void erase(std::size_t first, std::size_t count);

  [[nodiscard]] bool is_as_in_medium() const { return column_ < 0 && filter_.is_empty(); }
  // Whether another value in a column may call for arrange().
  [[nodiscard]] bool depends_on(int column) const;

  [[nodiscard]] std::size_t size() const { return ids_.size(); }
  [[nodiscard]] GaussianId id(int row) const { return ids_[static_cast<std::size_t>(row)]; }
  // nullopt: it is not shown.
  [[nodiscard]] std::optional<int> row(GaussianId id) const;

 private:
  struct Place {
    GaussianId id = 0;
    int row = 0;
  };

  void rank_groups();
  [[nodiscard]] double key(std::size_t index) const;  // that rows are sorted by

  const Document& document_;
  GaussianFilter filter_;
  int column_ = no_column;
  Qt::SortOrder order_ = Qt::AscendingOrder;
  std::map<GroupId, double> group_ranks_;  // by name; 0 of none
  std::vector<GaussianId> ids_;            // of the rows
  mutable std::vector<Place> places_;      // by id, where rows are sorted; empty until asked for
};

}  // namespace brume
