#pragma once

#include "app/transfer_job.h"
#include "app/viewport/error_map.h"
#include "app/viewport/frame_service.h"
#include "app/viewport/surface_picker.h"

namespace brume {

// What all panes of the view share.
struct ViewServices {
  ViewServices(const Document& document, QWidget* parent)
      : transfer_job(new TransferJob(parent)),
        surfaces(document),
        frames(transfer_job->transfers()) {}

  TransferJob* transfer_job;  // makes the radiance transfer of frames; shown in the status bar
  SurfacePicker surfaces;
  FrameService frames;
  ErrorMapper error_mapper;  // of the active pane
};

}  // namespace brume
