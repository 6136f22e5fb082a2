#pragma once

#include <QByteArray>
#include <filesystem>

#include "app/export/frame_export.h"

namespace brume {

// A render in two files, for a later session: a scene file with the camera and the layers that were
// chosen, and a record of all else, a JSON text. Meshes and images are not copied.

struct RenderRecord {
  FrameExportRequest request;
  double place = 0.0;  // in the queue: those with smaller ones come first
};

QByteArray record_text(const FrameExportRequest& request, double place);
// The request has the file of its scene instead of the scene. Throws InputError.
RenderRecord read_record(const std::filesystem::path& record, const std::filesystem::path& scene);

Scene scene_to_keep(const FrameExportRequest& request);
// Reads the scene of a request that has only its file. Throws InputError.
void load_kept_scene(FrameExportRequest& request);

}  // namespace brume
