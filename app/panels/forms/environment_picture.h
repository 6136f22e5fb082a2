#pragma once

#include <QImage>

namespace brume {

struct Environment;

// A thumbnail of an environment as rotated by the scene: -z in the center, +x right, +y up;
// automatic exposure.
QImage environment_picture(const Environment& environment, int width, int height);

}  // namespace brume
