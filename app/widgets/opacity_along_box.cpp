#include "app/widgets/opacity_along_box.h"

namespace brume {

OpacityAlongBox::OpacityAlongBox(QWidget* parent) : QComboBox(parent) {
  addItem(tr("Shortest radius"), static_cast<int>(OpacityAlong::shortest));
  addItem(tr("Mean radius"), static_cast<int>(OpacityAlong::mean));
  addItem(tr("Longest radius"), static_cast<int>(OpacityAlong::longest));
  setCurrentIndex(findData(static_cast<int>(OpacityAlong::mean)));
  setToolTip(tr("A splat is as opaque from every side; fog is more opaque along longer radii"));
}

OpacityAlong OpacityAlongBox::along() const {
  return static_cast<OpacityAlong>(currentData().toInt());
}

}  // namespace brume
