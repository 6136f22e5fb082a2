#pragma once

#include <QLineEdit>
#include <optional>

namespace brume {

// A number that may not be there ("–") or be mixed. What was typed is committed by Enter and by
// leaving the field; Escape brings the old value back. After either key the view has the focus.
class NumberField : public QLineEdit {
  Q_OBJECT
 public:
  explicit NumberField(QWidget* parent = nullptr);

  void show_value(std::optional<double> value);  // nullopt: nothing there
  void show_mixed();                             // several that differ
  void commit();                                 // what was typed, if anything

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
