#include "app/view/camera/object_box.h"
#include "core/scene/camera_rays.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "app/view/camera/navigation.h"
#include "app/view/drawing/overlay.h"
#include "app/widgets/interface_settings.h"
#include "brume/mesh_arrays.h"
#include "core/math/infinity.h"
#include "core/scene/imported_scene.h"
#include "core/scene/lights/point_lights.h"
#include "core/scene/placement.h"

namespace brume {
namespace {

constexpr double ring_radius = 13.0;  // pixels

std::array<glm::dvec3, 8> corners_of(const MeshBox& box) {
  std::array<glm::dvec3, 8> corners;
  for (unsigned k = 0; k < corners.size(); ++k) {
    for (const int axis : {0, 1, 2}) {
      corners[k][axis] = k >> axis & 1U ? box.high[axis] : box.low[axis];
    }
  }
  return corners;
}

// The box of a node of an imported scene, in its file's coordinates; of all if it is not there.
MeshBox box_of(const Surface& surface, std::size_t node) {
  const bool is_there = surface.imported && node < surface.imported->nodes.size();
  const auto parts =
      is_there ? parts_below(*surface.imported, node) : std::vector<const ImportedPart*>();
  if (parts.empty()) return box_of(*surface.mesh);
  MeshBox box{glm::dvec3(infinity), glm::dvec3(-infinity)};
  for (const ImportedPart* part : parts) {
    CopyPlacements placements = placements_at(*part, 0.0);
    if (placements.empty()) placements.emplace_back();
    for (const CopyPlacement& placement : placements) {
      for (const glm::dvec3& corner : corners_of(box_of(*part->mesh))) {
        const glm::dvec3 point = Placement(placement).point_to_world(corner);
        box.low = glm::min(box.low, point);
        box.high = glm::max(box.high, point);
      }
    }
  }
  return box;
}

}  // namespace

glm::dvec3 handle_position(const Light& light, const Scene& scene, const CameraRays& rays) {
  const auto* sun = light.as<light::Directional>();
  if (sun == nullptr) return light.position;
  const glm::dvec3& target = scene.camera.target;
  return target + 0.2 * viewing_distance(rays, target) * to_light(*sun);
}

std::array<glm::dvec3, 8> box_corners(const Surface& surface, std::optional<std::size_t> node) {
  const MeshBox box = node ? box_of(surface, *node) : box_of(*surface.mesh);
  std::array<glm::dvec3, 8> corners = corners_of(box);
  for (glm::dvec3& corner : corners) corner = Placement(surface).point_to_world(corner);
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
  const auto corners = box_corners(scene.surfaces.at(ref.index), ref.node);
  for (unsigned k = 0; k < corners.size(); ++k) {
    for (const unsigned bit : {1U, 2U, 4U}) {
      if (!(k & bit)) overlay.add_line(rays, corners[k], corners[k | bit], color);
    }
  }
}

}  // namespace brume
