#include "app/widgets/question.h"

#include <QPushButton>

namespace brume {

QMessageBox::StandardButton ask(QWidget* window, const QString& title, const QString& text,
                                const std::vector<Answer>& answers) {
  QMessageBox box(QMessageBox::Warning, title, text, QMessageBox::NoButton, window);
  box.setTextFormat(Qt::PlainText);
  for (const Answer& answer : answers) {
    QPushButton* button = box.addButton(answer.button);
    if (!answer.text.isEmpty()) button->setText(answer.text);
  }
  box.setDefaultButton(answers.front().button);
  box.exec();
  return box.standardButton(box.clickedButton());
}

}  // namespace brume
