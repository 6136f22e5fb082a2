#include "app/panels/lists/camera_rows.h"

#include <QMenu>
#include <QTreeWidget>
#include <algorithm>
#include <numeric>
#include <vector>

#include "app/commands/objects/edit_cameras.h"
#include "app/document/document.h"
#include "app/panels/lists/name_delegate.h"
#include "app/widgets/icons.h"
#include "app/widgets/plain_text.h"

namespace brume {

CameraRows::CameraRows(Document& document, QTreeWidget& tree)
    : QObject(&tree), document_(document), tree_(tree) {}

QString CameraRows::name_of(std::size_t place) const {
  const Scene& scene = document_.scene();
  if (place > scene.cameras.size()) return {};
  return QString::fromStdString(place == 0 ? scene.camera_name : scene.cameras[place - 1].name);
}

std::optional<std::size_t> CameraRows::place_of(const QString& name) const {
  const qsizetype place = camera_names(document_.scene()).indexOf(name);
  return place < 0 ? std::nullopt : std::optional(static_cast<std::size_t>(place));
}

void CameraRows::add_rows(QTreeWidgetItem& cameras,
                          const std::function<QTreeWidgetItem*(std::size_t place)>& make) {
  std::vector<std::size_t> places(document_.scene().cameras.size() + 1);
  std::iota(places.begin(), places.end(), 0);
  std::ranges::sort(places, [this](std::size_t a, std::size_t b) {
    return name_of(a).compare(name_of(b), Qt::CaseInsensitive) < 0;
  });
  for (const std::size_t place : places) {
    const QString name = name_of(place);
    QTreeWidgetItem* item = make(place);
    item->setText(name_column, name);
    item->setFlags(item->flags() | Qt::ItemIsEditable);
    item->setData(name_column, NameDelegate::name_role, name);
    item->setToolTip(name_column,
                     plain_tool_tip(place == 0 ? tr("%1 is in use: it is rendered").arg(name)
                                               : tr("%1: its icon uses it").arg(name)));
    QFont font = item->font(name_column);
    font.setBold(place == 0);
    item->setFont(name_column, font);
    item->setIcon(icon_column, load_tree_icon("camera"));
    item->setToolTip(icon_column, tr("Use and look through"));
    cameras.addChild(item);
  }
}

void CameraRows::use(std::size_t place) {
  document_.set_object(std::nullopt);
  use_camera(document_, name_of(place));
  Q_EMIT in_use_changed();
}

void CameraRows::look_through(std::size_t place) {
  use(place);
  Q_EMIT look_through_asked();
}

void CameraRows::rename(std::size_t place, const QString& name) {
  rename_camera(document_, name_of(place), name);
}

void CameraRows::duplicate(std::size_t place) {
  if (!duplicate_camera(document_, name_of(place))) return;
  document_.set_object(std::nullopt);
  Q_EMIT in_use_changed();
}

void CameraRows::remove(std::size_t place) {
  delete_camera(document_, name_of(place));
}

void CameraRows::fill_menu(QMenu& menu, std::size_t place) {
  menu.addAction(tr("Use"), this, [this, place] { use(place); })->setEnabled(place > 0);
  menu.addAction(tr("Look Through"), this, [this, place] { look_through(place); });
  menu.addAction(tr("Rename"), this, [this] { tree_.editItem(tree_.currentItem(), name_column); });
  menu.addAction(tr("Duplicate"), this, [this, place] { duplicate(place); });
  menu.addAction(tr("Delete"), this, [this, place] { remove(place); })
      ->setEnabled(!document_.scene().cameras.empty());
}

}  // namespace brume
