#pragma once

#include "app/panels/scene_form.h"

class QListWidget;

namespace brume {

struct Emitter;

// The emitters of particles, and the one that is meant in numbers.
class EmitterPanel : public SceneForm {
  Q_OBJECT
 public:
  EmitterPanel(Document& document, QWidget* parent);

 private:
  void add_list(QFormLayout& form);
  void add_fields(QFormLayout& form);
  [[nodiscard]] const Emitter* emitter() const;  // the one that is meant; nullptr if none

  QListWidget* list_;
  bool showing_ = false;
};

}  // namespace brume
