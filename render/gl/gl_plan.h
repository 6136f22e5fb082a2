#pragma once

#include <optional>

#include "render/gl/display_options.h"
#include "render/render_plan.h"

namespace brume::gl {

// Why a frame cannot be rendered on any device; nullopt: it can. Needs no device.
std::optional<Reason> refusal(const RenderPlan& plan);

// The plan moved to the device, with the stages that only a device has; on_cpu says what stays.
// `display`: where the picture goes; null: the frame is read back.
RenderPlan device_plan(RenderPlan plan, const DisplayOptions* display);

}  // namespace brume::gl
