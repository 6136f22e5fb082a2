#pragma once

#include <QImage>

#include "app/panels/forms/scene_form.h"

class QAction;
class QListWidget;
class QVBoxLayout;

namespace brume {

class PlatePanel;
struct Camera;

// The scene's cameras by name, and place, lens and plate of one of them, which need not be in use.
class CameraPanel : public SceneForm {
  Q_OBJECT
 public:
  // `view`: the camera of the perspective view.
  CameraPanel(Document& document, std::function<Camera()> view, QWidget* parent);

  // Adds a check box for what the view shows of the camera.
  void add_toggle(QAction* action);
  // Shows its values. Empty: that in use, whichever it is.
  void show_camera(const QString& name);
  void show_frame(int frame);  // of plates

 Q_SIGNALS:
  void look_through_asked_for();
  // The plate is that of the camera in use.
  void plate_changed(const QImage& picture, double opacity, bool is_behind);

 private:
  QWidget* new_list();
  QWidget* new_buttons();
  void add_values(QFormLayout& form);
  void add_projection(QFormLayout& form);
  void add_film_backs(QFormLayout& form);
  void add_lenses(QFormLayout& form);
  void add_focal_length(QFormLayout& form);
  [[nodiscard]] double focal_length() const;  // of the lens before the film back [mm]
  void set_focal_length(double length, MergeId gesture);
  void add_focus(QFormLayout& form);
  void set_field(const Camera& camera, const FieldInfo& info, MergeId gesture);
  void set_camera(const Camera& camera, const QString& what, MergeId gesture);
  void follow_names();
  void show_cameras();
  [[nodiscard]] QString name_in_use() const;
  [[nodiscard]] QString name() const;  // of the camera whose values are shown
  [[nodiscard]] const Camera& camera() const;

  std::function<Camera()> view_;
  QListWidget* list_;
  PlatePanel* plate_ = nullptr;
  QString chosen_;  // name of the camera whose values are shown; empty: it is in use
  QStringList names_;
  QVBoxLayout* toggles_ = nullptr;
  double film_back_;          // its width [mm], a setting of the user
  bool is_changing_ = false;  // the list, by this panel or by a name that is being taken over
};

}  // namespace brume
