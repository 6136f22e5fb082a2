#pragma once

#include <QDialog>
#include <filesystem>
#include <optional>

#include "app/import/scene_import.h"
#include "app/import/volume_fit.h"

class QComboBox;
class QDoubleSpinBox;
class QLineEdit;
class QSpinBox;

namespace brume {

// Asks how a volume, or a run of them, becomes Gaussians.
class VolumeDialog : public QDialog {
  Q_OBJECT
 public:
  VolumeDialog(const std::filesystem::path& file, const std::optional<FrameRun>& run,
               QWidget* parent);

  // Where the Gaussians of a run are written to.
  [[nodiscard]] std::filesystem::path folder() const;

 Q_SIGNALS:
  void wanted(const brume::VolumeFit& how);

 private:
  void take();

  QComboBox* grid_;
  QSpinBox* count_;
  QDoubleSpinBox* error_;
  QLineEdit* scale_;
  QComboBox* up_;
  QLineEdit* folder_ = nullptr;  // of a run only
};

}  // namespace brume
