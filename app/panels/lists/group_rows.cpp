#include "app/panels/lists/group_rows.h"

#include <QMenu>
#include <QMimeData>
#include <QTimer>
#include <QTreeWidget>

#include "app/commands/gaussians/edit_groups.h"
#include "app/document/document.h"
#include "app/panels/lists/name_delegate.h"
#include "app/widgets/color_button.h"
#include "app/widgets/frame_text.h"
#include "app/widgets/icons.h"
#include "app/widgets/plain_text.h"

namespace brume {
namespace {

constexpr int id_role = Qt::UserRole + 9;

constexpr const char* group_mime = "application/x-brume-group";
constexpr const char* selection_mime = "application/x-brume-selection";

QString name_of(const Group& group) {
  return QString::fromStdString(group.name);
}

}  // namespace

GroupRows::GroupRows(Document& document, QTreeWidget& tree)
    : QObject(&tree), document_(document), tree_(tree) {
  on_change(document, Change::active_group, this, &GroupRows::update);
  const auto group_of = [](const QTreeWidgetItem* item) {
    return item->data(name_column, id_role).value<GroupId>();
  };
  connect(&tree, &QTreeWidget::itemCollapsed, this,
          [this, group_of](QTreeWidgetItem* item) { collapsed_.insert(group_of(item)); });
  connect(&tree, &QTreeWidget::itemExpanded, this,
          [this, group_of](QTreeWidgetItem* item) { collapsed_.erase(group_of(item)); });
}

void GroupRows::add_rows(QTreeWidgetItem& medium,
                         const std::function<QTreeWidgetItem*(GroupId group)>& make) {
  items_.clear();
  const Groups& groups = document_.scene().groups;
  const auto add = [&](QTreeWidgetItem& parent, GroupId group) {
    QTreeWidgetItem* item = make(group);
    item->setData(name_column, id_role, group);
    items_[group] = item;
    parent.addChild(item);
    return item;
  };
  for (const Group& group : groups) {
    if (group.parent != 0) continue;
    QTreeWidgetItem* item = add(medium, group.id);
    for (const Group& inner : groups) {
      if (inner.parent == group.id) add(*item, inner.id);
    }
  }
  if (!groups.empty()) add(medium, 0);
  for (const auto& [group, item] : items_) show_state(*item, group);
  update();
}

void GroupRows::expand() {
  for (const auto& [group, item] : items_) {
    if (item->childCount() > 0 && !collapsed_.contains(group)) item->setExpanded(true);
  }
}

void GroupRows::show_state(QTreeWidgetItem& item, GroupId id) {
  const Group* group = find_group(document_.scene().groups, id);
  if (!group) {
    item.setToolTip(name_column, tr("Gaussians that are in no group. Brushes paint there while no "
                                    "group is active; a click makes it so."));
    return;
  }
  item.setFlags(item.flags() | Qt::ItemIsEditable);
  item.setData(name_column, NameDelegate::name_role, name_of(*group));
  QIcon swatch(color_swatch(group->color));
  swatch.addPixmap(color_swatch(group->color), QIcon::Selected);  // else tinted
  item.setIcon(name_column, swatch);
  item.setToolTip(name_column,
                  plain_tool_tip(tr("%1: a click selects its Gaussians, and brushes paint into it. "
                                    "Double click or F2 renames it.")
                                     .arg(name_of(*group))));
  item.setIcon(eye_column, load_tree_icon(group->visible ? "eye" : "eye_closed"));
  item.setToolTip(eye_column, group->visible ? tr("Hide") : tr("Show"));
  item.setIcon(lock_column, load_tree_icon(group->locked ? "lock" : "lock_open"));
  item.setToolTip(lock_column, group->locked
                                   ? tr("Unlock")
                                   : tr("Lock: its Gaussians can be neither selected nor erased"));
  const bool is_visible = document_.group_effects().of(id).visible;
  item.setForeground(
      name_column,
      tree_.palette().brush(is_visible ? QPalette::Active : QPalette::Disabled, QPalette::Text));
}

void GroupRows::update() {
  if (items_.empty()) return;
  std::map<GroupId, std::size_t> counts;
  const Medium& medium = document_.medium();
  GroupId last = 0;
  std::size_t* count = &counts[0];
  for (std::size_t i = 0; i < medium.size(); ++i) {
    const GroupId group = medium.group(i);
    if (group != last) count = &counts[last = group];
    ++*count;
  }
  const Group* active = document_.active_group();
  const GroupId active_id = active ? active->id : 0;
  for (const auto& [group, item] : items_) {
    const Group* found = find_group(document_.scene().groups, group);
    std::size_t total = counts[group];
    for (int k = 0; k < item->childCount(); ++k) {
      total += counts[item->child(k)->data(name_column, id_role).value<GroupId>()];
    }
    const QString text =
        QString("%1 (%2)").arg(found ? name_of(*found) : tr("In no group"), count_text(total));
    if (item->text(name_column) != text) item->setText(name_column, text);
    QFont font = item->font(name_column);
    if (font.bold() == (group == active_id)) continue;
    font.setBold(group == active_id);
    item->setFont(name_column, font);
  }
}

void GroupRows::click(GroupId group, int column) {
  if (column == eye_column) {
    toggle_visible(group);
  } else if (column == lock_column) {
    toggle_locked(group);
  } else {
    select_group(document_, group);
  }
}

void GroupRows::rename(GroupId group) {
  const auto found = items_.find(group);
  if (group != 0 && found != items_.end()) tree_.editItem(found->second, name_column);
}

void GroupRows::toggle_visible(GroupId group) {
  const Group* found = find_group(document_.scene().groups, group);
  if (!found) return;
  change_group(document_, group, found->visible ? tr("Hide %1") : tr("Show %1"), no_merge,
               [](Group& g) { g.visible = !g.visible; });
}

void GroupRows::toggle_locked(GroupId group) {
  const Group* found = find_group(document_.scene().groups, group);
  if (!found) return;
  change_group(document_, group, found->locked ? tr("Unlock %1") : tr("Lock %1"), no_merge,
               [](Group& g) { g.locked = !g.locked; });
}

void GroupRows::fill_menu(QMenu& menu, GroupId group) {
  menu.addAction(tr("Select"), this, [this, group] { select_group(document_, group); });
  menu.addAction(tr("Move Selection Here"), this,
                 [this, group] { move_selection_to_group(document_, group); })
      ->setEnabled(!document_.selection().empty());
  const Group* found = find_group(document_.scene().groups, group);
  if (!found) return;
  menu.addSeparator();
  menu.addAction(tr("Rename"), this, [this, group] { rename(group); });
  menu.addAction(found->visible ? tr("Hide") : tr("Show"), this,
                 [this, group] { toggle_visible(group); });
  menu.addAction(found->locked ? tr("Unlock") : tr("Lock"), this,
                 [this, group] { toggle_locked(group); });
  menu.addSeparator();
  auto* nest = menu.addMenu(tr("Move into"));
  for (const Group& other : document_.scene().groups) {
    if (!can_nest(document_, group, other.id)) continue;
    QString name = name_of(other);
    nest->addAction(name.replace('&', "&&"), this,
                    [this, group, outer = other.id] { nest_group(document_, group, outer); });
  }
  nest->setEnabled(!nest->isEmpty());
  menu.addAction(tr("Move out of Group"), this, [this, group] { nest_group(document_, group, 0); })
      ->setEnabled(found->parent != 0);
  menu.addSeparator();
  menu.addAction(tr("Ungroup"), this, [this, group] { dissolve_group(document_, group); });
  menu.addAction(tr("Delete with Gaussians"), this,
                 [this, group] { delete_group(document_, group); });
}

QStringList GroupRows::mime_types() {
  return {group_mime, selection_mime};
}

QMimeData* GroupRows::mime_data(std::optional<GroupId> group) const {
  if (group == GroupId{0} || (!group && document_.selection().empty())) return nullptr;
  auto* data = new QMimeData;
  if (group) {
    data->setData(group_mime, QByteArray::number(*group));
  } else {
    data->setData(selection_mime, {});
  }
  return data;
}

// The edit comes later: it makes the rows anew, and the drop is not over yet.
bool GroupRows::drop(const QMimeData& data, GroupId onto) {
  if (data.hasFormat(selection_mime)) {
    QTimer::singleShot(0, this, [this, onto] { move_selection_to_group(document_, onto); });
    return true;
  }
  const auto group = static_cast<GroupId>(data.data(group_mime).toUInt());
  if (!can_nest(document_, group, onto)) return false;
  QTimer::singleShot(0, this, [this, group, onto] { nest_group(document_, group, onto); });
  return true;
}

}  // namespace brume
