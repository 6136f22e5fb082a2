#pragma once

#include <QFrame>
#include <functional>
#include <vector>

class QHBoxLayout;
class QLabel;

namespace brume {

// What went wrong, and what can be done about it, in a bar above the picture until it is closed:
// nothing to click away first.
class MessageBar : public QFrame {
  Q_OBJECT
 public:
  explicit MessageBar(QWidget* parent = nullptr);

  // What the user may do about a message; taken, it goes.
  struct Offer {
    QString text;
    QString name;  // of the button, as an object
    std::function<void()> react;
  };

  void show_error(const QString& message);
  void show_note(const QString& message);
  void show_offers(const QString& message, const std::vector<Offer>& offers);
  [[nodiscard]] QString message() const;

 private:
  void show_message(const QString& message, const QString& color, const std::vector<Offer>& offers);

  QLabel* label_;
  QHBoxLayout* offers_;
};

}  // namespace brume
