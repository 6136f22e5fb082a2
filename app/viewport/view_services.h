#pragma once

#include "app/jobs/transfer_job.h"
#include "app/viewport/error_map.h"
#include "app/viewport/frame_service.h"
#include "app/viewport/surface_picker.h"
#include "app/viewport/viewport_surface.h"

namespace brume {

// Services shared by all panes.
struct ViewServices {
  explicit ViewServices(const Document& document)
      : surfaces(document),
        frames(transfer_job.transfers(), [this] { return screens.create_context(); }) {}

  TransferJob transfer_job;
  SurfacePicker surfaces;
  ViewportSurfaces screens;
  FrameService frames;
  ErrorMapper error_mapper;  // for the active pane
};

}  // namespace brume
