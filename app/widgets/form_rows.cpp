#include "app/widgets/form_rows.h"

#include <QFormLayout>

namespace brume {
namespace {

QWidgetList widgets_in(const QLayoutItem* item) {
  QWidgetList found;
  if (!item) return found;
  if (item->widget()) found << const_cast<QLayoutItem*>(item)->widget();
  const QLayout* layout = const_cast<QLayoutItem*>(item)->layout();
  for (int k = 0; layout && k < layout->count(); ++k) found << widgets_in(layout->itemAt(k));
  return found;
}

}  // namespace

QWidgetList row_with(QWidget* widget) {
  if (!widget || !widget->parentWidget()) return {};
  for (const QFormLayout* form : widget->parentWidget()->findChildren<QFormLayout*>()) {
    for (int row = 0; row < form->rowCount(); ++row) {
      const QWidgetList widgets = widgets_in(form->itemAt(row, QFormLayout::LabelRole)) +
                                  widgets_in(form->itemAt(row, QFormLayout::FieldRole));
      if (widgets.contains(widget)) return widgets;
    }
  }
  return {};
}

}  // namespace brume
