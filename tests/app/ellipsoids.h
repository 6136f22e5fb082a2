#pragma once

#include <cmath>
#include <glm/geometric.hpp>

#include "app/document/document.h"
#include "app/document/euler_angles.h"
#include "app/widgets/number_field.h"
#include "tests/app/test_window.h"

// Ellipsoids and their numbers in the inspector, for tests.
namespace brume::ellipsoids {

inline Gaussian ellipsoid(const glm::dvec3& center, const glm::dvec3& radii,
                          const glm::dvec3& degrees) {
  Gaussian gaussian{.center = center, .density = 0.8};
  gaussian.set_radii(radii, from_euler_angles(degrees));
  return gaussian;
}

// The five balls, the second and the third of them ellipsoids, of the same rotation.
inline Scene scene_of_ellipsoids() {
  Scene scene = small_scene();
  Medium medium;
  for (std::size_t i = 0; i < scene.medium.size(); ++i) {
    Gaussian gaussian = scene.medium.gaussian(i);
    if (i == 1) gaussian = ellipsoid(gaussian.center, {0.3, 0.6, 0.2}, {10.0, 20.0, 30.0});
    if (i == 2) gaussian = ellipsoid(gaussian.center, {0.3, 0.4, 0.8}, {10.0, 20.0, 30.0});
    medium.append(gaussian);
  }
  scene.medium = medium;
  return scene;
}

inline Gaussian gaussian(const Document& document, std::size_t index) {
  return document.medium().gaussian(index);
}

inline bool is_near(const glm::dvec3& a, const glm::dvec3& b, double distance = 1e-12) {
  return glm::distance(a, b) < distance;
}

// The inspector's number of a name.
inline NumberField& number(const QWidget& window, const char* name) {
  return *window.findChild<NumberField*>(name);
}

inline void type_into(const QWidget& window, const char* name, const QString& text) {
  NumberField& field = number(window, name);
  field.setFocus();
  field.selectAll();
  QTest::keyClicks(&field, text);
  QTest::keyClick(&field, Qt::Key_Return);
}

// Whether a Gaussian has the rotation of these angles, to about a billionth.
inline bool is_turned(const Gaussian& gaussian, const glm::dvec3& degrees) {
  const double same = glm::dot(gaussian.shape.rotation, from_euler_angles(degrees));
  return std::abs(std::abs(same) - 1.0) < 1e-9;
}

}  // namespace brume::ellipsoids
