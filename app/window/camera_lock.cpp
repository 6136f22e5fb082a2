#include "app/window/camera_lock.h"

#include <QEvent>

#include "app/commands/objects/edit_cameras.h"
#include "app/document/document.h"
#include "app/viewport/viewport.h"

namespace brume {
namespace {

constexpr int wheel_pause = 600;  // milliseconds

}  // namespace

CameraLock::CameraLock(Document& document, Viewport& view) : QObject(&view), document_(document) {
  view.installEventFilter(this);
  pause_.setSingleShot(true);
  connect(&view.camera_controller(), &CameraController::scene_camera_asked_for, this,
          [this](const Camera& camera) {
            if (gesture_ == no_merge) gesture_ = new_merge_id();
            move_camera(document_, camera, gesture_);
          });
}

bool CameraLock::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::MouseButtonPress || event->type() == QEvent::KeyPress) {
    gesture_ = new_merge_id();
  } else if (event->type() == QEvent::Wheel) {
    if (!pause_.isActive()) gesture_ = new_merge_id();
    pause_.start(wheel_pause);
  }
  return QObject::eventFilter(watched, event);
}

}  // namespace brume
