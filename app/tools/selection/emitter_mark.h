#pragma once

#include <QRgb>

namespace brume {

class CameraRays;
struct Emitter;
struct Overlay;

// Draws a ring where an emitter is; and, of an active one, the way that its particles go on average
// as dots. `time` [s]: while it has hardly emitted, outlines show what it will once it runs.
void add_emitter_mark(Overlay& overlay, const CameraRays& rays, const Emitter& emitter, QRgb color,
                      bool is_active, double time);

}  // namespace brume
