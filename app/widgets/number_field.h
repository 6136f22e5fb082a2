#pragma once

#include <QLineEdit>
#include <optional>

namespace brume {

// A number field that may be empty ("–") or mixed. Enter and leaving the field commit, Escape
// reverts; both keys return the focus to the view.
class NumberField : public QLineEdit {
  Q_OBJECT
 public:
  explicit NumberField(QWidget* parent = nullptr);

  void show_value(std::optional<double> value);  // nullopt: empty
  void show_mixed();                             // several different values
  void commit();                                 // typed text, if any

 Q_SIGNALS:
  void committed(double value);  // NaN if the text is no number

 protected:
  void keyPressEvent(QKeyEvent* event) override;
  void focusInEvent(QFocusEvent* event) override;
  void focusOutEvent(QFocusEvent* event) override;

 private:
  void revert();

  std::optional<double> value_;
};

}  // namespace brume
