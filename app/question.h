#pragma once

#include <QMessageBox>
#include <vector>

namespace brume {

struct Answer {
  QMessageBox::StandardButton button;
  QString text = {};  // empty: the button's own
};

// A question that has to be answered first, in plain text. The first answer is what Enter gives.
QMessageBox::StandardButton ask(QWidget* window, const QString& title, const QString& text,
                                const std::vector<Answer>& answers);

}  // namespace brume
