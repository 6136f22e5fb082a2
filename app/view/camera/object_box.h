#pragma once

#include <QRgb>
#include <array>
#include <glm/vec3.hpp>
#include <optional>

#include "app/document/object_ref.h"
#include "brume/scene.h"

namespace brume {

class CameraRays;
struct Overlay;

// The box of an object in a view, besides its picture. `ref` must be one of the scene's.

// Where a light is drawn: a directional light, which is nowhere, beside what the scene's camera
// looks at, as near as a camera that looks there sees it.
glm::dvec3 handle_position(const Light& light, const Scene& scene, const CameraRays& rays);
// Corners of the box around a surface's mesh, or around a node of its imported scene as that is at
// 0 s, along its own axes: corner k has the greater x, y, z where the bits 1, 2, 4 of k are set.
std::array<glm::dvec3, 8> box_corners(const Surface& surface,
                                      std::optional<std::size_t> node = std::nullopt);
// The middle of a surface's box; where a light (as a camera has it drawn) or an emitter is.
glm::dvec3 object_center(const Scene& scene, const ObjectRef& ref, const CameraRays& rays);
// Draws the box of a surface or its chosen node, a ring around others.
void add_object_outline(Overlay& overlay, const CameraRays& rays, const Scene& scene,
                        const ObjectRef& ref, QRgb color);

}  // namespace brume
