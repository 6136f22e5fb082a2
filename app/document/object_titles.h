#pragma once

#include <QStringList>

#include "app/document/scene_part.h"

namespace brume {

// A light's or an emitter's title in lists: its name, or else "Spot 2", "Emitter 1".
QString light_title(const Light& light, std::size_t index);
QString emitter_title(const Emitter& emitter, std::size_t index);
QString primitive_title(Primitive::Shape shape);  // "Box"
// The names of surfaces, or else those of their shapes or mesh files; the same ones numbered:
// "bunny.obj", "bunny.obj (2)".
QStringList surface_names(const Surfaces& surfaces);
QString surface_name(const Surfaces& surfaces, std::size_t index);  // of one of them

}  // namespace brume
