#pragma once

#include <QComboBox>

#include "brume/splat.h"

namespace brume {

// Asks along which radius of an ellipsoid fog is as opaque as a splat; first the mean one.
class OpacityAlongBox : public QComboBox {
  Q_OBJECT
 public:
  explicit OpacityAlongBox(QWidget* parent);

  [[nodiscard]] OpacityAlong along() const;
};

}  // namespace brume
