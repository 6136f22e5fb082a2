#pragma once

#include <QPointF>
#include <functional>
#include <glm/vec3.hpp>
#include <optional>
#include <span>
#include <vector>

#include "app/viewport/overlay.h"
#include "core/medium/medium.h"
#include "core/scene/camera.h"
#include "render/frame.h"

namespace brume {

// The Gaussians as the user sees and grabs them: a dot at each centre, for selected ones also the
// outline at 1/e of the density. Works on film positions, so picking needs no OpenGL.
class Handles {
 public:
  // Where the centres are on the film. Of the sorted ids, hidden ones are nowhere, and locked ones
  // cannot be picked.
  void project(const Medium& medium, const CameraRays& rays, std::span<const GaussianId> hidden,
               std::span<const GaussianId> locked);

  // Which Gaussians lie behind a surface, judged by a frame and the camera it was made with: none
  // if it has no depths.
  void judge_depth(const Medium& medium, const CameraRays& rays, const Frame& frame);

  // Indices of Gaussians: the one under the mouse (the front one of those equally near), and all
  // whose centre is inside an area.
  [[nodiscard]] std::optional<std::size_t> pick(QPointF position) const;
  [[nodiscard]] std::vector<std::size_t> inside(const std::function<bool(QPointF)>& area) const;

  // Film position and depth of a Gaussian's centre; depth <= 0 is behind the eye.
  [[nodiscard]] const glm::dvec3& position(std::size_t index) const { return positions_[index]; }

  // `selected` are ids, sorted. Without centres, only the outlines of those.
  void draw(Overlay& overlay, const Medium& medium, const CameraRays& rays,
            std::span<const GaussianId> selected, std::optional<GaussianId> hovered,
            bool with_centers) const;

  // Of all that are not hidden, the nearest ones if there are many.
  void draw_outlines(Overlay& overlay, const Medium& medium, const CameraRays& rays) const;

 private:
  std::vector<glm::dvec3> positions_;
  std::vector<bool> behind_;  // a surface; empty while unknown
  std::vector<bool> locked_;
};

}  // namespace brume
