#pragma once

#include <optional>

#include "app/jobs/background_job.h"
#include "app/panels/forms/scene_form.h"
#include "brume/scene.h"

class QLabel;

namespace brume {

// The environment: its map, intensity and rotation.
class EnvironmentPanel : public SceneForm {
  Q_OBJECT
 public:
  EnvironmentPanel(Document& document, QWidget* parent);

  // Loads a map in the background.
  void load(const QString& file);

 private:
  void add_file(QFormLayout& form);
  void choose();
  void show_picture();

  QLabel* picture_ = nullptr;
  std::optional<Environment> pictured_;  // the environment of picture_
  BackgroundJob reading_{BackgroundJob::Policy::latest_wins};
};

}  // namespace brume
