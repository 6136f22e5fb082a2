#pragma once

#include "app/frames/frame_services.h"
#include "app/view/surface_picker.h"
#include "app/viewport/viewport_surface.h"

namespace brume {

// Services shared by all panes.
struct ViewServices {
  explicit ViewServices(const Document& document)
      : surfaces(document), frames([this] { return screens.create_context(); }) {}

  SurfacePicker surfaces;
  ViewportSurfaces screens;
  FrameServices frames;
};

}  // namespace brume
