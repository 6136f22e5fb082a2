#include "app/tools/lasso_tool.h"

#include "app/application.h"
#include "app/document/document.h"
#include "app/viewport/viewport.h"

namespace brume {

QString LassoTool::hint() const {
  return tr("Draw around what you want to select. Shift adds, Ctrl removes, both intersect.");
}

void LassoTool::press(QPointF position, Qt::KeyboardModifiers modifiers) {
  gesture_mode_ = mode_with(modifiers);
  line_ = {position};
}

void LassoTool::move(QPointF position) {
  if (line_.isEmpty()) return;
  line_ << position;
  Q_EMIT looks_changed();
}

void LassoTool::release(QPointF /*position*/) {
  if (line_.isEmpty()) return;
  choose(document_.selection(), view().handles().inside([this](QPointF at) {
    return line_.containsPoint(at, Qt::OddEvenFill);
  }),
         gesture_mode_);
  abandon();
}

void LassoTool::abandon() {
  line_.clear();
  Q_EMIT looks_changed();
}

void LassoTool::draw_on_film(Overlay& overlay) const {
  const auto vertex = [this](qsizetype k) {
    const QPointF& p = line_.at(k % line_.size());
    return Overlay::Vertex{static_cast<float>(p.x()), static_cast<float>(p.y()),
                           accent_color().rgba()};
  };
  for (qsizetype k = 0; k < line_.size(); ++k) {
    overlay.lines.push_back(vertex(k));
    overlay.lines.push_back(vertex(k + 1));
  }
}

}  // namespace brume
