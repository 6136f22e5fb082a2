#include "app/tools/tool_box.h"

#include <algorithm>

#include "app/document/document.h"
#include "app/tools/brushes/airbrush_tool.h"
#include "app/tools/brushes/eraser_tool.h"
#include "app/tools/brushes/paintbrush_tool.h"
#include "app/tools/brushes/spline_tool.h"
#include "app/tools/emitter_tool.h"
#include "app/tools/selection/brush_select_tool.h"
#include "app/tools/selection/lasso_tool.h"
#include "app/tools/selection/transform_tool.h"
#include "app/view/view.h"

namespace brume {

ToolBox::ToolBox(Document& document, View& view, std::function<void(Tool*)> use, QObject* parent)
    : QObject(parent), use_(std::move(use)) {
  const auto add = [&]<class T>(const char* name, const QString& title, std::type_identity<T>) {
    entries_.push_back({name, title, std::make_unique<T>(document, view)});
  };
  add("select", tr("Select"), std::type_identity<SelectTool>());
  add("lasso", tr("Lasso"), std::type_identity<LassoTool>());
  add("brush_select", tr("Brush Selection"), std::type_identity<BrushSelectTool>());
  add("move", tr("Move"), std::type_identity<MoveTool>());
  add("rotate", tr("Rotate"), std::type_identity<RotateTool>());
  add("scale", tr("Scale"), std::type_identity<ScaleTool>());
  add("paintbrush", tr("Paintbrush"), std::type_identity<PaintbrushTool>());
  add("eraser", tr("Eraser"), std::type_identity<EraserTool>());
  add("airbrush", tr("Airbrush"), std::type_identity<AirbrushTool>());
  add("emitter", tr("Emitter"), std::type_identity<EmitterTool>());
  add("spline", tr("Spline Brush"), std::type_identity<SplineTool>());
  use_(entries_[active_].tool.get());
  on_change(document, Change::scene, this, [this] { tool().abandon(); });
  on_change(document, Change::medium, this, [this] { tool().medium_changed(); });
}

ToolBox::~ToolBox() {
  use_(nullptr);
}

void ToolBox::activate(const QString& name) {
  const auto found = std::ranges::find(entries_, name, &Entry::name);
  if (found != entries_.end()) activate(static_cast<std::size_t>(found - entries_.begin()));
}

void ToolBox::activate(std::size_t index) {
  if (index == active_) return;
  active_ = index;
  use_(entries_[index].tool.get());
  Q_EMIT activated(index);
}

}  // namespace brume
