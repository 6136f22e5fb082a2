#include "app/window/scene_picture.h"

#include "app/document/document.h"
#include "app/files/recent_pictures.h"
#include "app/viewport/viewport.h"

namespace brume {

ScenePicture::ScenePicture(const Document& document, const Viewport& view, QObject* parent)
    : QObject(parent), document_(document), view_(view) {
  connect(&view.frames(), &FrameScheduler::frame_shown, this, &ScenePicture::save);
}

void ScenePicture::save() {
  const FrameScheduler& frames = view_.frames();
  const std::filesystem::path& file = document_.file();
  if (!frames.is_settled() || file.empty() || document_.is_modified()) return;
  if (frames.mode() == ViewMode::path_traced) return;  // noisy yet
  if (saved_ == std::pair(file, document_.revision())) return;
  saved_ = {file, document_.revision()};
  save_recent_picture(
      file, to_picture(frames.shown()->frame, {frames.exposure(), nullptr}, ViewMode::final));
}

}  // namespace brume
