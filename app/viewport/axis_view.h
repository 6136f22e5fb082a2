#pragma once

#include <QString>

#include "app/viewport/bounds.h"
#include "core/scene/camera.h"

namespace brume {

// What a pane of the view is: the free camera, or the scene seen along an axis.
enum class Projection { perspective, top, front, side };

QString projection_title(Projection projection);  // "Top"

// The camera of a view along an axis that shows `half_height` [u] above and below `target`, from
// outside of `scene`. It stands for an orthographic one: so far away, with so narrow a field of
// view, that its rays are parallel to within one degree. (The renderer's rays have one origin; a
// stage that keeps something per eye would need one per pixel.)
Camera axis_camera(Projection projection, const glm::dvec3& target, double half_height,
                   const Sphere& scene);

// Of such a camera [u].
double half_height(const Camera& camera);

}  // namespace brume
