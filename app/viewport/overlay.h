#pragma once

#include <QColor>
#include <QPainter>
#include <cstdint>
#include <vector>

#include "core/scene/camera.h"

namespace brume {

// What is drawn over the picture, in widget coordinates (logical pixels, y down). It is made in
// screen space, in double precision, so that it fits the picture wherever the scene lies, and is
// the same with OpenGL and without.
struct Overlay {
  struct Vertex {
    float x = 0.0F;
    float y = 0.0F;
    QRgb color = 0;  // with alpha, not premultiplied
  };

  std::vector<Vertex> dots;   // small squares
  std::vector<Vertex> marks;  // larger ones
  std::vector<Vertex> lines;  // two per segment

  static constexpr float dot_size = 3.0F;
  static constexpr float mark_size = 5.0F;
  static constexpr float line_width = 1.25F;

  void add_circle(double x, double y, double radius, QRgb color);
  // In the world; what is behind the eye is left out.
  void add_line(const CameraRays& rays, const glm::dvec3& from, const glm::dvec3& to, QRgb color);
  // The silhouette of a ball, exact in perspective; none if the eye is inside.
  void add_ball_outline(const CameraRays& rays, const glm::dvec3& center, double radius,
                        QRgb color);
};

// The world's axes as a small cross in the lower left corner.
void add_axes(Overlay& overlay, const CameraRays& rays, const Film& film);

void paint(const Overlay& overlay, QPainter& painter);

}  // namespace brume
