#include "app/document/document.h"

#include <QDir>
#include <algorithm>
#include <iterator>

#include "app/document/object_places.h"
#include "app/document/paths.h"
#include "core/io/disk/atomic_file.h"
#include "core/io/scene/scene_file.h"
#include "core/scene/animation/animation.h"
#include "core/scene/imported_scene.h"

namespace brume {

Scene new_scene() {
  Scene scene;
  // From a little above, so that the ground is seen.
  scene.camera.eye = {0.0, 1.4, 4.8};
  // So bright because thin fog scatters little of it to the eye.
  scene.lights.push_back({.position = {2.0, 3.0, 3.0}, .intensity = glm::dvec3(150.0)});
  return scene;
}

namespace {

using Ids = std::vector<GaussianId>;

// The union of two sorted sets.
Ids united(const Ids& a, const Ids& b) {
  Ids both;
  both.reserve(a.size() + b.size());
  std::ranges::set_union(a, b, std::back_inserter(both));
  return both;
}

void sort_unique(std::vector<GaussianId>& ids) {
  std::sort(ids.begin(), ids.end());
  ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
}

bool contains(const std::vector<GaussianId>& sorted, GaussianId id) {
  return std::binary_search(sorted.begin(), sorted.end(), id);
}

}  // namespace

Document::Document(QObject* parent) : QObject(parent), scene_(new_scene()) {}

std::shared_ptr<const Scene> Document::snapshot() const {
  if (!snapshot_) snapshot_ = std::make_shared<const Scene>(scene_);
  return snapshot_;
}

std::shared_ptr<const Scene> Document::visible_snapshot() const {
  if (hidden_.empty() && scene_.groups.empty() &&
      std::ranges::all_of(scene_.surfaces, is_shown_as_it_is)) {
    return snapshot();
  }
  if (!visible_) {
    auto scene = std::make_shared<Scene>(scene_);
    scene->medium = visible_medium();
    scene->groups.clear();
    scene->surfaces = shown_surfaces(scene_.surfaces, time_);
    visible_ = std::move(scene);
  }
  return visible_;
}

// Keeps its revision while neither the medium nor what is hidden changes.
const Medium& Document::visible_medium() const {
  const Medium& all = grouped_medium();
  const std::vector<GaussianId>& hidden = all_hidden();
  if (hidden.empty()) return all;
  if (visible_medium_of_ != all.revision() || hidden_in_visible_medium_ != hidden) {
    visible_medium_ = all;
    MediumEdit::remove(visible_medium_, hidden).apply(visible_medium_);
    hidden_in_visible_medium_ = hidden;
    visible_medium_of_ = all.revision();
  }
  return visible_medium_;
}

const GroupedMedium& Document::grouped() const {
  if (!grouped_is_current_) {
    grouped_.update(scene_);
    all_hidden_ = grouped_.hidden().empty() ? Ids() : united(hidden_, grouped_.hidden());
    all_locked_ = grouped_.locked().empty() ? Ids() : united(locked_, grouped_.locked());
    grouped_is_current_ = true;
  }
  return grouped_;
}

const std::vector<GaussianId>& Document::all_hidden() const {
  return grouped().hidden().empty() ? hidden_ : all_hidden_;
}

const std::vector<GaussianId>& Document::all_locked() const {
  return grouped().locked().empty() ? locked_ : all_locked_;
}

void Document::scene_changed() {
  grouped_is_current_ = false;
  snapshot_.reset();
  visible_.reset();
}

QString Document::name() const {
  return file_.empty() ? tr("Untitled") : to_qstring(file_.filename());
}

QString Document::folder() const {
  return file_.empty() ? QDir::homePath() : to_qstring(file_.parent_path());
}

void Document::create() {
  open(new_scene(), {});
}

SceneDocument Document::document_to_save() const {
  SceneDocument at_start(scene_, extras_);
  apply_keys(at_start.scene, 0.0);
  return at_start;
}

void Document::save(const std::filesystem::path& file) {
  const std::filesystem::path absolute = std::filesystem::absolute(file);
  const std::string text = document_to_json(document_to_save(), absolute.parent_path());
  write_atomically(absolute, text);
  file_ = absolute;
  file_version_ = FileVersion::of_content(text);
  is_file_missing_ = false;
  saved_revision_ = revision_;
  undo_stack_.setClean();
  announce(Change::file | Change::modified);
}

void Document::set_file_missing(bool missing) {
  if (missing == is_file_missing_) return;
  is_file_missing_ = missing;
  announce(Change::modified);
}

void Document::set_undo_limit(int steps) {
  undo_limit_ = steps;
  if (undo_stack_.count() == 0) undo_stack_.setUndoLimit(steps);
}

void Document::open_unsaved(SceneDocument document, const std::filesystem::path& file,
                            const std::optional<FileVersion>& version) {
  open(std::move(document), file, version);
  set_revision(new_revision());
}

void Document::open(SceneDocument document, const std::filesystem::path& file,
                    const std::optional<FileVersion>& version) {
  last_operation_.forget();
  undo_stack_.clear();
  set_undo_limit(undo_limit_);
  scene_ = std::move(document.scene);
  extras_ = std::move(document.extras);
  time_ = 0.0;
  apply_keys(scene_, time_);
  selection_.clear();
  hidden_.clear();
  locked_.clear();
  active_light_ = 0;
  active_emitter_ = 0;
  object_.reset();
  active_group_ = 0;
  active_spline_ = 0;
  scene_changed();
  file_ = file;
  file_version_ = version;
  is_file_missing_ = false;
  revision_ = saved_revision_ = new_revision();
  announce(Change::scene);
  // Views take the new scene before anything renders it.
  announce(Change::selection | Change::object | Change::hidden_or_locked | Change::file |
           Change::modified);
}

void Document::set_time(double time) {
  if (time == time_) return;
  time_ = time;
  if (!has_keys(scene_)) return;
  apply_keys(scene_, time_);
  scene_changed();
  Changes what = Change::part | Change::time;
  what.setFlag(Change::groups, !scene_.groups.empty());
  announce(what);
}

std::vector<Gaussian> Document::gaussians(std::span<const GaussianId> ids) const {
  std::vector<Gaussian> found;
  found.reserve(ids.size());
  for (const GaussianId id : ids) found.push_back(medium().gaussian(*medium().index_of(id)));
  return found;
}

Gaussian Document::effective_gaussian(std::size_t index) const {
  Gaussian gaussian = medium().gaussian(index);
  gaussian.optics.albedo = gaussian.optics.albedo.value_or(scene_.optics.albedo);
  return gaussian;
}

double Document::value(std::size_t index, GaussianAttribute field) const {
  const Medium& all = medium();
  switch (field) {
    case GaussianAttribute::center_x:
      return all.centers()[index].x;
    case GaussianAttribute::center_y:
      return all.centers()[index].y;
    case GaussianAttribute::center_z:
      return all.centers()[index].z;
    case GaussianAttribute::radius:
      return all.radii()[index];
    case GaussianAttribute::density:
      return all.densities()[index];
    case GaussianAttribute::elongation:
      return attribute_value({.shape = all.shape(index)}, field);
    default:
      return attribute_value(effective_gaussian(index), field);
  }
}

bool Document::is_selected(GaussianId id) const {
  return contains(selection_, id);
}

void Document::select(std::vector<GaussianId> ids) {
  ids = selectable(std::move(ids));
  if (!ids.empty()) set_object(std::nullopt);
  if (ids == selection_) return;
  selection_ = std::move(ids);
  announce(Change::selection);
}

std::vector<GaussianId> Document::selectable(std::vector<GaussianId> ids) const {
  sort_unique(ids);
  std::erase_if(ids, [this](GaussianId id) { return !medium().index_of(id) || !is_editable(id); });
  return ids;
}

bool Document::is_editable(GaussianId id) const {
  if (contains(hidden_, id) || contains(locked_, id)) return false;
  const GroupEffects& effects = grouped().effects();
  if (!effects.any_hidden() && !effects.any_locked()) return true;
  const auto index = medium().index_of(id);
  const GroupEffect& effect = effects.of(index ? medium().group(*index) : 0);
  return effect.visible && !effect.locked;
}

void Document::hide(std::vector<GaussianId> ids) {
  sort_unique(ids);
  hidden_ = std::move(ids);
  grouped_is_current_ = false;
  visible_.reset();
  select(selection_);
  announce(Change::hidden_or_locked);
}

void Document::lock(std::vector<GaussianId> ids) {
  sort_unique(ids);
  locked_ = std::move(ids);
  grouped_is_current_ = false;
  select(selection_);
  announce(Change::hidden_or_locked);
}

void Document::set_active_light(std::size_t index) {
  if (index == active_light_) return;
  active_light_ = index;
  announce(Change::active_light);
}

void Document::set_active_emitter(std::size_t index) {
  if (index == active_emitter_) return;
  active_emitter_ = index;
  announce(Change::active_emitter);
}

namespace {

std::size_t count_of(ObjectRef::Kind kind, const Scene& scene) {
  switch (kind) {
    case ObjectRef::Kind::light:
      return scene.lights.size();
    case ObjectRef::Kind::emitter:
      return scene.emitters.size();
    case ObjectRef::Kind::surface:
      return scene.surfaces.size();
  }
  return 0;
}

}  // namespace

void Document::set_object(const std::optional<ObjectRef>& object) {
  if (object == object_ || (object && object->index >= count_of(object->kind, scene_))) return;
  object_ = object;
  if (object && object->kind == ObjectRef::Kind::light) set_active_light(object->index);
  if (object && object->kind == ObjectRef::Kind::emitter) set_active_emitter(object->index);
  announce(Change::object);
}

const Group* Document::active_group() const {
  return find_group(scene_.groups, active_group_);
}

void Document::set_active_group(GroupId id) {
  if (id == active_group_) return;
  active_group_ = id;
  announce(Change::active_group);
}

const PaintedSpline* Document::active_spline() const {
  return find_spline(scene_.splines, active_spline_);
}

void Document::set_active_spline(SplineId id) {
  if (id == active_spline_) return;
  active_spline_ = id;
  announce(Change::active_spline);
}

void Document::apply(const MediumEdit& edit) {
  edit.apply(scene_.medium);
  scene_changed();
  // Remove deleted ids from these lists before any signal.
  const std::size_t selected = selection_.size();
  if (!edit.removed().empty()) {
    for (auto* ids : {&selection_, &hidden_, &locked_}) {
      std::erase_if(*ids, [this](GaussianId id) { return !medium().index_of(id); });
    }
  }
  // Gaussians may have come into a group that cannot be selected.
  if (!edit.changed().empty() && !scene_.groups.empty()) {
    std::erase_if(selection_, [this](GaussianId id) { return !is_editable(id); });
  }
  Changes what = Change::medium;
  what.setFlag(Change::selection, selected != selection_.size());
  Q_EMIT changed({what, &edit});
}

void Document::set_part(const ScenePart& part) {
  const std::vector<ObjectPlaces> places = places_after(scene_, part);
  set_scene_part(scene_, part);
  if (std::holds_alternative<Splines>(part)) {
    scene_changed();
    return announce(Change::splines);
  }
  apply_keys(scene_, time_);
  scene_changed();
  const auto last = [](const auto& list) { return std::max<std::size_t>(list.size(), 1) - 1; };
  active_light_ = std::min(active_light_, last(scene_.lights));
  active_emitter_ = std::min(active_emitter_, last(scene_.emitters));
  if (object_) {
    const std::size_t count = count_of(object_->kind, scene_);
    if (count == 0) {
      set_object(std::nullopt);
    } else if (object_->index >= count) {
      set_object(ObjectRef{object_->kind, count - 1});
    }
  }
  Changes what = Change::part;
  const bool are_groups = std::holds_alternative<Groups>(part);
  if (are_groups) what |= Change::groups;
  if (are_groups && active_group_ != 0 && !active_group()) {
    active_group_ = 0;
    what |= Change::active_group;
  }
  // Each part whose objects have other places is told of by itself.
  for (const ObjectPlaces& of_part : places) Q_EMIT changed({.what = what, .places = &of_part});
  if (places.empty()) announce(what);
  if (are_groups) select(selection_);
}

void Document::set_revision(std::uint64_t revision) {
  const bool was_modified = is_modified();
  revision_ = revision;
  if (is_modified() != was_modified) announce(Change::modified);
}

}  // namespace brume
