#pragma once

#include <QDialog>
#include <cstdint>
#include <optional>

#include "app/import/frame_run.h"
#include "brume/splat.h"

class QCheckBox;
class QComboBox;
class QLineEdit;

namespace brume {

class OpacityAlongBox;

// The up axis of splats: captures mostly have y down, or z up.
enum class SplatUp : std::uint8_t { y, minus_y, z };
struct SplatOptions {
  SplatInput input;
  SplatUp up = SplatUp::y;
};

// Asks for them; of a sequence also for the folder that its Gaussians are written to.
class SplatDialog : public QDialog {
  Q_OBJECT
 public:
  // `what` is imported.
  SplatDialog(const QString& what, const std::optional<FrameRun>& run, QWidget* parent);

  [[nodiscard]] std::filesystem::path folder() const;

 Q_SIGNALS:
  void requested(const brume::SplatOptions& options);

 private:
  OpacityAlongBox* along_;
  QComboBox* up_;
  QCheckBox* albedos_;
  QLineEdit* folder_ = nullptr;
};

}  // namespace brume
