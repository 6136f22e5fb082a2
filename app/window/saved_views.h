#pragma once

#include <QObject>
#include <filesystem>
#include <optional>

#include "brume/camera.h"

namespace brume {

class Document;
class SceneFiles;
class Viewport;

// Opens a scene where its user last looked at it, if that was elsewhere than through the scene's
// camera, and as brightly. Kept in the user's settings by file, not in the scene: looking around is
// no edit, so it neither marks a scene as modified nor changes its file, and it is kept without
// saving.
class SavedViews : public QObject {
  Q_OBJECT
 public:
  SavedViews(Document& document, SceneFiles& files, Viewport& view, QObject* parent);
  ~SavedViews() override;

 private:
  void note_view();  // as it is now
  void restore_view();
  void store();

  Document& document_;
  Viewport& view_;
  std::filesystem::path file_;    // whose view is noted; empty: none
  std::optional<Camera> camera_;  // nullopt: the scene's
  double exposure_ = 0.0;         // [stops]
};

}  // namespace brume
