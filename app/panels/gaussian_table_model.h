#pragma once

#include <QAbstractTableModel>
#include <functional>
#include <optional>
#include <vector>

#include "app/document/gaussian_field.h"
#include "core/medium/medium_edit.h"

namespace brume {

class Document;

// The Gaussians of the medium as a table, a row each in the medium's order.
class GaussianTableModel : public QAbstractTableModel {
  Q_OBJECT
 public:
  explicit GaussianTableModel(Document& document, QObject* parent = nullptr);

  [[nodiscard]] GaussianId id(int row) const { return ids_[static_cast<std::size_t>(row)]; }
  [[nodiscard]] std::optional<int> row(GaussianId id) const;

  // Brings the rows in step with the medium after an edit, or from scratch.
  void follow(const MediumEdit& edit);
  void reload();

  [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
  [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override;
  [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
  // Writes to all selected Gaussians if the row is one of them.
  bool setData(const QModelIndex& index, const QVariant& value, int role) override;
  [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation,
                                    int role) const override;
  [[nodiscard]] Qt::ItemFlags flags(const QModelIndex& index) const override;

 Q_SIGNALS:
  void refused(const QString& problem);

 private:
  void announce_changes(const MediumEdit& edit);
  void remove_rows(const MediumEdit& edit);
  void insert_rows(const MediumEdit& edit);

  Document& document_;
  // The medium changes in one go, but views must hear of one run of rows after the other; this
  // is what they have heard of.
  std::vector<GaussianId> ids_;
};

}  // namespace brume
