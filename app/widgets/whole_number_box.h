#pragma once

#include <QSpinBox>

namespace brume {

// A whole number from `low` to `high`, called `title` in messages. Qt's box would take -3 for 3:
// here a minus sign below 0 is refused. When typing ends with one, the box shows the number that it
// had.
class WholeNumberBox : public QSpinBox {
  Q_OBJECT
 public:
  WholeNumberBox(QString title, int low, int high, QWidget* parent);

  // Why what is being typed, or was last, is no number allowed; empty if it is one.
  [[nodiscard]] QString problem() const;

  QValidator::State validate(QString& text, int& position) const override;
  // Qt asks here about a text that is no number allowed.
  void fixup(QString& text) const override;
  void stepBy(int steps) override;

 Q_SIGNALS:
  void refused(const QString& problem) const;
  void changed();  // its value, what is being typed, or problem()

 private:
  [[nodiscard]] QString message() const;

  QString title_;
  mutable bool is_refused_ = false;  // what was typed last
};

}  // namespace brume
