#pragma once

#include <QString>
#include <memory>
#include <vector>

#include "app/commands/gaussians/operation_numbers.h"
#include "core/scene/imported_scene.h"

namespace brume {

class Document;

// The surface of all nodes of a scene; its parts must not be empty.
Surface surface_of(const std::shared_ptr<const ImportedScene>& scene);

// Gaussians elsewhere and in another size, as opaque as before.
std::vector<Gaussian> placed(std::vector<Gaussian> gaussians, const ImportPlacement& placement);

// True if the camera of a scene is that of File > New, and the only one.
bool has_new_camera(const Scene& scene);

// Add the cameras and lights of a scene, each one undo step. Cameras that have the name of another
// one get a number; the first takes the place of that of a new scene. Lights take the place of
// those of a new scene. Beyond the limits of a scene nothing is added, and it says so.
void add_cameras(Document& document, const ImportedScene& scene, const QString& text);
void add_lights(Document& document, const ImportedScene& scene, bool replace, const QString& text);

// Reads the changed files of imported scenes anew: `again` takes the place of `scene` in all
// surfaces, one undo step. Returns what hinders it, such as nodes that are gone; empty: done.
QString replace_imported(Document& document, const ImportedScene& scene,
                         const std::shared_ptr<const ImportedScene>& again);

}  // namespace brume
