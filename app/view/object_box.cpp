#include "app/view/object_box.h"
#include "core/scene/camera_rays.h"

#include <glm/geometric.hpp>

#include "app/view/navigation.h"
#include "app/view/overlay.h"
#include "app/widgets/interface_settings.h"
#include "brume/mesh_arrays.h"
#include "core/scene/lights/point_lights.h"
#include "core/scene/placement.h"

namespace brume {
namespace {

constexpr double ring_radius = 13.0;  // pixels

}  // namespace

glm::dvec3 handle_position(const Light& light, const Scene& scene, const CameraRays& rays) {
  const auto* sun = light.as<light::Directional>();
  if (sun == nullptr) return light.position;
  const glm::dvec3& target = scene.camera.target;
  return target + 0.2 * viewing_distance(rays, target) * to_light(*sun);
}

std::array<glm::dvec3, 8> box_corners(const Surface& surface) {
  const MeshBox box = box_of(*surface.mesh);
  const Placement placement(surface);
  std::array<glm::dvec3, 8> corners;
  for (unsigned k = 0; k < corners.size(); ++k) {
    glm::dvec3 corner = box.low;
    for (const int axis : {0, 1, 2}) {
      if (k >> axis & 1U) corner[axis] = box.high[axis];
    }
    corners[k] = placement.point_to_world(corner);
  }
  return corners;
}

glm::dvec3 object_center(const Scene& scene, const ObjectRef& ref, const CameraRays& rays) {
  switch (ref.kind) {
    case ObjectRef::Kind::light:
      return handle_position(scene.lights.at(ref.index), scene, rays);
    case ObjectRef::Kind::emitter:
      return scene.emitters.at(ref.index).position;
    case ObjectRef::Kind::surface: {
      const auto corners = box_corners(scene.surfaces.at(ref.index));
      return 0.5 * (corners.front() + corners.back());
    }
  }
  return {};
}

void add_object_outline(Overlay& overlay, const CameraRays& rays, const Scene& scene,
                        const ObjectRef& ref, QRgb color) {
  if (ref.kind != ObjectRef::Kind::surface) {
    const glm::dvec3 projected = rays.project(object_center(scene, ref, rays));
    if (projected.z > 0.0)
      overlay.add_circle(projected.x, projected.y, ring_radius * handle_scale(), color);
    return;
  }
  const auto corners = box_corners(scene.surfaces.at(ref.index));
  for (unsigned k = 0; k < corners.size(); ++k) {
    for (const unsigned bit : {1U, 2U, 4U}) {
      if (!(k & bit)) overlay.add_line(rays, corners[k], corners[k | bit], color);
    }
  }
}

}  // namespace brume
