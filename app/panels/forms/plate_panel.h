#pragma once

#include <QImage>
#include <QStringList>
#include <cstdint>
#include <deque>
#include <filesystem>
#include <functional>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include "app/jobs/background_job.h"
#include "app/panels/forms/scene_form.h"

namespace brume {

// A photographed picture over the frame of a camera, or behind its fog, to match the scene with.
// That of the camera in use is shown. It is no part of the scene: the user's settings keep it, by
// scene file and name of the camera.
class PlatePanel : public SceneForm {
  Q_OBJECT
 public:
  // `camera`: the name of that whose plate it is.
  PlatePanel(Document& document, std::function<QString()> camera, QWidget* parent);

  using SceneForm::refresh;
  void show_frame(int frame);

  // Reads it in the background. Empty: none.
  void set_picture(const std::filesystem::path& file);

 Q_SIGNALS:
  void plate_changed(const QImage& picture, double opacity, bool is_behind);  // null: none

 private:
  struct Plate {
    QString file;  // empty: none
    double opacity = 0.5;
    bool is_sequence = false;  // the file is one of several, which are numbered by frame
    bool is_behind = false;    // it is seen through the fog, in place of the environment
  };

  // A camera by its name, and the revision of the document since when it is there by that: another
  // may have had the name before it.
  using CameraKey = std::pair<QString, std::uint64_t>;
  struct Choice {
    CameraKey camera;
    std::filesystem::path file;
  };

  void choose();
  [[nodiscard]] CameraKey key_of(const QString& camera) const;
  [[nodiscard]] CameraKey camera() const { return key_of(camera_()); }
  [[nodiscard]] CameraKey in_use() const;
  [[nodiscard]] Plate plate_of(const CameraKey& camera) const;
  [[nodiscard]] Plate plate() const { return plate_of(camera()); }
  void change(const std::function<void(Plate&)>& how);  // that of the camera
  void restore();
  void store() const;
  void read_next();
  void follow_cameras();
  void show_plate();

  std::function<QString()> camera_;
  std::map<CameraKey, Plate> plates_;                 // of deleted cameras as well
  std::vector<CameraKey> cameras_;                    // of the scene
  std::map<QString, std::set<std::uint64_t>> since_;  // what keys of cameras have, by name
  std::uint64_t last_revision_ = 0;                   // that has been seen
  int frame_ = 0;
  std::pair<QString, int> shown_;  // the file of the picture, and its frame if it is a sequence
  QImage picture_;
  BackgroundJob reading_{BackgroundJob::Policy::latest_wins};  // of the camera in use
  std::deque<Choice> choices_;                                 // the first one is being read
  BackgroundJob choosing_{BackgroundJob::Policy::latest_wins};
};

}  // namespace brume
