#pragma once

#include <QImage>
#include <QStringList>
#include <filesystem>
#include <map>

#include "app/jobs/background_job.h"
#include "app/panels/forms/scene_form.h"

namespace brume {

// A photographed picture over the frame of the camera in use, to match the scene with. It is no
// part of the scene: the user's settings keep it, by scene file and name of the camera.
class PlatePanel : public SceneForm {
  Q_OBJECT
 public:
  PlatePanel(Document& document, QWidget* parent);

  // Reads it in the background. Empty: none.
  void set_picture(const std::filesystem::path& file);

 Q_SIGNALS:
  void plate_changed(const QImage& picture, double opacity);  // null: there is none

 private:
  struct Plate {
    QString file;  // empty: none
    double opacity = 0.5;
  };

  void choose();
  [[nodiscard]] QString camera() const;
  [[nodiscard]] Plate plate() const;  // of the camera in use
  void set_plate(const Plate& plate);
  void restore();
  void store() const;
  void follow_cameras();
  void show_plate();

  std::map<QString, Plate> plates_;  // by cameras
  QStringList cameras_;
  QString shown_;  // the file of the picture
  QImage picture_;
  BackgroundJob reading_{BackgroundJob::Policy::latest_wins};
};

}  // namespace brume
