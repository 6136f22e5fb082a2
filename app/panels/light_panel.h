#pragma once

#include "app/panels/scene_form.h"

class QListWidget;

namespace brume {

struct PointLight;
class ViewGrid;

// The lights, the one that is meant in numbers, and the environment.
class LightPanel : public SceneForm {
  Q_OBJECT
 public:
  LightPanel(Document& document, const ViewGrid& views, QWidget* parent);

  // Reads a radiance map, which becomes the environment.
  void load_environment(const QString& file);

 private:
  void add_light_list(QFormLayout& form);
  void add_light_fields(QFormLayout& form);
  void add_environment_fields(QFormLayout& form);
  void show_lights();
  void choose_environment();
  [[nodiscard]] const PointLight* light() const;  // the one that is meant; nullptr if none

  const ViewGrid& views_;
  QListWidget* list_;
  bool showing_ = false;
};

}  // namespace brume
