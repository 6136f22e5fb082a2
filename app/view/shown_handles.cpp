#include "app/view/shown_handles.h"

#include "app/document/document.h"
#include "app/view/camera_controller.h"

namespace brume {

ShownHandles::ShownHandles(const Document& document, const CameraController& camera)
    : document_(document), camera_(camera) {
  connect(&camera, &CameraController::moved, this, &ShownHandles::project);
  connect(&document, &Document::medium_changed, this, &ShownHandles::project);
  connect(&document, &Document::hidden_or_locked_changed, this, &ShownHandles::project);
  connect(&document, &Document::selection_changed, this, &ShownHandles::changed);
  connect(&document, &Document::scene_replaced, this, [this] { hovered_.reset(); });
}

void ShownHandles::set_hovered(std::optional<GaussianId> id) {
  if (id == hovered_) return;
  hovered_ = id;
  Q_EMIT changed();
}

void ShownHandles::show_centers(bool centers) {
  centers_ = centers;
  Q_EMIT changed();
}

void ShownHandles::project() {
  handles_.project(document_.medium(), camera_.rays(), document_.hidden(), document_.locked());
  Q_EMIT changed();
}

void ShownHandles::classify_depth(const Camera& camera, const Frame& frame) {
  handles_.classify_depth(document_.medium(), {camera, frame.film}, frame);
  Q_EMIT changed();
}

bool ShownHandles::use_depth() const {
  return centers_ || !document_.selection().empty();
}

void ShownHandles::draw(Overlay& overlay) const {
  handles_.draw(overlay, document_.medium(), camera_.rays(), document_.selection(), hovered_,
                centers_);
}

void ShownHandles::draw_outlines(Overlay& overlay) const {
  handles_.draw_outlines(overlay, document_.medium(), camera_.rays());
}

}  // namespace brume
