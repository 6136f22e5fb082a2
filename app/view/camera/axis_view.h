#pragma once

#include <QString>

#include "app/view/camera/bounds.h"
#include "brume/camera.h"

namespace brume {

// Projection of a pane: free perspective camera, or along an axis.
enum class Projection { perspective, top, front, side };

QString projection_title(Projection projection);  // "Top"

// A camera along an axis that shows `half_height` [u] above and below `target`, from outside
// `scene`. Approximates an orthographic view by a distant camera with a narrow field of view, its
// rays parallel within one degree: what a pinhole sees of surfaces is rasterized.
Camera axis_camera(Projection projection, const glm::dvec3& target, double half_height,
                   const Sphere& scene);

}  // namespace brume
