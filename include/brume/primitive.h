#pragma once

#include <glm/vec3.hpp>
#include <memory>

#include "brume/export.h"

namespace brume {

struct TriangleMesh;

// A shape that needs no mesh file, around the origin, with y up: a plane faces +y, a cylinder's
// axis is y.
struct Primitive {
  enum class Shape { plane, box, sphere, cylinder };
  Shape shape = Shape::box;
  glm::dvec3 size{1.0};  // from side to side, > 0 [u]; a plane's height is of no meaning

  bool operator==(const Primitive&) const = default;
};

// Its triangles, whose normals are smooth across round sides and not across edges. So fine that
// radiance transfer, which is kept at vertices, has some everywhere. A texture lies once on each
// flat side, upright or with its lower edge next to +z (below: -z), and once around a round one,
// from +z over +x.
BRUME_EXPORT std::shared_ptr<const TriangleMesh> mesh_of(const Primitive& primitive);

}  // namespace brume
