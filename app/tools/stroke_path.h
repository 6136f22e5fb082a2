#pragma once

#include <QPointF>
#include <optional>
#include <span>
#include <vector>

#include "core/authoring/smooth_path.h"

namespace brume {

// A smoothed mouse path in film pixels.
class StrokePath {
 public:
  void begin(QPointF position);
  // Adds mouse positions; returns the new points of the curve.
  std::vector<QPointF> extend(std::span<const QPointF> positions);
  // The remaining points.
  std::vector<QPointF> end();

 private:
  std::optional<SmoothPath> path_;
};

}  // namespace brume
