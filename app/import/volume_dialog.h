#pragma once

#include <QDialog>
#include <filesystem>
#include <optional>

#include "app/import/frame_run.h"
#include "app/import/volume_fit.h"

class QComboBox;
class QDoubleSpinBox;
class QLineEdit;
class QSpinBox;

namespace brume {

class AppearanceFields;

// Dialog for the fit options of a volume or sequence.
class VolumeDialog : public QDialog {
  Q_OBJECT
 public:
  VolumeDialog(const std::filesystem::path& file, const std::optional<FrameRun>& run,
               QWidget* parent);

  // Output folder of a sequence.
  [[nodiscard]] std::filesystem::path folder() const;

 Q_SIGNALS:
  void requested(const brume::VolumeFit& how);

 private:
  void confirm();

  QComboBox* grid_;
  QSpinBox* count_;
  QDoubleSpinBox* error_;
  QLineEdit* scale_;
  QComboBox* up_;
  AppearanceFields* appearance_;
  QLineEdit* folder_ = nullptr;  // sequences only
};

}  // namespace brume
