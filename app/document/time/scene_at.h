#pragma once

#include <QString>

#include "brume/scene.h"

namespace brume {

// An animation at a time [s]. Where a frame of a sequence cannot be read, without its sequences;
// `problem` says why.
Scene scene_at(const Scene& animation, double time, QString& problem);

}  // namespace brume
