#pragma once

#include <QObject>

#include "app/view/drawing/handles.h"

namespace brume {

class CameraController;
class Document;

// The handles that a view shows of the document's Gaussians.
class ShownHandles : public QObject {
  Q_OBJECT
 public:
  ShownHandles(const Document& document, const CameraController& camera);

  // Projected as the view is now.
  [[nodiscard]] const Handles& handles() const;
  void set_hovered(std::optional<GaussianId> id);
  // Without, selected Gaussians have an outline only.
  void show_centers(bool centers);
  void project();  // again, after a resize
  // See Handles; a frame of `camera`.
  void set_depth(const Camera& camera, const Frame& frame);
  // Whether that makes a difference.
  [[nodiscard]] bool use_depth() const;

  void draw(Overlay& overlay) const;
  void draw_outlines(Overlay& overlay) const;  // of all Gaussians

 Q_SIGNALS:
  void changed();

 private:
  void color_by_group();

  const Document& document_;
  const CameraController& camera_;
  mutable Handles handles_;
  mutable bool is_projected_ = false;
  std::optional<GaussianId> hovered_;
  bool centers_ = true;
};

}  // namespace brume
