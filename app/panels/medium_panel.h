#pragma once

#include "app/panels/scene_form.h"

namespace brume {

// Global parameters of the medium: homogeneous density, scattering, noise.
class MediumPanel : public SceneForm {
  Q_OBJECT
 public:
  MediumPanel(Document& document, QWidget* parent);
};

}  // namespace brume
