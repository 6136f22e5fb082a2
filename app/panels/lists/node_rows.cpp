#include "app/panels/lists/node_rows.h"

#include <QTreeWidget>
#include <algorithm>

#include "app/document/document.h"
#include "core/scene/imported_scene.h"

namespace brume {
namespace {

constexpr int node_role = Qt::UserRole + 2;
constexpr int name_column = 0;

// True if a surface shows meshes of each node, or of nodes below it.
std::vector<bool> nodes_with_meshes(const Surface& surface) {
  const std::vector<ImportedNode>& nodes = surface.imported->nodes;
  std::vector<bool> result(nodes.size());
  for (const ImportedPart* part : chosen_parts(*surface.imported, surface.nodes)) {
    for (std::optional<std::size_t> k = part->node; k && !result[*k]; k = nodes[*k].parent) {
      result[*k] = true;
    }
  }
  return result;
}

}  // namespace

NodeRows::NodeRows(const Document& document, QTreeWidget& tree,
                   std::function<QTreeWidgetItem*(std::size_t surface)> make)
    : QObject(&tree), document_(document), tree_(tree), make_(std::move(make)) {
  const auto surface_of = [this](QTreeWidgetItem* item) {
    return std::ranges::any_of(surfaces_, [item](const auto& row) { return row.second == item; });
  };
  connect(&tree, &QTreeWidget::itemExpanded, this, [this, surface_of](QTreeWidgetItem* item) {
    if (!surface_of(item)) return;
    expanded_.insert(item->text(name_column));
    fill(*item);
  });
  connect(&tree, &QTreeWidget::itemCollapsed, this, [this, surface_of](QTreeWidgetItem* item) {
    if (surface_of(item)) expanded_.remove(item->text(name_column));
  });
}

std::size_t NodeRows::node_of(const QTreeWidgetItem& item) {
  return static_cast<std::size_t>(item.data(name_column, node_role).toULongLong());
}

void NodeRows::add_to(QTreeWidgetItem& item, std::size_t surface) {
  if (!document_.scene().surfaces[surface].imported) return;
  item.setChildIndicatorPolicy(QTreeWidgetItem::ShowIndicator);
  surfaces_[surface] = &item;
}

// Signals of the tree may be blocked meanwhile.
void NodeRows::expand() {
  for (const auto& [surface, item] : surfaces_) {
    if (!expanded_.contains(item->text(name_column))) continue;
    fill(*item);
    item->setExpanded(true);
  }
}

void NodeRows::fill(QTreeWidgetItem& item) {
  if (item.childCount() > 0) return;
  const auto row =
      std::ranges::find(surfaces_, &item, [](const auto& pair) { return pair.second; });
  const Surface& surface = document_.scene().surfaces[row->first];
  const ImportedScene& scene = *surface.imported;
  const std::vector<bool> has_meshes = nodes_with_meshes(surface);
  std::vector<QTreeWidgetItem*> items(scene.nodes.size());
  for (std::size_t k = 0; k < items.size(); ++k) {
    if (!has_meshes[k]) continue;
    const ImportedNode& node = scene.nodes[k];
    QTreeWidgetItem* parent = node.parent ? items[*node.parent] : nullptr;
    items[k] = make_(row->first);
    items[k]->setText(name_column, QString::fromStdString(node.name));
    items[k]->setData(name_column, node_role, qulonglong{k});
    (parent ? parent : &item)->addChild(items[k]);
  }
  for (QTreeWidgetItem* added : items) {
    if (added && added->childCount() > 0) added->setExpanded(true);
  }
}

}  // namespace brume
