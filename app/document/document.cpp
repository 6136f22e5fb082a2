#include "app/document/document.h"

#include <algorithm>
#include <iterator>

#include "app/document/paths.h"
#include "core/io/scene_file.h"

namespace brume {
namespace {

// A light, so that the first Gaussian added can be seen.
Scene new_scene() {
  Scene scene;
  scene.lights.push_back(
      {.position = {2.0, 3.0, 3.0}, .intensity = glm::dvec3(20.0), .unknown = {}});
  return scene;
}

}  // namespace

Document::Document(QObject* parent) : QObject(parent), scene_(new_scene()) {}

std::shared_ptr<const Scene> Document::snapshot() const {
  if (!snapshot_) snapshot_ = std::make_shared<const Scene>(scene_);
  return snapshot_;
}

QString Document::name() const {
  return file_.empty() ? tr("Untitled") : to_qstring(file_.filename());
}

void Document::create() {
  open(new_scene(), {});
}

void Document::save(const std::filesystem::path& file) {
  const std::filesystem::path absolute = std::filesystem::absolute(file);
  save_scene(scene_, absolute);
  file_ = absolute;
  undo_stack_.setClean();
  Q_EMIT file_changed();
}

void Document::open(Scene scene, const std::filesystem::path& file) {
  undo_stack_.clear();
  scene_ = std::move(scene);
  snapshot_.reset();
  selection_.clear();
  file_ = file;
  Q_EMIT scene_replaced();
  Q_EMIT selection_changed();
  Q_EMIT file_changed();
}

bool Document::is_selected(GaussianId id) const {
  return std::binary_search(selection_.begin(), selection_.end(), id);
}

void Document::select(std::vector<GaussianId> ids) {
  std::sort(ids.begin(), ids.end());
  ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
  std::erase_if(ids, [this](GaussianId id) { return !medium().index_of(id); });
  if (ids == selection_) return;
  selection_ = std::move(ids);
  Q_EMIT selection_changed();
}

void Document::select_all() {
  select({medium().ids().begin(), medium().ids().end()});
}

void Document::invert_selection() {
  const auto all = medium().ids();
  std::vector<GaussianId> rest;
  std::set_difference(all.begin(), all.end(), selection_.begin(), selection_.end(),
                      std::back_inserter(rest));
  select(std::move(rest));
}

void Document::apply(const MediumEdit& edit, bool select_added) {
  edit.apply(scene_.medium);
  snapshot_.reset();
  // What was removed leaves the selection before anybody can ask for it.
  std::vector<GaussianId> selected;
  if (edit.added().empty() || !select_added) {
    selected = selection_;
    if (!edit.removed().empty()) {
      std::erase_if(selected, [this](GaussianId id) { return !medium().index_of(id); });
    }
  } else {
    for (const MediumEdit::Entry& entry : edit.added()) selected.push_back(entry.id);
  }
  const bool selection_differs = selected != selection_;
  selection_ = std::move(selected);
  Q_EMIT medium_changed(edit);
  if (selection_differs) Q_EMIT selection_changed();
}

void Document::set_camera(const Camera& camera) {
  scene_.camera = camera;
  snapshot_.reset();
  Q_EMIT camera_changed();
}

}  // namespace brume
