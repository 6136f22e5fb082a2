#pragma once

#include <QMessageBox>
#include <vector>

namespace brume {

struct Answer {
  QMessageBox::StandardButton button;
  QString text = {};  // empty: the standard text
};

// A modal question in plain text. The first answer is the default.
QMessageBox::StandardButton ask(QWidget* window, const QString& title, const QString& text,
                                const std::vector<Answer>& answers);

}  // namespace brume
