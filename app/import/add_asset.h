#pragma once

#include <QString>

#include "app/commands/operation_numbers.h"
#include "brume/mesh_arrays.h"
#include "brume/scene.h"

namespace brume {

class Document;

// What a scene file adds to a scene: its Gaussians as a group, its lights and its surfaces; or, if
// it has none of these, its camera.

bool is_camera_alone(const Scene& asset);

// Around all of that: surfaces and Gaussians, else lights, else what the camera looks at.
MeshBox box_of_asset(const Scene& asset);

// Adds it, moved and scaled, as one undo step; what it adds is selected. Beyond the limits of a
// scene nothing is added, and it says so. `name`: of the group and the camera.
void add_asset(Document& document, const Scene& asset, const QString& name,
               const ImportPlacement& placement, const QString& text);

}  // namespace brume
