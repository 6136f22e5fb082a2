#pragma once

#include <QObject>

class QWidget;

namespace brume {

// How fields answer, in all panels alike. Of the application:
// - the wheel changes a spin box, a choice or a slider only where it has the focus; elsewhere it
//   scrolls what that is in;
// - what is being typed is committed by a click anywhere else, by a shortcut, and when the window
//   closes;
// - letters typed into a list search its names, or open a cell, and are no shortcuts, nor are
//   Delete, Home and End; all but tables, text and what has the property keeps_focus lose the focus
//   where the mouse comes to the picture;
// - undo and redo are the document's, unless the text was changed since the field got the focus;
// - the label and the values of a form's row have one tool tip, with the range of a number;
// - what one acts on has an accessible name;
// - after Enter, which takes it, and Escape, which does not, the view has the focus.
class FieldFilter : public QObject {
  Q_OBJECT
 public:
  using QObject::QObject;

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
};

// Ends typing in the line, number or cell of a table that has the focus, whose text counts.
// Whatever saves, closes or replaces the scene without a click or a key calls this first.
void commit_typing();

// Ends editing: moves the focus to the main window's central widget. False if there is none, as in
// dialogs.
bool leave_field(QWidget& field);

}  // namespace brume
