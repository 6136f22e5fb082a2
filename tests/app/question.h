#pragma once

#include <QAbstractButton>
#include <QApplication>
#include <QMessageBox>
#include <QTimer>

namespace brume {

// Presses a button of the question that is about to be asked, and says what it was.
inline void answer(QMessageBox::StandardButton button, QString* text = nullptr) {
  QTimer::singleShot(50, qApp, [button, text] {
    auto* question = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
    if (question && question->button(button)) {
      if (text) *text = question->text();
      question->button(button)->click();
    } else {
      answer(button, text);
    }
  });
}

}  // namespace brume
