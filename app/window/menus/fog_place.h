#pragma once

#include "app/commands/add_fog.h"

namespace brume {

class Document;
class View;

// The place for fog that a view looks at: the surface in its middle if that faces up, else the
// ground below its target. The ground is what lies below the height of the eye, so that the ceiling
// of a room is none; where hardly any of it is met, it is the plane of the lowest surface, or y =
// 0.
FogPlace fog_place(const Document& document, View& view);

}  // namespace brume
