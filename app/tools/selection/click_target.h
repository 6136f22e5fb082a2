#pragma once

#include <QPointF>
#include <optional>

#include "app/document/object_ref.h"
#include "brume/medium.h"

namespace brume {

class Document;
class View;

// The meaning of a click: at most one of these.
struct ClickTarget {
  std::optional<GaussianId> gaussian;
  std::optional<ObjectRef> object;

  bool operator==(const ClickTarget&) const = default;
};

// Handles of Gaussians and emitters come first, then surfaces seen through thin fog, then the
// Gaussian that takes most light at the position. What is locked is not met.
ClickTarget click_target(const Document& document, View& view, QPointF position);

constexpr double emitter_radius = 7.0;  // of the ring of an emitter [pixels]

}  // namespace brume
