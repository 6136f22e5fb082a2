#pragma once

#include <QObject>
#include <QUndoStack>
#include <filesystem>
#include <memory>
#include <optional>
#include <vector>

#include "app/document/scene_part.h"
#include "core/io/file_version.h"
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
  // The same without hidden Gaussians.
  [[nodiscard]] std::shared_ptr<const Scene> visible_snapshot() const;

  [[nodiscard]] QUndoStack& undo_stack() { return undo_stack_; }
  // Whether the scene differs from the file; what is selected does not count.
  [[nodiscard]] bool is_modified() const { return revision_ != saved_revision_; }

  // The file this scene was loaded from or saved to; empty for a new scene.
  [[nodiscard]] const std::filesystem::path& file() const { return file_; }
  [[nodiscard]] QString name() const;
  [[nodiscard]] QString folder() const;  // of the file, or the user's own

  // What that file held when it was loaded or saved; nothing if that is not known.
  [[nodiscard]] const std::optional<FileVersion>& file_version() const { return file_version_; }
  // What the file holds by now is known, and may be replaced.
  void set_file_version(const FileVersion& version) { file_version_ = version; }

  // Both forget history and selection. `file` is where the scene was loaded from.
  void create();
  void open(Scene scene, const std::filesystem::path& file,
            const std::optional<FileVersion>& version = {});
  // The same with work that the file does not have yet.
  void open_unsaved(Scene scene, const std::filesystem::path& file,
                    const std::optional<FileVersion>& version = {});
  // What a file gets: whatever moment is looked at, values with keys are those of the beginning.
  [[nodiscard]] Scene scene_to_save() const;
  // Keeps the history and marks its present state as saved, or throws InputError.
  void save(const std::filesystem::path& file);

  // The moment that is being looked at [s]; a state of the editor, 0 in the beginning. Values of
  // the scene that have keys are always those of this moment.
  [[nodiscard]] double time() const { return time_; }
  void set_time(double time);

  // Ordered by id; always Gaussians of this medium.
  [[nodiscard]] const std::vector<GaussianId>& selection() const { return selection_; }
  [[nodiscard]] bool is_selected(GaussianId id) const;
  // Of some ids in any order those that may be selected, sorted.
  [[nodiscard]] std::vector<GaussianId> selectable(std::vector<GaussianId> ids) const;

  // State of the editor, in no file and no history. What is hidden or locked cannot be selected and
  // is left alone by brushes; what is hidden is not seen either. Both ordered by id.
  [[nodiscard]] const std::vector<GaussianId>& hidden() const { return hidden_; }
  [[nodiscard]] const std::vector<GaussianId>& locked() const { return locked_; }
  [[nodiscard]] bool is_free(GaussianId id) const;  // neither
  void hide(std::vector<GaussianId> ids);           // and nothing else
  void lock(std::vector<GaussianId> ids);           // and nothing else

  // The light and the emitter that panels and handles are about; an index that may be of none.
  // State of the editor.
  [[nodiscard]] std::size_t active_light() const { return active_light_; }
  void set_active_light(std::size_t index);

  [[nodiscard]] std::size_t active_emitter() const { return active_emitter_; }
  void set_active_emitter(std::size_t index);

  // For commands only: changes without history.
  void apply(const MediumEdit& edit);
  void set_part(const ScenePart& part);
  void select(std::vector<GaussianId> ids);
  // Names the state of the scene; two states of one document with the same number are the same.
  [[nodiscard]] std::uint64_t revision() const { return revision_; }
  [[nodiscard]] std::uint64_t new_revision() { return ++last_revision_; }
  void set_revision(std::uint64_t revision);

 Q_SIGNALS:
  void scene_replaced();
  void medium_changed(const brume::MediumEdit& edit);
  void part_changed();  // of the scene, other than its Gaussians
  void selection_changed();
  void active_light_changed();
  void active_emitter_changed();
  void freedom_changed();  // what is hidden or locked
  void file_changed();
  void modified_changed();
  void refused(const QString& why);  // what was wanted is beyond a limit, and was not done

 private:
  void scene_changed();  // the copies of it are stale

  Scene scene_;
  mutable std::shared_ptr<const Scene> snapshot_;
  mutable std::shared_ptr<const Scene> visible_;
  QUndoStack undo_stack_;
  std::filesystem::path file_;
  std::optional<FileVersion> file_version_;
  std::vector<GaussianId> selection_;
  std::vector<GaussianId> hidden_;
  std::vector<GaussianId> locked_;
  double time_ = 0.0;
  std::size_t active_light_ = 0;
  std::size_t active_emitter_ = 0;
  std::uint64_t revision_ = 0;
  std::uint64_t last_revision_ = 0;
  std::uint64_t saved_revision_ = 0;
};

}  // namespace brume
