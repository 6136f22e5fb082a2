#pragma once

#include <QDialog>
#include <QDialogButtonBox>
#include <QHBoxLayout>
#include <QScrollArea>
#include <initializer_list>

namespace brume {

// A widget with an object name, by which tests and style sheets know it.
template <class W>
W* named(W* widget, const QString& name) {
  widget->setObjectName(name);
  return widget;
}
template <class W>
W* named(W* widget, const QString& name, const QString& tool_tip) {
  widget->setToolTip(tool_tip);
  return named(widget, name);
}

// Widgets side by side; the first gets the room that is left.
inline QHBoxLayout* row_of(std::initializer_list<QWidget*> widgets) {
  auto* row = new QHBoxLayout;
  for (QWidget* widget : widgets) row->addWidget(widget);
  row->setStretch(0, 1);
  return row;
}

// A panel that scrolls where it has no room.
inline QScrollArea* scrolled(QWidget* panel) {
  auto* area = new QScrollArea;
  area->setWidget(panel);
  area->setWidgetResizable(true);
  area->setFrameShape(QFrame::NoFrame);
  return area;
}

// The last row of a dialog: Cancel, and the button that accepts it.
inline QDialogButtonBox* dialog_buttons(QDialog* dialog, QAbstractButton* accept, auto&& react) {
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel, dialog);
  buttons->addButton(accept, QDialogButtonBox::AcceptRole);
  QObject::connect(buttons, &QDialogButtonBox::accepted, dialog, react);
  QObject::connect(buttons, &QDialogButtonBox::rejected, dialog, &QDialog::reject);
  return buttons;
}

}  // namespace brume
