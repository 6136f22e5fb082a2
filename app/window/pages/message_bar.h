#pragma once

#include <QFrame>
#include <functional>
#include <vector>

class QHBoxLayout;
class QLabel;

namespace brume {

// Shows errors and offers actions in a bar above the picture, without blocking.
class MessageBar : public QFrame {
  Q_OBJECT
 public:
  explicit MessageBar(QWidget* parent = nullptr);

  // An action offered with a message; performing it closes the bar.
  struct Offer {
    QString text;
    QString name;  // object name of the button
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
