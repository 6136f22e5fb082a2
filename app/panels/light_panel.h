#pragma once

#include "app/file_reader.h"
#include "app/panels/scene_form.h"
#include "core/scene/scene.h"

class QLabel;
class QListWidget;

namespace brume {

class ViewGrid;

// The lights, the one that is meant in numbers, and the environment.
class LightPanel : public SceneForm {
  Q_OBJECT
 public:
  LightPanel(Document& document, const ViewGrid& views, QWidget* parent);

  // Reads a radiance map in the background; it becomes the environment.
  void load_environment(const QString& file);

 private:
  void add_light_list(QFormLayout& form);
  void add_light_fields(QFormLayout& form);
  void add_environment_fields(QFormLayout& form);
  void show_lights();
  void choose_environment();
  void show_environment();
  [[nodiscard]] const PointLight* light() const;  // the one that is meant; nullptr if none

  const ViewGrid& views_;
  QListWidget* list_;
  QLabel* picture_ = nullptr;            // of the environment
  std::optional<Environment> pictured_;  // of which one
  bool showing_ = false;
  FileReader<std::shared_ptr<const RadianceMap>> reader_;
};

}  // namespace brume
