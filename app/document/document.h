#pragma once

#include <QObject>
#include <QUndoStack>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <type_traits>
#include <vector>

#include "app/document/document_change.h"
#include "app/document/gaussian_attribute.h"
#include "app/document/grouped_medium.h"
#include "app/document/last_operation.h"
#include "app/document/object_ref.h"
#include "app/document/scene_part.h"
#include "brume/edits.h"
#include "core/io/disk/file_version.h"
#include "core/io/scene/scene_document.h"

namespace brume {

// The scene of File > New: a view down on the ground, and a light, so that the first Gaussian added
// can be seen.
Scene new_scene();

// The edited scene, its history and selection. Views read it and listen to its signals; all changes
// are commands (app/commands) on the undo stack.
class Document : public QObject {
  Q_OBJECT
 public:
  explicit Document(QObject* parent = nullptr);

  [[nodiscard]] const Scene& scene() const { return scene_; }
  [[nodiscard]] const Medium& medium() const { return scene_.medium; }
  // The Gaussians of the medium as their groups make them, hidden ones too: the same ids and order.
  [[nodiscard]] const Medium& grouped_medium() const { return grouped().medium(scene_.medium); }
  // The Gaussians of the medium that have these ids, in their order.
  [[nodiscard]] std::vector<Gaussian> gaussians(std::span<const GaussianId> ids) const;
  // A Gaussian of the medium, with the medium's albedo if it has none of its own.
  [[nodiscard]] Gaussian effective_gaussian(std::size_t index) const;
  [[nodiscard]] double value(std::size_t index, GaussianAttribute field) const;  // of it
  // An immutable snapshot for other threads; copied only after changes.
  [[nodiscard]] std::shared_ptr<const Scene> snapshot() const;
  // A snapshot without hidden Gaussians, with the surfaces that frames show (shown_surfaces()); its
  // medium is what groups make of it, and it has no groups.
  [[nodiscard]] std::shared_ptr<const Scene> visible_snapshot() const;

  [[nodiscard]] QUndoStack& undo_stack() { return undo_stack_; }
  // Limits the steps that can be undone; 0: all. A history that has steps keeps its limit.
  void set_undo_limit(int steps);
  [[nodiscard]] LastOperation& last_operation() { return last_operation_; }
  [[nodiscard]] const LastOperation& last_operation() const { return last_operation_; }
  // Whether the scene differs from the file, or that is missing; the selection does not count.
  [[nodiscard]] bool is_modified() const {
    return revision_ != saved_revision_ || is_file_missing_;
  }

  // The file this scene was loaded from or saved to; empty for a new scene.
  [[nodiscard]] const std::filesystem::path& file() const { return file_; }
  [[nodiscard]] QString name() const;
  [[nodiscard]] QString folder() const;  // of the file, or the home folder

  // Version of the file when it was loaded or saved; nullopt if unknown.
  [[nodiscard]] const std::optional<FileVersion>& file_version() const { return file_version_; }
  // Accepts the file's current content as known, so it may be overwritten.
  void set_file_version(const FileVersion& version) { file_version_ = version; }
  // Whether another program has removed the file, which may be the last copy of the scene. It is
  // there again once it has its version, or the scene is saved.
  [[nodiscard]] bool is_file_missing() const { return is_file_missing_; }
  void set_file_missing(bool missing);

  // Both clear history and selection. `file`: where the scene was loaded from.
  void create();
  void open(SceneDocument document, const std::filesystem::path& file,
            const std::optional<FileVersion>& version = {});
  // Opens a scene as modified.
  void open_unsaved(SceneDocument document, const std::filesystem::path& file,
                    const std::optional<FileVersion>& version = {});
  // The document as files have it: keyframed values as of time 0.
  [[nodiscard]] SceneDocument document_to_save() const;
  // The content of the file besides the scene.
  [[nodiscard]] const SceneExtras& extras() const { return extras_; }
  // Saves, keeping the history. Throws InputError.
  void save(const std::filesystem::path& file);

  // Current time [s]; editor state, initially 0. Keyframed values of the scene always have their
  // values at this time.
  [[nodiscard]] double time() const { return time_; }
  void set_time(double time);

  // Ordered by id; always Gaussians of this medium.
  [[nodiscard]] const std::vector<GaussianId>& selection() const { return selection_; }
  [[nodiscard]] bool is_selected(GaussianId id) const;
  // The selectable ones of some ids, sorted.
  [[nodiscard]] std::vector<GaussianId> selectable(std::vector<GaussianId> ids) const;

