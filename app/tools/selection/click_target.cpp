#include "app/tools/selection/click_target.h"
#include "core/scene/camera_rays.h"

#include <QLineF>

#include "app/document/document.h"
#include "app/view/view.h"
#include "app/widgets/interface_settings.h"

namespace brume {
namespace {

std::optional<ObjectRef> object_at(const Document& document, View& view, QPointF position) {
  const CameraRays rays = view.rays();
  const Emitters& emitters = document.scene().emitters;
  for (std::size_t k = 0; k < emitters.size(); ++k) {
    const glm::dvec3 projected = rays.project(emitters[k].position);
    if (!emitters[k].locked && projected.z > 0.0 &&
        QLineF(QPointF(projected.x, projected.y), position).length() <=
            emitter_radius * handle_scale()) {
      return ObjectRef{ObjectRef::Kind::emitter, k};
    }
  }
  const auto surface = view.visible_surface(position);
  return surface ? std::optional(ObjectRef{ObjectRef::Kind::surface, *surface}) : std::nullopt;
}

}  // namespace

ClickTarget click_target(const Document& document, View& view, QPointF position) {
  if (const auto index = view.handles().pick(position)) {
    return {document.medium().ids()[*index], std::nullopt};
  }
  if (const auto object = object_at(document, view, position)) return {std::nullopt, object};
  return {view.max_visible(position), std::nullopt};
}

}  // namespace brume
