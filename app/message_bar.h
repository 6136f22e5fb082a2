#pragma once

#include <QFrame>

class QLabel;

namespace brume {

// What went wrong, in a bar above the picture until it is closed: nothing to click away first.
class MessageBar : public QFrame {
  Q_OBJECT
 public:
  explicit MessageBar(QWidget* parent = nullptr);

  void show_error(const QString& message);
  void show_note(const QString& message);
  [[nodiscard]] QString message() const;

 private:
  void show_message(const QString& message, const QString& color);

  QLabel* label_;
};

}  // namespace brume
