#pragma once

#include <QObject>
#include <QUndoStack>
#include <filesystem>
#include <memory>
#include <vector>

#include "core/medium/medium_edit.h"
#include "core/scene/scene.h"

namespace brume {

// The scene being edited, its history and its selection. Views read it and listen to its signals;
// they change it only by pushing commands (app/commands) onto the undo stack.
class Document : public QObject {
  Q_OBJECT
 public:
  explicit Document(QObject* parent = nullptr);

  [[nodiscard]] const Scene& scene() const { return scene_; }
  [[nodiscard]] const Medium& medium() const { return scene_.medium; }
  // The scene as it is now, for other threads; copied only when it changed since the last call.
  [[nodiscard]] std::shared_ptr<const Scene> snapshot() const;

  [[nodiscard]] QUndoStack& undo_stack() { return undo_stack_; }
  [[nodiscard]] bool is_modified() const { return !undo_stack_.isClean(); }

  // The file this scene was loaded from or saved to; empty for a new scene.
  [[nodiscard]] const std::filesystem::path& file() const { return file_; }
  [[nodiscard]] QString name() const;

  // Both forget history and selection. `file` is where the scene was loaded from.
  void create();
  void open(Scene scene, const std::filesystem::path& file);
  // Keeps the history and marks its present state as saved, or throws InputError.
  void save(const std::filesystem::path& file);

  // Ordered by id; always Gaussians of this medium. Selecting is not an edit.
  [[nodiscard]] const std::vector<GaussianId>& selection() const { return selection_; }
  [[nodiscard]] bool is_selected(GaussianId id) const;
  void select(std::vector<GaussianId> ids);
  void select_all();
  void invert_selection();

  // For commands only: changes without history.
  void apply(const MediumEdit& edit, bool select_added);
  void set_camera(const Camera& camera);

 Q_SIGNALS:
  void scene_replaced();
  void medium_changed(const brume::MediumEdit& edit);
  void camera_changed();
  void selection_changed();
  void file_changed();

 private:
  Scene scene_;
  mutable std::shared_ptr<const Scene> snapshot_;
  QUndoStack undo_stack_;
  std::filesystem::path file_;
  std::vector<GaussianId> selection_;
};

}  // namespace brume
