#pragma once

#include <QColor>
#include <QPainter>
#include <functional>
#include <vector>

#include "brume/gaussian.h"
#include "core/scene/camera_rays.h"

namespace brume {

// Graphics drawn over the picture, in widget coordinates (logical pixels, y down). Computed in
// screen space in double precision, so it matches the picture at any scale, with and without
// OpenGL.
struct Overlay {
  struct Vertex {
    float x = 0.0F;
    float y = 0.0F;
    QRgb color = 0;  // with alpha, not premultiplied
  };

  std::vector<Vertex> dots;       // small squares
  std::vector<Vertex> marks;      // larger ones
  std::vector<Vertex> lines;      // two per segment
  std::vector<Vertex> triangles;  // three of each, below all else

  // In the size of handles that the user chose.
  static float dot_size();
  static float mark_size();
  static float line_width();

  void add_circle(double x, double y, double radius, QRgb color);
  // A world-space line, clipped behind the eye.
  void add_line(const CameraRays& rays, const glm::dvec3& start, const glm::dvec3& end, QRgb color);
  // The exact perspective silhouette of a Gaussian at 1/e of its density; none if the eye is
  // inside. Dashed where a point of it is hidden.
  void add_outline(const CameraRays& rays, const Gaussian& gaussian, QRgb color,
                   const std::function<bool(const glm::dvec3&)>& is_hidden = {});
};

// Draws the world axes in the lower left corner.
void add_axes(Overlay& overlay, const CameraRays& rays, const Film& film);

void paint(const Overlay& overlay, QPainter& painter);

}  // namespace brume
