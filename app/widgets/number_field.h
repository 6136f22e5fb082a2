#pragma once

#include <QLineEdit>
#include <optional>

#include "app/document/text/arithmetic.h"

namespace brume {

// A number field that may be empty ("–") or mixed. It takes numbers, arithmetic, and changes of
// what it shows, such as "*2" (see app/document/text/arithmetic.h). Enter and leaving the field
// commit, Escape reverts; both keys return the focus to the view.
class NumberField : public QLineEdit {
  Q_OBJECT
 public:
  explicit NumberField(QWidget* parent = nullptr);

  void show_value(std::optional<double> value);  // nullopt: empty
  void show_mixed();                             // several different values
  void commit();                                 // typed text, if any
  // Shows the user's unit behind a length, unless it is being edited.
  void show_length_unit();

 Q_SIGNALS:
  void committed(double value);                        // NaN if the text is no number
  void adjusted(const brume::Adjustment& adjustment);  // of each of several different values

 protected:
  void keyPressEvent(QKeyEvent* event) override;
  void focusInEvent(QFocusEvent* event) override;
  void focusOutEvent(QFocusEvent* event) override;

 private:
  void revert();
  [[nodiscard]] QString shown_text() const;
  [[nodiscard]] QString typed_text() const;  // without a unit

  std::optional<double> value_;
  bool is_mixed_ = false;
  bool is_length_ = false;
};

}  // namespace brume
