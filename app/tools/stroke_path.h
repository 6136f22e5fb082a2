#pragma once

#include <QPointF>
#include <optional>
#include <span>
#include <vector>

#include "core/authoring/smooth_path.h"

namespace brume {

// The smooth curve that a tool draws where the mouse went, in pixels of the film.
class StrokePath {
 public:
  void begin(QPointF position);
  // What the mouse's next positions settle of the curve.
  std::vector<QPointF> to(std::span<const QPointF> positions);
  // The rest of it.
  std::vector<QPointF> end();

 private:
  std::optional<SmoothPath> path_;
};

}  // namespace brume
