#pragma once

#include <QWidget>
#include <optional>

#include "app/commands/medium_command.h"
#include "core/io/number_domain.h"

class QLabel;

namespace brume {

class NumberField;

// A titled number: typed, scrolled while it has the focus, or dragged on its title; Ctrl is fine,
// Shift is coarse. It
// shows what it is told to show, and asks for changes by edited().
class ValueField : public QWidget {
  Q_OBJECT
 public:
  // What a pixel of drag does: adds `step`, or multiplies by 1 + step.
  enum class Scale { linear, logarithmic };
  ValueField(const QString& title, const NumberDomain& domain, Scale scale, double step,
             QWidget* parent = nullptr);

  // The title for a form to put elsewhere.
  [[nodiscard]] QLabel* take_title();

  void show_value(std::optional<double> value);  // nullopt: nothing there
  void show_mixed();

  // Where it is typed.
  [[nodiscard]] NumberField& number() const { return *field_; }

 Q_SIGNALS:
  // Within the domain. Edits of one drag, or of one turning of the wheel, have one id.
  void edited(double value, brume::MergeId gesture);
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
};

}  // namespace brume
