#pragma once

#include <QComboBox>
#include <optional>

#include "brume/output.h"

namespace brume {

// How frames are to be rendered: as the view renders, or by paths, with their noise or without.
class MethodBox : public QComboBox {
  Q_OBJECT
 public:
  explicit MethodBox(QWidget* parent);

  // Absent: as the view renders.
  [[nodiscard]] std::optional<Denoising> paths() const;
  void set_paths(std::optional<Denoising> denoise);

  // The number of paths per pixel that is offered first.
  static int first_paths(Denoising denoise);
};

}  // namespace brume
