#pragma once

#include <QStyledItemDelegate>
#include <functional>

namespace brume {

// Edits names in the rows of a tree: of rows that have one as their name_role, which need not be
// all that they show.
class NameDelegate : public QStyledItemDelegate {
  Q_OBJECT
 public:
  static constexpr int name_role = Qt::UserRole + 8;
  using Rename = std::function<void(const QModelIndex& row, const QString& name)>;

  // `rename` is called while the editor is open: it must not make rows anew at once.
  NameDelegate(Rename rename, QObject* parent)
      : QStyledItemDelegate(parent), rename_(std::move(rename)) {}

  QWidget* createEditor(QWidget* parent, const QStyleOptionViewItem& option,
                        const QModelIndex& index) const override;
  void setEditorData(QWidget* editor, const QModelIndex& index) const override;
  void setModelData(QWidget* editor, QAbstractItemModel* model,
                    const QModelIndex& index) const override;

 private:
  Rename rename_;
};

}  // namespace brume
