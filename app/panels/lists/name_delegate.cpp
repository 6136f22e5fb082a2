#include "app/panels/lists/name_delegate.h"

#include <QLineEdit>

namespace brume {

QWidget* NameDelegate::createEditor(QWidget* parent, const QStyleOptionViewItem& option,
                                    const QModelIndex& index) const {
  if (!index.data(name_role).isValid()) return nullptr;
  QWidget* editor = QStyledItemDelegate::createEditor(parent, option, index);
  editor->setObjectName("row_name");
  return editor;
}

void NameDelegate::setEditorData(QWidget* editor, const QModelIndex& index) const {
  auto* line = static_cast<QLineEdit*>(editor);
  if (!line->isModified()) line->setText(index.data(name_role).toString());
}

void NameDelegate::setModelData(QWidget* editor, QAbstractItemModel* /*model*/,
                                const QModelIndex& index) const {
  rename_(index, static_cast<QLineEdit*>(editor)->text());
}

}  // namespace brume
