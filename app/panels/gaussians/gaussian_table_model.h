#pragma once

#include <QAbstractTableModel>
#include <optional>
#include <span>

#include "app/panels/gaussians/gaussian_rows.h"

namespace brume {

class Document;
struct TypedColor;

// The table of the medium's Gaussians: their attributes, their group and their id. Albedo and
// emission have swatches; the medium's albedo is grey text.
class GaussianTableModel : public QAbstractTableModel {
  Q_OBJECT
 public:
  explicit GaussianTableModel(Document& document, QObject* parent = nullptr);

  static constexpr int group_column = GaussianRows::group_column;
  static constexpr int id_column = GaussianRows::id_column;  // as At the Cursor and files have it

  [[nodiscard]] GaussianId id(int row) const { return rows_.id(row); }
  // nullopt: it is not shown.
  [[nodiscard]] std::optional<int> row(GaussianId id) const { return rows_.row(id); }

  // After an edit. False if rows come, go or move in more than one place: reload() has to follow,
  // until then they are those of before.
  [[nodiscard]] bool follow(const MediumEdit& edit);
  void reload();  // resets the model
  // After a change of the medium's albedo, which Gaussians without their own show.
  void follow_albedo();
  void follow_groups();  // after a change of their names or colours
  void set_filter(GaussianFilter filter);

  void sort(int column, Qt::SortOrder order) override;
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
  // Returns why not; empty: done.
  QString set_color(std::span<const GaussianId> ids, GaussianAttribute field,
                    const TypedColor& color);
  [[nodiscard]] QVariant group_data(GroupId id, int role) const;
  [[nodiscard]] bool follow_changes(const MediumEdit& edit);
  void follow_column(int column);

  Document& document_;
  GaussianRows rows_;  // those that views know of
};

}  // namespace brume