  // Editor state, neither saved nor undoable. Hidden and locked Gaussians cannot be selected and
  // are skipped by brushes; hidden ones are invisible. Both ordered by id.
  [[nodiscard]] const std::vector<GaussianId>& hidden() const { return hidden_; }
  [[nodiscard]] const std::vector<GaussianId>& locked() const { return locked_; }
  // With those whose group is hidden or locked, which is part of the scene.
  [[nodiscard]] const std::vector<GaussianId>& all_hidden() const;
  [[nodiscard]] const std::vector<GaussianId>& all_locked() const;
  [[nodiscard]] bool is_editable(GaussianId id) const;  // neither hidden nor locked in any way
  void hide(std::vector<GaussianId> ids);               // and nothing else
  void lock(std::vector<GaussianId> ids);               // and nothing else

  // Active light and emitter of panels and handles; the index may be invalid. Editor state.
  [[nodiscard]] std::size_t active_light() const { return active_light_; }
  void set_active_light(std::size_t index);

  [[nodiscard]] std::size_t active_emitter() const { return active_emitter_; }
  void set_active_emitter(std::size_t index);

  // The light, emitter or surface that was selected last in the view or the outliner, unless
  // Gaussians were after it: what keys and handles act on. Always one of the scene. Editor state.
  [[nodiscard]] const std::optional<ObjectRef>& object() const { return object_; }
  void set_object(const std::optional<ObjectRef>& object);

  // The group that brushes paint into; nullptr: none. Editor state.
  [[nodiscard]] const Group* active_group() const;
  void set_active_group(GroupId id);
  [[nodiscard]] const GroupEffects& group_effects() const { return grouped().effects(); }

  // The spline that is being edited; nullptr: none. Editor state.
  [[nodiscard]] const PaintedSpline* active_spline() const;
  void set_active_spline(SplineId id);

  // For commands only: changes without undo.
  void apply(const MediumEdit& edit);
  void set_part(const ScenePart& part);
  void select(std::vector<GaussianId> ids);
  // Tells views that this changed, or that they should show again what is.
  void announce(Changes what) { Q_EMIT changed({.what = what}); }
  // Identifies a state of the scene; equal revisions of a document are equal states.
  [[nodiscard]] std::uint64_t revision() const { return revision_; }
  [[nodiscard]] std::uint64_t new_revision() { return ++last_revision_; }
  void set_revision(std::uint64_t revision);

 Q_SIGNALS:
  void changed(const brume::DocumentChange& change);
  void refused(const QString& why);  // an edit was rejected by a limit

 private:
  void scene_changed();  // invalidates the snapshots
  const Medium& visible_medium() const;
  const GroupedMedium& grouped() const;

  Scene scene_;
  SceneExtras extras_;
  mutable std::shared_ptr<const Scene> snapshot_;
  mutable std::shared_ptr<const Scene> visible_;
  mutable GroupedMedium grouped_;
  mutable bool grouped_is_current_ = false;
  // Caches of all_hidden() and all_locked(); empty while no group adds to them.
  mutable std::vector<GaussianId> all_hidden_;
  mutable std::vector<GaussianId> all_locked_;
  // Cache of visible_medium(), and what it was made from.
  mutable Medium visible_medium_;
  mutable Revision visible_medium_of_ = 0;
  mutable std::vector<GaussianId> hidden_in_visible_medium_;
  QUndoStack undo_stack_;
  int undo_limit_ = 0;
  LastOperation last_operation_{undo_stack_};
  std::filesystem::path file_;
  std::optional<FileVersion> file_version_;
  bool is_file_missing_ = false;
  std::vector<GaussianId> selection_;
  std::vector<GaussianId> hidden_;
  std::vector<GaussianId> locked_;
  double time_ = 0.0;
  std::size_t active_light_ = 0;
  std::size_t active_emitter_ = 0;
  std::optional<ObjectRef> object_;
  GroupId active_group_ = 0;
  SplineId active_spline_ = 0;
  std::uint64_t revision_ = 0;
  std::uint64_t last_revision_ = 0;
  std::uint64_t saved_revision_ = 0;
};

// Calls a slot with each edit of the medium.
template <class Receiver, class Slot>
void on_medium_edit(const Document& document, Receiver* receiver, Slot slot) {
  QObject::connect(&document, &Document::changed, receiver,
                   [receiver, slot](const DocumentChange& change) {
                     if (!change.edit) return;
                     if constexpr (std::is_member_function_pointer_v<Slot>) {
                       std::invoke(slot, receiver, *change.edit);
                     } else {
                       slot(*change.edit);
                     }
                   });
}

// Calls a slot of `receiver`, a member function or a function without arguments, once for each
// change of any of these.
template <class Receiver, class Slot>
void on_change(const Document& document, Changes any_of, Receiver* receiver, Slot slot) {
  QObject::connect(&document, &Document::changed, receiver,
                   [any_of, receiver, slot](const DocumentChange& change) {
                     if (!(change.what & any_of)) return;
                     if constexpr (std::is_member_function_pointer_v<Slot>) {
                       std::invoke(slot, receiver);
                     } else {
                       slot();
                     }
                   });
}

}  // namespace brume
