#pragma once

#include "app/frames/color_management.h"
#include "app/frames/error_map.h"
#include "app/frames/frame_service.h"
#include "app/frames/picture_cache.h"
#include "app/jobs/transfer_job.h"

namespace brume {

// The makers of frames, shared by all views.
struct FrameServices {
  // `make_context`: see FrameService.
  explicit FrameServices(FrameService::MakeContext make_context)
      : service(transfer_job.transfers(), std::move(make_context)) {}

  TransferJob transfer_job;
  FrameService service;
  ErrorMapper error_mapper;  // for the active view
  PictureCache cache;
  ColorManagement color;
};

}  // namespace brume
