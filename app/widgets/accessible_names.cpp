#include "app/widgets/accessible_names.h"

#include <QAbstractButton>
#include <QBoxLayout>
#include <QDockWidget>
#include <QLabel>
#include <QLineEdit>
#include <QScrollArea>
#include <QTextDocumentFragment>

#include "app/widgets/form_rows.h"
#include "app/widgets/mnemonics.h"
#include "app/widgets/number_field.h"
#include "app/widgets/value_field.h"

namespace brume {
namespace {

constexpr const char* given_key = "given_accessible_name";

// Words without marks of mnemonics; the text of an empty widget is none.
QString label_text(const QWidget* widget) {
  return widget ? without_mnemonic(widget->property("text").toString()).trimmed() : QString();
}

QString first_line(const QString& text) {
  const QString plain =
      Qt::mightBeRichText(text) ? QTextDocumentFragment::fromHtml(text).toPlainText() : text;
  return plain.section('\n', 0, 0);
}

// The label right before a widget in a row of a layout.
QString label_before(const QWidget& widget) {
  if (!widget.parentWidget()) return {};
  for (const QBoxLayout* row : widget.parentWidget()->findChildren<QBoxLayout*>()) {
    const int index = row->indexOf(&widget);
    if (index < 1) continue;
    return label_text(qobject_cast<const QLabel*>(row->itemAt(index - 1)->widget()));
  }
  return {};
}

// The text that tells the widget from others of its row.
QString own_text(const QWidget& widget) {
  const auto* number = qobject_cast<const ValueField*>(widget.parentWidget());
  if (number && &number->number() == &widget) return number->title();
  if (!widget.toolTip().isEmpty()) return first_line(widget.toolTip());
  const auto* line = qobject_cast<const QLineEdit*>(&widget);
  return line ? line->placeholderText() : QString();
}

struct Row {
  QString label;
  bool is_first = false;  // of its values
};

// The row of a form that a widget is in, itself or with what it is a part of.
Row row_of(QWidget* widget) {
  for (QWidget* part = widget; part && !qobject_cast<QScrollArea*>(part) && !part->isWindow();
       part = part->parentWidget()) {
    const QWidgetList row = row_with(part);
    if (row.size() < 2) continue;
    return {label_text(row[0]), part == widget && row[1] == widget};
  }
  return {};
}

// The name of what a widget is in.
QString panel_title(const QWidget& widget) {
  for (const QWidget* above = widget.parentWidget(); above; above = above->parentWidget()) {
    if (!above->accessibleName().isEmpty()) return above->accessibleName();
    if (qobject_cast<const QDockWidget*>(above) || above->isWindow()) return above->windowTitle();
  }
  return {};
}

QString name_of(QWidget& widget) {
  const QString own = own_text(widget);
  const Row row = row_of(&widget);
  if (!row.label.isEmpty()) {
    if (own.isEmpty() || own == row.label || row.is_first) return row.label;
    return row.label + (own.size() == 1 ? " " : ": ") + own;
  }
  if (const QString label = label_before(widget); !label.isEmpty()) return label;
  return own.isEmpty() ? panel_title(widget) : own;
}

bool has_own_name(const QWidget& widget) {
  const QString name = widget.accessibleName();
  if (!name.isEmpty()) return name != widget.property(given_key).toString();
  const auto* button = qobject_cast<const QAbstractButton*>(&widget);
  return button && !button->text().isEmpty();
}

}  // namespace

void update_accessible_name(QWidget& widget) {
  const bool is_operated =
      widget.focusPolicy() != Qt::NoFocus || qobject_cast<QAbstractButton*>(&widget);
  if (!is_operated || has_own_name(widget)) return;
  const QString name = name_of(widget);
  if (name == widget.accessibleName()) return;
  widget.setProperty(given_key, name);
  widget.setAccessibleName(name);
}

}  // namespace brume
