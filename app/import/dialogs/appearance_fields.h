#pragma once

#include <QObject>
#include <vector>

#include "core/fit/volume_appearance.h"

class QComboBox;
class QFormLayout;
class QLineEdit;

namespace brume {

// The rows of a form that ask which grids of a volume colour it and make it shine, and how.
class AppearanceFields : public QObject {
  Q_OBJECT
 public:
  // `grids`: of the volume. Its rows belong to the form's widget.
  AppearanceFields(QFormLayout* form, const std::vector<VolumeGridInfo>& grids);

  [[nodiscard]] AppearanceOptions options() const;
  // Whether all numbers are in their domains.
  [[nodiscard]] bool is_acceptable() const;

 Q_SIGNALS:
  void changed();

 private:
  QComboBox* add_grid(QFormLayout* form, const QString& title, const char* name, OpticsRole role,
                      const std::vector<VolumeGridInfo>& grids);
  QLineEdit* add_number(QFormLayout* form, const QString& title, const char* name, double value,
                        double min_value, double max_value);

  QComboBox* color_;
  QComboBox* emission_;
  QComboBox* temperature_;
  QComboBox* flame_;
  QLineEdit* temperature_scale_;
  QLineEdit* emission_scale_;
  QLineEdit* flame_scale_;
  QLineEdit* flame_temperature_;
};

// A field of a number in the C locale, of 12 digits.
QLineEdit* number_edit(const char* name, double value, double min_value, double max_value,
                       QWidget* parent);

}  // namespace brume
