#include "app/panels/outliner.h"

#include <QContextMenuEvent>
#include <QHeaderView>
#include <QKeyEvent>
#include <QMenu>
#include <QTreeWidgetItemIterator>

#include "app/commands/edit_emitters.h"
#include "app/commands/edit_groups.h"
#include "app/commands/edit_lights.h"
#include "app/commands/edit_surfaces.h"
#include "app/document/document.h"
#include "app/document/paths.h"
#include "app/panels/group_rows.h"
#include "app/widgets/frame_text.h"
#include "app/widgets/icons.h"
#include "app/widgets/keys.h"

namespace brume {
namespace {

constexpr int name_column = 0;
constexpr int eye_column = 1;

constexpr int kind_role = Qt::UserRole;
constexpr int index_role = Qt::UserRole + 1;

QTreeWidgetItem* new_item(const QString& text, Outliner::Kind kind, std::size_t index = 0) {
  auto* item = new QTreeWidgetItem({text});
  item->setData(0, kind_role, static_cast<int>(kind));
  item->setData(0, index_role, qulonglong{index});
  return item;
}

bool is_key_of(const char* action, const QKeyEvent& event) {
  return keys_of(action).contains(QKeySequence(event.keyCombination()));
}

}  // namespace

Outliner::Outliner(Document& document, QWidget* parent)
    : QTreeWidget(parent), document_(document), groups_(new GroupRows(document, *this)) {
  setObjectName("outliner_tree");
  setHeaderHidden(true);
  setColumnCount(3);
  header()->setStretchLastSection(false);
  header()->setSectionResizeMode(name_column, QHeaderView::Stretch);
  header()->setSectionResizeMode(eye_column, QHeaderView::ResizeToContents);
  header()->setSectionResizeMode(GroupRows::lock_column, QHeaderView::ResizeToContents);
  connect(&document_, &Document::scene_replaced, this, &Outliner::rebuild);
  connect(&document_, &Document::part_changed, this, &Outliner::rebuild);
  connect(&document_, &Document::medium_changed, this, &Outliner::count_gaussians);
  connect(this, &QTreeWidget::itemClicked, this, [this](QTreeWidgetItem* item, int column) {
    const std::optional<Object> object = object_of(item);
    if (column == eye_column && object && object->kind == Kind::surface) {
      return toggle_visible(*object);
    }
    if (object && object->kind == Kind::group) {
      groups_->click(static_cast<GroupId>(object->index), column);
      if (column != name_column) return;
    }
    Q_EMIT asked_for(static_cast<Kind>(item->data(0, kind_role).toInt()),
                     item->data(0, index_role).toULongLong());
  });
  rebuild();
}

void Outliner::rebuild() {
  const Scene& scene = document_.scene();
  const std::optional<Object> current = object_of(currentItem());
  const auto text_brush = [this](bool enabled) {
    return palette().brush(enabled ? QPalette::Active : QPalette::Disabled, QPalette::Text);
  };
  clear();
  auto* medium = new_item(tr("Medium"), Kind::medium);
  gaussians_ = new_item({}, Kind::gaussians);
  medium->addChild(gaussians_);
  groups_->add_rows(*medium, [](GroupId group) { return new_item({}, Kind::group, group); });
  for (std::size_t k = 0; k < scene.emitters.size(); ++k) {
    medium->addChild(new_item(tr("Emitter %1").arg(k + 1), Kind::emitter, k));
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
    auto* item = new_item(light_title(scene.lights[k], k), Kind::light, k);
    item->setForeground(name_column, text_brush(scene.lights[k].on));
    lights->addChild(item);
  }
  addTopLevelItem(lights);
  const QString environment =
      scene.environment ? to_qstring(scene.environment->file.filename()) : tr("none");
  addTopLevelItem(new_item(tr("Environment: %1").arg(environment), Kind::environment));
  auto* surfaces = new_item(tr("Surfaces"), Kind::surface);
  const QStringList names = surface_names(scene.surfaces);
  for (std::size_t k = 0; k < scene.surfaces.size(); ++k) {
    const bool visible = scene.surfaces[k].visible;
    auto* item = new_item(names.at(static_cast<int>(k)), Kind::surface, k);
    item->setIcon(eye_column, load_icon(visible ? "eye" : "eye_closed"));
    item->setToolTip(eye_column, visible ? tr("Hide") : tr("Show"));
    item->setForeground(name_column, text_brush(visible));
    surfaces->addChild(item);
  }
  addTopLevelItem(surfaces);
  // Not all items: those without children would draw their icon as if it were checked.
  for (int k = 0; k < topLevelItemCount(); ++k) topLevelItem(k)->setExpanded(true);
  groups_->expand();
  count_gaussians();
  if (current) set_current(*current);
}

std::optional<Outliner::Object> Outliner::object_of(const QTreeWidgetItem* item) {
  if (!item || !item->parent()) return std::nullopt;
  const auto kind = static_cast<Kind>(item->data(0, kind_role).toInt());
  if (kind != Kind::group && kind != Kind::emitter && kind != Kind::light && kind != Kind::surface)
    return std::nullopt;
  return Object{kind, static_cast<std::size_t>(item->data(0, index_role).toULongLong())};
}

void Outliner::set_current(const Object& object) {
  QTreeWidgetItem* current = nullptr;
  for (QTreeWidgetItemIterator it(this); *it; ++it) {
    const std::optional<Object> other = object_of(*it);
    if (!other || other->kind != object.kind) continue;
    // Ids of groups are in no order.
    if (other->kind == Kind::group ? other->index == object.index : other->index <= object.index) {
      current = *it;
    }
  }
  setCurrentItem(current);
}

void Outliner::toggle_visible(const Object& object) {
  const Surfaces& surfaces = document_.scene().surfaces;
  if (object.index >= surfaces.size()) return;  // changed while the menu was open
  const bool visible = surfaces[object.index].visible;
  change_surface(document_, object.index, visible ? tr("Hide %1") : tr("Show %1"), no_merge,
                 [visible](Surface& surface) { surface.visible = !visible; });
}

void Outliner::delete_object(const Object& object) {
  switch (object.kind) {
    case Kind::group:
      return delete_group(document_, static_cast<GroupId>(object.index));
    case Kind::emitter:
      return delete_emitter(document_, object.index);
    case Kind::light:
      return delete_light(document_, object.index);
    default:
      return delete_surface(document_, object.index);
  }
}

void Outliner::duplicate_object(const Object& object) {
  if (object.kind != Kind::surface) return;
  duplicate_surface(document_, object.index);
  const Object copy{Kind::surface, document_.scene().surfaces.size() - 1};
  set_current(copy);
  Q_EMIT asked_for(copy.kind, copy.index);
}

// They are shortcuts of the window too, for Gaussians.
bool Outliner::event(QEvent* event) {
  if (event->type() == QEvent::ShortcutOverride && object_of(currentItem())) {
    const auto& key = static_cast<const QKeyEvent&>(*event);
    if (is_key_of("edit.delete", key) || is_key_of("edit.duplicate", key)) {
      event->accept();
      return true;
    }
  }
  return QTreeWidget::event(event);
}

void Outliner::keyPressEvent(QKeyEvent* event) {
  const std::optional<Object> object = object_of(currentItem());
  if (object && is_key_of("edit.delete", *event)) return delete_object(*object);
  if (object && is_key_of("edit.duplicate", *event)) return duplicate_object(*object);
  if (object && object->kind == Kind::group && event->key() == Qt::Key_F2) {
    return groups_->rename(static_cast<GroupId>(object->index));
  }
  QTreeWidget::keyPressEvent(event);
}

void Outliner::contextMenuEvent(QContextMenuEvent* event) {
  const std::optional<Object> object = object_of(itemAt(event->pos()));
  if (!object) return;
  auto* menu = new QMenu(this);
  menu->setAttribute(Qt::WA_DeleteOnClose);
  if (object->kind == Kind::group) {
    groups_->fill_menu(*menu, static_cast<GroupId>(object->index));
    menu->popup(event->globalPos());
    return;
  }
  if (object->kind == Kind::surface) {
    const bool visible = document_.scene().surfaces[object->index].visible;
    menu->addAction(visible ? tr("Hide") : tr("Show"), this,
                    [this, object] { toggle_visible(*object); });
    menu->addAction(tr("Duplicate"), this, [this, object] { duplicate_object(*object); });
  }
  menu->addAction(tr("Delete"), this, [this, object] { delete_object(*object); });
  menu->popup(event->globalPos());
}

void Outliner::count_gaussians() {
  groups_->update();
  const std::size_t count = document_.medium().size();
  gaussians_->setText(0, count == 1 ? tr("1 Gaussian") : tr("%1 Gaussians").arg(count_text(count)));
}

void Outliner::changeEvent(QEvent* event) {
  QTreeWidget::changeEvent(event);
  if (event->type() == QEvent::PaletteChange) rebuild();
}

}  // namespace brume
