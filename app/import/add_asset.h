#pragma once

#include <QString>

#include "app/commands/gaussians/operation_numbers.h"
#include "brume/mesh_arrays.h"
#include "brume/scene.h"

namespace brume {

class Document;

// A scene file adds its Gaussians to a scene, as a group, its lights and its surfaces; or, if it
// has none of these, its camera.

bool is_camera_alone(const Scene& asset);

// The box holds all of that: surfaces and Gaussians, else lights, else what the camera looks at.
MeshBox box_of_asset(const Scene& asset);

// Adds it, moved and scaled, as one undo step; what it adds is selected. Beyond the limits of a
// scene nothing is added, and it says so. The group and the camera are called `name`.
void add_asset(Document& document, const Scene& asset, const QString& name,
               const ImportPlacement& placement, const QString& text);

}  // namespace brume
