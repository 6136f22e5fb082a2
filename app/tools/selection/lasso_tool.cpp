#include "app/tools/selection/lasso_tool.h"

#include "app/document/document.h"
#include "app/view/view.h"
#include "app/widgets/application.h"

namespace brume {

QString LassoTool::hint() const {
  return tr("Draw around what you want to select. Shift adds, Ctrl removes, both intersect.");
}

void LassoTool::press(QPointF position, Qt::KeyboardModifiers modifiers) {
  gesture_mode_ = mode_with(modifiers);
  line_ = {position};
  path_.begin(position);
  cursor_ = position;
}

void LassoTool::move(std::span<const QPointF> path) {
  if (line_.isEmpty()) return;
  extend(path_.extend(path));
  cursor_ = path.back();
  Q_EMIT appearance_changed();
}

void LassoTool::extend(const std::vector<QPointF>& curve) {
  for (const QPointF point : curve) line_ << point;
}

void LassoTool::release(QPointF /*position*/) {
  if (line_.isEmpty()) return;
  extend(path_.end());
  choose(document_.selection(), view().handles().inside([this](QPointF at) {
    return line_.containsPoint(at, Qt::OddEvenFill);
  }),
         gesture_mode_);
  abandon();
}

void LassoTool::abandon() {
  line_.clear();
  Q_EMIT appearance_changed();
}

void LassoTool::draw_on_film(Overlay& overlay) const {
  if (line_.isEmpty()) return;
  const QPolygonF closed = QPolygonF(line_) << cursor_ << line_.front();
  const auto vertex = [](QPointF p) {
    return Overlay::Vertex{static_cast<float>(p.x()), static_cast<float>(p.y()),
                           accent_color().rgba()};
  };
  for (qsizetype k = 1; k < closed.size(); ++k) {
    overlay.lines.push_back(vertex(closed[k - 1]));
    overlay.lines.push_back(vertex(closed[k]));
  }
}

}  // namespace brume
