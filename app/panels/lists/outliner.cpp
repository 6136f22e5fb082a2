#include "app/panels/lists/outliner.h"

#include <QContextMenuEvent>
#include <QHeaderView>
#include <QKeyEvent>
#include <QMenu>
#include <QTimer>
#include <QTreeWidgetItemIterator>
#include <algorithm>

#include "app/commands/gaussians/edit_groups.h"
#include "app/commands/gaussians/edit_medium.h"
#include "app/commands/gaussians/edit_splines.h"
#include "app/commands/objects/edit_environment.h"
#include "app/commands/objects/edit_objects.h"
#include "app/document/document.h"
#include "app/document/paths.h"
#include "app/panels/lists/camera_rows.h"
#include "app/panels/lists/group_rows.h"
#include "app/panels/lists/name_delegate.h"
#include "app/panels/lists/node_rows.h"
#include "app/panels/lists/spline_rows.h"
#include "app/widgets/frame_text.h"
#include "app/widgets/icons.h"
#include "app/widgets/keys.h"

namespace brume {
namespace {

constexpr int name_column = GroupRows::name_column;
constexpr int eye_column = GroupRows::eye_column;
constexpr int lock_column = GroupRows::lock_column;

constexpr int kind_role = Qt::UserRole;
constexpr int index_role = Qt::UserRole + 1;

QTreeWidgetItem* new_item(const QString& text, Outliner::Kind kind, std::size_t index = 0) {
  auto* item = new QTreeWidgetItem({text});
  item->setData(0, kind_role, static_cast<int>(kind));
  item->setData(0, index_role, qulonglong{index});
  const bool is_group = kind == Outliner::Kind::group;
  const bool is_dragged = is_group || kind == Outliner::Kind::gaussians;
  item->setFlags(item->flags()
                     .setFlag(Qt::ItemIsDragEnabled, is_dragged)
                     .setFlag(Qt::ItemIsDropEnabled, is_group));
  return item;
}

Outliner::Kind kind_of(ObjectRef::Kind kind) {
  switch (kind) {
    case ObjectRef::Kind::light:
      return Outliner::Kind::light;
    case ObjectRef::Kind::emitter:
      return Outliner::Kind::emitter;
    case ObjectRef::Kind::surface:
      return Outliner::Kind::surface;
  }
  return Outliner::Kind::medium;
}

// The heading Cameras is not a camera.
std::optional<std::size_t> index_of_kind(const QTreeWidgetItem* item, Outliner::Kind kind) {
  if (!item || !item->parent() || item->data(0, kind_role).toInt() != static_cast<int>(kind)) {
    return std::nullopt;
  }
  return item->data(0, index_role).toULongLong();
}

}  // namespace

Outliner::Outliner(Document& document, QWidget* parent)
    : QTreeWidget(parent),
      document_(document),
      groups_(new GroupRows(document, *this)),
      splines_(new SplineRows(document, *this)),
      nodes_(new NodeRows(document, *this,
                          [](std::size_t surface) { return new_item({}, Kind::node, surface); })),
      cameras_(new CameraRows(document, *this)) {
  setObjectName("outliner_tree");
  setHeaderHidden(true);
  setColumnCount(3);
  setItemDelegateForColumn(name_column, new NameDelegate(
                                            [this](const QModelIndex& row, const QString& name) {
                                              rename(itemFromIndex(row), name);
                                            },
                                            this));
  setEditTriggers(NoEditTriggers);
  setExpandsOnDoubleClick(false);
  setDragDropMode(DragDrop);
  header()->setStretchLastSection(false);
  header()->setSectionResizeMode(name_column, QHeaderView::Stretch);
  for (const int column : {eye_column, lock_column}) {
    header()->setSectionResizeMode(column, QHeaderView::ResizeToContents);
  }
  on_change(document_, Change::scene | Change::part, this, &Outliner::rebuild);
  on_change(document_, Change::splines, this, [this] {
    if (!splines_->is_current()) rebuild();
  });
  connect(splines_, &SplineRows::edit_asked, this, [this] { Q_EMIT asked_for(Kind::spline, 0); });
  connect(cameras_, &CameraRows::in_use_changed, this, &Outliner::show_camera_in_use);
  connect(cameras_, &CameraRows::look_through_asked, this, &Outliner::look_through_asked);
  on_change(document_, Change::medium, this, &Outliner::count_gaussians);
  on_change(document_, Change::object, this, &Outliner::follow_object);
  connect(this, &QTreeWidget::itemClicked, this, &Outliner::click);
  connect(this, &QTreeWidget::itemDoubleClicked, this, [this](QTreeWidgetItem* item, int column) {
    if (column == name_column) editItem(item, name_column);
  });
  rebuild();
}

void Outliner::rebuild() {
  is_stale_ = state() == EditingState;
  if (is_stale_) return;
  const Scene& scene = document_.scene();
  const std::optional<ObjectRef> current = object_of(currentItem());
  const std::optional<GroupId> current_group = group_of(currentItem());
  const std::optional<SplineId> current_spline = spline_of(currentItem());
  const std::optional<std::size_t> current_camera = camera_of(currentItem());
  const QString camera_name = current_camera ? currentItem()->text(name_column) : QString();
  const QSignalBlocker blocker(this);
  clear();
  nodes_->clear();
  auto* medium = new_item(tr("Medium"), Kind::medium);
  gaussians_ = new_item({}, Kind::gaussians);
  gaussians_->setToolTip(name_column, tr("Drag it onto a group to move the selected Gaussians "
                                         "there"));
  medium->addChild(gaussians_);
  groups_->add_rows(*medium, [](GroupId group) { return new_item({}, Kind::group, group); });
  splines_->add_rows(*medium, [](SplineId spline) { return new_item({}, Kind::spline, spline); });
  for (std::size_t k = 0; k < scene.emitters.size(); ++k) {
    medium->addChild(new_object_item({ObjectRef::Kind::emitter, k}));
  }
  for (const MediumSequence& sequence : scene.sequences) {
    medium->addChild(new_item(tr("Sequence %1, frames %2 to %3")
                                  .arg(to_qstring(sequence.file.filename()))
                                  .arg(sequence.first)
                                  .arg(sequence.last),
                              Kind::medium));
  }
  addTopLevelItem(medium);
  auto* lights = new_item(tr("Lights"), Kind::light);
  for (std::size_t k = 0; k < scene.lights.size(); ++k) {
    lights->addChild(new_object_item({ObjectRef::Kind::light, k}));
  }
  addTopLevelItem(lights);
  const QString environment = scene.environment ? environment_text(*scene.environment) : tr("none");
  addTopLevelItem(new_item(tr("Environment: %1").arg(environment), Kind::environment));
  auto* surfaces = new_item(tr("Surfaces"), Kind::surface);
  for (std::size_t k = 0; k < scene.surfaces.size(); ++k) {
    surfaces->addChild(new_object_item({ObjectRef::Kind::surface, k}));
    nodes_->add_to(*surfaces->child(static_cast<int>(k)), k);
  }
  addTopLevelItem(surfaces);
  auto* cameras = new_item(tr("Cameras"), Kind::camera);
  cameras_->add_rows(*cameras, [](std::size_t place) { return new_item({}, Kind::camera, place); });
  addTopLevelItem(cameras);
  // Not all items: those without children would draw their icon as if it were checked.
  for (int k = 0; k < topLevelItemCount(); ++k) topLevelItem(k)->setExpanded(true);
  groups_->expand();
  nodes_->expand();
  count_gaussians();
  if (current) set_current(*current);
  if (current_group) set_current(Kind::group, *current_group);
  if (current_spline) set_current(Kind::spline, *current_spline);
  if (current_camera) {
    set_current(
        Kind::camera,
        cameras_->place_of(camera_name).value_or(std::min(*current_camera, scene.cameras.size())));
  }
}

QTreeWidgetItem* Outliner::new_object_item(const ObjectRef& ref) {
  const Object object = *brume::object_of(document_.scene(), ref);
  auto* item = new_item(object_title(document_.scene(), ref), kind_of(ref.kind), ref.index);
  const bool shown = is_shown(object);
  const bool locked = is_locked(object);
  item->setFlags(item->flags() | Qt::ItemIsEditable);
  item->setData(name_column, NameDelegate::name_role, item->text(name_column));
  item->setForeground(
      name_column, palette().brush(shown ? QPalette::Active : QPalette::Disabled, QPalette::Text));
  item->setIcon(eye_column, load_tree_icon(shown ? "eye" : "eye_closed"));
  item->setToolTip(eye_column, shown ? tr("Hide") : tr("Show"));
  item->setIcon(lock_column, load_tree_icon(locked ? "lock" : "lock_open"));
  item->setToolTip(lock_column, locked ? tr("Unlock") : tr("Lock: the view leaves it alone"));
  return item;
}

std::optional<GroupId> Outliner::group_of(const QTreeWidgetItem* item) {
  const auto id = index_of_kind(item, Kind::group);
  return id ? std::optional(static_cast<GroupId>(*id)) : std::nullopt;
}

std::optional<SplineId> Outliner::spline_of(const QTreeWidgetItem* item) {
  const auto id = index_of_kind(item, Kind::spline);
  return id ? std::optional(static_cast<SplineId>(*id)) : std::nullopt;
}

std::optional<std::size_t> Outliner::camera_of(const QTreeWidgetItem* item) {
  return index_of_kind(item, Kind::camera);
}

std::optional<ObjectRef> Outliner::object_of(const QTreeWidgetItem* item) {
  if (!item || !item->parent()) return std::nullopt;
  const auto kind = static_cast<Kind>(item->data(0, kind_role).toInt());
  const auto index = static_cast<std::size_t>(item->data(0, index_role).toULongLong());
  if (kind == Kind::light) return ObjectRef{ObjectRef::Kind::light, index};
  if (kind == Kind::emitter) return ObjectRef{ObjectRef::Kind::emitter, index};
  if (kind == Kind::surface) return ObjectRef{ObjectRef::Kind::surface, index};
  if (kind == Kind::node) {
    return ObjectRef{ObjectRef::Kind::surface, index, NodeRows::node_of(*item)};
  }
  return std::nullopt;
}

void Outliner::set_current(const ObjectRef& ref) {
  QTreeWidgetItem* current = nullptr;
  for (QTreeWidgetItemIterator it(this); *it; ++it) {
    const std::optional<ObjectRef> other = object_of(*it);
    if (!other || other->kind != ref.kind || other->index > ref.index) continue;
    if (other == ref || !other->node) current = *it;
    if (other == ref) break;
  }
  setCurrentItem(current);
}

void Outliner::set_current(Kind kind, std::size_t index) {
  for (QTreeWidgetItemIterator it(this); *it; ++it) {
    if (index_of_kind(*it, kind) == index) setCurrentItem(*it);
  }
}

void Outliner::follow_object() {
  if (const auto& object = document_.object()) {
    set_current(*object);
  } else if (object_of(currentItem())) {
    setCurrentItem(nullptr);
  }
}

void Outliner::click(const QTreeWidgetItem* item, int column) {
  const std::optional<ObjectRef> ref = object_of(item);
  const std::optional<Object> object =
      ref ? brume::object_of(document_.scene(), *ref) : std::nullopt;
  // Rows of nodes have neither eye nor lock.
  const bool is_node = ref && ref->node;
  if (object && !is_node && column == eye_column)
    return show_object(document_, *ref, !is_shown(*object));
  if (object && !is_node && column == lock_column)
    return lock_object(document_, *ref, !is_locked(*object));
  if (object) document_.set_object(ref);
  if (const auto group = group_of(item)) {
    groups_->click(*group, column);
    if (column != name_column) return;
  }
  if (const auto spline = spline_of(item)) return splines_->edit(*spline);
  if (const auto camera = camera_of(item)) {
    if (column == eye_column) return cameras_->look_through(*camera);
    document_.set_object(std::nullopt);
  }
  Q_EMIT asked_for(static_cast<Kind>(item->data(0, kind_role).toInt()),
                   item->data(0, index_role).toULongLong());
}

void Outliner::show_camera_in_use() {
  set_current(Kind::camera, 0);
  Q_EMIT asked_for(Kind::camera, 0);
}

void Outliner::rename(const QTreeWidgetItem* item, const QString& name) {
  if (const auto group = group_of(item)) {
    rename_group(document_, *group, name);
  } else if (const auto spline = spline_of(item)) {
    rename_spline(document_, *spline, name);
  } else if (const auto camera = camera_of(item)) {
    cameras_->rename(*camera, name);
  } else if (const auto ref = object_of(item)) {
    if (!brume::object_of(document_.scene(), *ref)) return;
    if (name != object_title(document_.scene(), *ref)) rename_object(document_, *ref, name);
  }
}

// Later: Qt still needs the rows in which the editor was.
void Outliner::closeEditor(QWidget* editor, QAbstractItemDelegate::EndEditHint hint) {
  QTreeWidget::closeEditor(editor, hint);
  if (is_stale_) QTimer::singleShot(0, this, &Outliner::rebuild);
}

void Outliner::rename_current() {
  follow_object();
  const std::optional<ObjectRef> object = object_of(currentItem());
  if (object && !object->node) editItem(currentItem(), name_column);
}

// They are shortcuts of the window too, for Gaussians.
bool Outliner::event(QEvent* event) {
  if (event->type() == QEvent::ShortcutOverride) {
    const auto& key = static_cast<const QKeyEvent&>(*event);
    const bool is_object = object_of(currentItem()).has_value();
    const bool is_camera = camera_of(currentItem()).has_value();
    const bool is_group = group_of(currentItem()) || spline_of(currentItem());
    if (((is_object || is_camera || is_group) && is_key_of("edit.delete", key)) ||
        ((is_object || is_camera) && is_key_of("edit.duplicate", key)) ||
        ((is_camera || is_group) && is_key_of("edit.rename", key))) {
      event->accept();
      return true;
    }
  }
  return QTreeWidget::event(event);
}

void Outliner::keyPressEvent(QKeyEvent* event) {
  if (is_typed(*event)) return QTreeWidget::keyPressEvent(event);  // which searches names
  const bool deletes = is_key_of("edit.delete", *event);
  const bool duplicates = is_key_of("edit.duplicate", *event);
  const bool renames = is_key_of("edit.rename", *event);
  if (currentItem() == gaussians_ && deletes) return delete_selection(document_, tr("Delete"));
  if (const auto object = object_of(currentItem())) {
    if (deletes) return delete_object(document_, *object);
    if (duplicates) return duplicate_object(document_, *object);
  }
  const auto group = group_of(currentItem());
  const auto spline = spline_of(currentItem());
  const auto camera = camera_of(currentItem());
  if (group && deletes) return delete_group(document_, *group);
  if (spline && deletes) return delete_spline(document_, *spline);
  if (camera && deletes) return cameras_->remove(*camera);
  if (camera && duplicates) return cameras_->duplicate(*camera);
  if ((group || spline || camera) && renames) return editItem(currentItem(), name_column);
  QTreeWidget::keyPressEvent(event);
}

void Outliner::contextMenuEvent(QContextMenuEvent* event) {
  QTreeWidgetItem* item = itemAt(event->pos());
  const std::optional<ObjectRef> ref = object_of(item);
  const std::optional<Object> object =
      ref ? brume::object_of(document_.scene(), *ref) : std::nullopt;
  const std::optional<GroupId> group = group_of(item);
  const std::optional<SplineId> spline = spline_of(item);
  const std::optional<std::size_t> camera = camera_of(item);
  if (!object && !group && !spline && !camera) return;
  setCurrentItem(item);
  if (ref && ref->node) return document_.set_object(ref);
  auto* menu = new QMenu(this);
  menu->setAttribute(Qt::WA_DeleteOnClose);
  if (group) groups_->fill_menu(*menu, *group);
  if (spline) splines_->fill_menu(*menu, *spline);
  if (camera) cameras_->fill_menu(*menu, *camera);
  if (!object) return menu->popup(event->globalPos());
  document_.set_object(ref);
  const bool shown = is_shown(*object);
  const bool locked = is_locked(*object);
  menu->addAction(tr("Rename"), this, &Outliner::rename_current);
  menu->addAction(shown ? tr("Hide") : tr("Show"), this,
                  [this, ref, shown] { show_object(document_, *ref, !shown); });
  menu->addAction(locked ? tr("Unlock") : tr("Lock"), this,
                  [this, ref, locked] { lock_object(document_, *ref, !locked); });
  menu->addAction(tr("Duplicate"), this, [this, ref] { duplicate_object(document_, *ref); });
  menu->addAction(tr("Delete"), this, [this, ref] { delete_object(document_, *ref); });
  menu->popup(event->globalPos());
}

QStringList Outliner::mimeTypes() const {
  return GroupRows::mime_types();
}

QMimeData* Outliner::mimeData(const QList<QTreeWidgetItem*>& items) const {
  return groups_->mime_data(items.isEmpty() ? std::nullopt : group_of(items.front()));
}

bool Outliner::dropMimeData(QTreeWidgetItem* onto, int /*index*/, const QMimeData* dragged,
                            Qt::DropAction /*action*/) {
  const std::optional<GroupId> group = group_of(onto);
  return group && groups_->drop(*dragged, *group);
}

void Outliner::count_gaussians() {
  groups_->update();
  const std::size_t count = document_.medium().size();
  gaussians_->setText(
      0, tr("%1 Gaussian(s)", nullptr, static_cast<int>(count)).arg(count_text(count)));
}

void Outliner::changeEvent(QEvent* event) {
  QTreeWidget::changeEvent(event);
  if (event->type() == QEvent::PaletteChange) rebuild();
}

}  // namespace brume
