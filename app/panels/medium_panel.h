#pragma once

#include "app/panels/scene_form.h"

namespace brume {

// What all of the medium has in common: the homogeneous part, what scattering does to light, noise.
class MediumPanel : public SceneForm {
  Q_OBJECT
 public:
  MediumPanel(Document& document, QWidget* parent);
};

}  // namespace brume
