#pragma once

#include <QWidget>
#include <optional>

#include "app/commands/gaussians/medium_command.h"
#include "app/document/text/arithmetic.h"
#include "app/widgets/mouse_drag.h"
#include "core/number_domain.h"

class QLabel;

namespace brume {

class NumberField;

// A titled number: typed, scrolled while it has the focus, or dragged on its title; Ctrl is fine,
// Shift is coarse. It
// shows what it is told to show, and asks for changes by edited().
class ValueField : public QWidget {
  Q_OBJECT
 public:
  // Effect of a pixel of drag: adds `step`, or multiplies by 1 + step.
  enum class Scale { linear, logarithmic };
  ValueField(const QString& title, const NumberDomain& domain, Scale scale, double step,
             QWidget* parent = nullptr);

  // Releases the title label for placement in a form.
  [[nodiscard]] QLabel* detach_title();
  [[nodiscard]] const QString& title() const { return title_; }
  [[nodiscard]] QString range() const;  // "Allowed: a number >= 0"

  void show_value(std::optional<double> value);  // nullopt: nothing there
  void show_mixed();

  // The text field.
  [[nodiscard]] NumberField& number() const { return *field_; }

 Q_SIGNALS:
  // Value within the domain. Edits of one drag or wheel turn share an id.
  void edited(double value, brume::MergeId gesture);
  void adjusted(const brume::Adjustment& adjustment);  // of each of several different values
  void refused(const QString& problem);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void enterEvent(QEnterEvent* event) override;

 private:
  void change(double steps, Qt::KeyboardModifiers modifiers);

  QString title_;
  NumberDomain domain_;
  Scale scale_;
  double step_;
  std::optional<double> value_;
  QLabel* label_;
  NumberField* field_;
  MergeId gesture_ = no_merge;
  double last_x_ = 0.0;
  MouseDrag mouse_{this};
  std::optional<double> pressed_;  // the value when the title was pressed
};

// Shows the user's unit in the fields of these object names, or of these with _x, _y and _z.
void show_length_units(const QWidget& form, std::initializer_list<const char*> names);

}  // namespace brume
