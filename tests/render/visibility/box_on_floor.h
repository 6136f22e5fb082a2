#pragma once

#include <glm/vec3.hpp>

#include "brume/mesh_arrays.h"
#include "brume/primitive.h"
#include "brume/scene.h"

namespace brume {

inline Surface primitive_surface(Primitive::Shape shape, const glm::dvec3& size,
                                 const glm::dvec3& translate) {
  Surface surface;
  surface.mesh = mesh_of({shape, size});
  surface.translate = translate;
  return surface;
}

// Two triangles at y = 0, `size` from side to side.
inline Surface two_triangles(double size) {
  const auto half = static_cast<float>(0.5 * size);
  MeshArrays mesh;
  mesh.points = {{-half, 0, -half}, {-half, 0, half}, {half, 0, half}, {half, 0, -half}};
  mesh.normals.assign(4, {0, 1, 0});
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  Surface surface;
  surface.mesh = to_mesh(mesh);
  return surface;
}

inline Light oblique_sun() {
  Light light;
  light.intensity = glm::dvec3(3.0);
  light.kind = light::Directional{{1, -1, 0}};
  return light;
}

inline Light light_beside_box(double box) {
  Light light;
  light.position = box * glm::dvec3(-2.0, 2.5, 0.3);
  light.intensity = box * box * glm::dvec3(20.0);
  return light;
}

// A box whose shadow falls on a floor; both are seen from close by.
inline Scene box_on_floor(const Surface& floor, const Light& light, double box = 1.0) {
  Scene scene;
  scene.film = {80, 60};
  scene.camera = {box * glm::dvec3(0.6, 2.2, 2.2), box * glm::dvec3(0.6, 0, 0), {0, 1, 0}, 40.0};
  scene.lights = {light};
  scene.surfaces = {
      floor, primitive_surface(Primitive::Shape::box, glm::dvec3(box), {0.0, 0.5 * box, 0.0})};
  return scene;
}

// A room without an opening on a floor, seen from within.
inline Scene closed_room(double floor) {
  Scene scene;
  scene.film = {80, 60};
  scene.camera = {{-1.7, 1.9, -1.7}, {1.5, 2, 1.5}, {0, 1, 0}, 80.0};
  scene.lights = {oblique_sun()};
  scene.lights[0].as<light::Directional>()->direction = {-1, -1, -0.3};
  scene.surfaces = {primitive_surface(Primitive::Shape::plane, {floor, 1, floor}, {}),
                    primitive_surface(Primitive::Shape::box, {4, 3, 4}, {0, 1.5, 0})};
  return scene;
}

}  // namespace brume
