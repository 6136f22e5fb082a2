#pragma once

#include "app/panels/forms/scene_form.h"

class QListWidget;

namespace brume {

struct Emitter;

// List of emitters, and the parameters of the active one.
class EmitterPanel : public SceneForm {
  Q_OBJECT
 public:
  EmitterPanel(Document& document, QWidget* parent);

 private:
  void add_list(QFormLayout& form);
  void add_fields(QFormLayout& form);
  void add_span(QFormLayout& form);
  void add_optics(QFormLayout& form);
  [[nodiscard]] const Emitter* emitter() const;  // the active one; may be null

  QListWidget* list_;
  bool showing_ = false;
};

}  // namespace brume
