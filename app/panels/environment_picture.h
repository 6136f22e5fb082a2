#pragma once

#include <QImage>

namespace brume {

struct Environment;

// All that an environment shows, as the scene turns it: -z in the middle, +x right of it, +y on
// top; at an exposure that suits it.
QImage environment_picture(const Environment& environment, int width, int height);

}  // namespace brume
