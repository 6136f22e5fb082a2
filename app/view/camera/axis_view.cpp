#include "app/view/camera/axis_view.h"

#include <QCoreApplication>
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

namespace brume {
namespace {

constexpr double half_field = 1.0;  // degrees, at most

struct Axis {
  glm::dvec3 towards_eye;
  glm::dvec3 up;
};

Axis axis_of(Projection projection) {
  switch (projection) {
    case Projection::top:
      return {{0, 1, 0}, {0, 0, -1}};
    case Projection::side:
      return {{1, 0, 0}, {0, 1, 0}};
    default:
      return {{0, 0, 1}, {0, 1, 0}};
  }
}

}  // namespace

QString projection_title(Projection projection) {
  const auto tr = [](const char* text) { return QCoreApplication::translate("Projection", text); };
  switch (projection) {
    case Projection::perspective:
      return tr("Perspective");
    case Projection::top:
      return tr("Top");
    case Projection::front:
      return tr("Front");
    case Projection::side:
      return tr("Side");
  }
  return {};
}

Camera axis_camera(Projection projection, const glm::dvec3& target, double half_height,
                   const Sphere& scene) {
  const Axis axis = axis_of(projection);
  // Zoomed far in, the field narrows rather than that the eye comes nearer than the scene.
  const double outside = 2.0 * scene.radius + glm::dot(scene.center - target, axis.towards_eye);
  const double distance =
      std::max(half_height / std::tan(glm::radians(half_field)), std::max(outside, 0.0));
  return {.eye = target + distance * axis.towards_eye,
          .target = target,
          .up = axis.up,
          .vertical_fov = 2.0 * glm::degrees(std::atan(half_height / distance))};
}

}  // namespace brume
