#include "app/panels/lists/spline_rows.h"

#include <QMenu>
#include <QTreeWidget>

#include "app/commands/gaussians/edit_splines.h"
#include "app/document/document.h"
#include "app/panels/lists/name_delegate.h"
#include "app/widgets/icons.h"
#include "app/widgets/plain_text.h"

namespace brume {

SplineRows::SplineRows(Document& document, QTreeWidget& tree)
    : QObject(&tree), document_(document), tree_(tree) {
  on_change(document, Change::active_spline, this, &SplineRows::update);
}

std::vector<std::pair<SplineId, std::string>> SplineRows::names() const {
  std::vector<std::pair<SplineId, std::string>> result;
  for (const PaintedSpline& spline : document_.scene().splines) {
    result.emplace_back(spline.id, spline.name);
  }
  return result;
}

bool SplineRows::is_current() const {
  return shown_ == names();
}

void SplineRows::add_rows(QTreeWidgetItem& medium,
                          const std::function<QTreeWidgetItem*(SplineId spline)>& make) {
  items_.clear();
  shown_ = names();
  for (const auto& [id, name] : shown_) {
    const QString title = QString::fromStdString(name);
    QTreeWidgetItem* item = make(id);
    item->setText(0, title);
    item->setFlags(item->flags() | Qt::ItemIsEditable);
    item->setData(0, NameDelegate::name_role, title);
    item->setIcon(0, load_tree_icon("spline"));
    item->setToolTip(
        0,
        plain_tool_tip(tr("%1: a click shows its points, to bend the line and paint its fog again.")
                           .arg(title)));
    items_[id] = item;
    medium.addChild(item);
  }
  update();
}

void SplineRows::update() {
  const PaintedSpline* active = document_.active_spline();
  for (const auto& [id, item] : items_) {
    QFont font = item->font(0);
    font.setBold(active && active->id == id);
    item->setFont(0, font);
  }
}

void SplineRows::edit(SplineId spline) {
  document_.set_active_spline(spline);
  Q_EMIT edit_asked();
}

void SplineRows::rename(SplineId spline) {
  if (const auto found = items_.find(spline); found != items_.end()) {
    tree_.editItem(found->second, 0);
  }
}

void SplineRows::fill_menu(QMenu& menu, SplineId spline) {
  menu.addAction(tr("Edit Points"), this, [this, spline] { edit(spline); });
  menu.addAction(tr("Select Its Gaussians"), this,
                 [this, spline] { select_spline(document_, spline); });
  menu.addAction(tr("Rename"), this, [this, spline] { rename(spline); });
  menu.addSeparator();
  menu.addAction(tr("Delete with Fog"), this, [this, spline] { delete_spline(document_, spline); });
  menu.addAction(tr("Delete, Keep Fog"), this,
                 [this, spline] { release_spline(document_, spline); });
}

}  // namespace brume
