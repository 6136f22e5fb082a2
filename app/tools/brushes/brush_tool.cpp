#include "app/tools/brushes/brush_tool.h"
#include "core/scene/camera_rays.h"

#include <QLineF>

#include "app/document/document.h"

namespace brume {

BrushTool::BrushTool(Document& document, View& view) : Tool(document, view), gesture_(document) {
  connect(this, &Tool::options_changed, this, &Tool::appearance_changed);
}

void BrushTool::hover(QPointF position) {
  cursor_ = position;
  Q_EMIT appearance_changed();
}

void BrushTool::leave() {
  cursor_.reset();
  Q_EMIT appearance_changed();
}

void BrushTool::press(QPointF position, Qt::KeyboardModifiers /*modifiers*/) {
  hover(position);
  gesture_.begin();
  path_.begin(position);
  brush_ = position;
  pressure_before_ = pressure_;
  begin_stroke(position);
}

void BrushTool::move(std::span<const QPointF> path) {
  if (!gesture_.is_running() || smoothing() <= 0.0) {
    hover(path.back());
    if (gesture_.is_running()) extend_stroke(path_.extend(path));
  } else {
    std::vector<QPointF> trail;
    for (const QPointF position : path) {
      const QLineF string(position, brush_);
      if (string.length() <= smoothing()) continue;
      brush_ = string.pointAt(smoothing() / string.length());
      trail.push_back(brush_);
    }
    hover(brush_);
    extend_stroke(path_.extend(trail));
  }
  pressure_before_ = pressure_;
}

void BrushTool::release(QPointF /*position*/) {
  if (gesture_.is_running()) extend_stroke(path_.end());
  end_gesture();
}

void BrushTool::cancel() {
  gesture_.cancel();
  end_gesture();
}

void BrushTool::abandon() {
  end_gesture();
}

void BrushTool::end_gesture() {
  gesture_.end();
  end_stroke();
}

void BrushTool::medium_changed() {
  if (!gesture_.is_applying()) end_gesture();
}

}  // namespace brume
