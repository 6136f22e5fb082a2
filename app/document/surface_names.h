#pragma once

#include <QStringList>

#include "app/document/scene_part.h"

namespace brume {

QString primitive_title(Primitive::Shape shape);  // "Box"
// The names of surfaces, or else those of their shapes or mesh files; the same ones numbered:
// "bunny.obj", "bunny.obj (2)".
QStringList surface_names(const Surfaces& surfaces);

}  // namespace brume
