#pragma once

#include <QDialog>
#include <filesystem>

#include "brume/splat.h"

class QComboBox;

namespace brume {

// Asks what splats become: an opacity is no density, and captures mostly have y down.
class SplatDialog : public QDialog {
  Q_OBJECT
 public:
  SplatDialog(const std::filesystem::path& file, QWidget* parent);

 Q_SIGNALS:
  void requested(brume::OpacityAlong along, bool y_down);

 private:
  QComboBox* along_;
  QComboBox* up_;
};

}  // namespace brume
