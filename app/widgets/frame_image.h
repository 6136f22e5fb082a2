#pragma once

#include <QImage>

#include "render/display/to_display.h"

namespace brume {

// A frame as it is displayed, of 8 bits per channel.
QImage frame_image(const Frame& frame, const DisplayLook& look);

}  // namespace brume
