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
  [[nodiscard]] QString camera_name() const;  // of the one in use
  [[nodiscard]] Plate plate() const;          // of the camera in use
  void set_plate(const Plate& plate);
  void restore();
  void store() const;
  void follow_cameras();
  void show_plate();

  std::map<QString, Plate> plates_;  // by cameras, deleted ones as well
  QStringList cameras_;
  QString shown_;  // the file of the picture
  QImage picture_;
  QString chosen_for_;                                          // the camera
  BackgroundJob reading_{BackgroundJob::Policy::latest_wins};   // of the camera in use
  BackgroundJob choosing_{BackgroundJob::Policy::latest_wins};  // goes on for another camera in use
};

}  // namespace brume
