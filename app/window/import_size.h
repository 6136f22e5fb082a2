#pragma once

#include <QObject>

#include "app/view/floor.h"
#include "app/window/workspace.h"
#include "brume/scene.h"

namespace brume {

// The offers once surfaces have been imported that are far too large or small for the scene:
// to fit them into it, to take their numbers for another unit, to put them on the floor. Each is
// one undo step, and shows the surfaces again.
class ImportSize : public QObject {
  Q_OBJECT
 public:
  ImportSize(const Workspace& work, QObject* parent);

  // Frames the surfaces from `first` on in the view, unless they are or it looks through the
  // scene's camera, and offers what helps where their size does not suit what is looked at.
  void show(std::size_t first, bool is_framed);

 private:
  [[nodiscard]] SurfaceRange range() const;
  [[nodiscard]] bool is_there() const;
  void frame();
  void offer();
  // `text`: of the undo step, with %1 for the name.
  void change(const QString& text, const std::function<void(Surface&)>& how);
  void fit();
  void set_unit(const QString& name, double length);
  void drop();

  Workspace work_;
  std::size_t first_ = 0;
  std::vector<Surface> added_;  // as they came
  double size_ = 0.0;           // of what was looked at before [u]
  glm::dvec3 target_{0.0};      // which is there
  QString message_;             // that the offers are in
};

}  // namespace brume
