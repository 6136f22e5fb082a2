#pragma once

#include <QAbstractTableModel>
#include <functional>
#include <optional>
#include <vector>

#include "app/document/gaussian_attribute.h"
#include "brume/edits.h"

namespace brume {

class Document;

// Table model of the medium's Gaussians, in medium order: their attributes and their group. Albedo
// and emission have swatches; the medium's albedo is grey text.
class GaussianTableModel : public QAbstractTableModel {
  Q_OBJECT
 public:
  explicit GaussianTableModel(Document& document, QObject* parent = nullptr);

  static constexpr int group_column = static_cast<int>(gaussian_attributes.size());

  [[nodiscard]] GaussianId id(int row) const { return ids_[static_cast<std::size_t>(row)]; }
  [[nodiscard]] std::optional<int> row(GaussianId id) const;

  // Updates the rows after an edit; or resets the model.
  // False if that would cost more than reload(), which then has to follow.
  [[nodiscard]] bool follow(const MediumEdit& edit);
  void reload();
  // After a change of the medium's albedo, which Gaussians without their own show.
  void follow_albedo();
  void follow_groups();  // after a change of their names or colours

  [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
  [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override;
  [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
  // Applies to the whole selection if the row is selected.
  bool setData(const QModelIndex& index, const QVariant& value, int role) override;
  [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation,
                                    int role) const override;
  [[nodiscard]] Qt::ItemFlags flags(const QModelIndex& index) const override;

 Q_SIGNALS:
  void refused(const QString& problem);

 private:
  [[nodiscard]] QVariant group_data(GroupId id, int role) const;
  void announce_changes(const MediumEdit& edit);
  bool remove_rows(const MediumEdit& edit);
  bool insert_rows(const MediumEdit& edit);

  Document& document_;
  // Ids known to views: the medium changes at once, but views are notified one range of rows at a
  // time.
  std::vector<GaussianId> ids_;
};

}  // namespace brume
