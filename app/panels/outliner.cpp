#include "app/panels/outliner.h"

#include <QEvent>

#include "app/commands/edit_lights.h"
#include "app/document/document.h"
#include "app/document/paths.h"
#include "app/widgets/frame_text.h"

namespace brume {
namespace {

constexpr int kind_role = Qt::UserRole;
constexpr int index_role = Qt::UserRole + 1;

QTreeWidgetItem* new_item(const QString& text, Outliner::Kind kind, std::size_t index = 0) {
  auto* item = new QTreeWidgetItem({text});
  item->setData(0, kind_role, static_cast<int>(kind));
  item->setData(0, index_role, qulonglong{index});
  return item;
}

}  // namespace

Outliner::Outliner(Document& document, QWidget* parent) : QTreeWidget(parent), document_(document) {
  setObjectName("outliner_tree");
  setHeaderHidden(true);
  connect(&document_, &Document::scene_replaced, this, &Outliner::rebuild);
  connect(&document_, &Document::part_changed, this, &Outliner::rebuild);
  connect(&document_, &Document::medium_changed, this, &Outliner::count_gaussians);
  connect(this, &QTreeWidget::itemClicked, this, [this](QTreeWidgetItem* item) {
    Q_EMIT asked_for(static_cast<Kind>(item->data(0, kind_role).toInt()),
                     item->data(0, index_role).toULongLong());
  });
  rebuild();
}

void Outliner::rebuild() {
  const Scene& scene = document_.scene();
  clear();
  auto* medium = new_item(tr("Medium"), Kind::medium);
  gaussians_ = new_item({}, Kind::gaussians);
  medium->addChild(gaussians_);
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
    item->setForeground(0,
                        palette().brush(scene.lights[k].on ? QPalette::Active : QPalette::Disabled,
                                        QPalette::Text));
    lights->addChild(item);
  }
  addTopLevelItem(lights);
  const QString environment =
      scene.environment ? to_qstring(scene.environment->file.filename()) : tr("none");
  addTopLevelItem(new_item(tr("Environment: %1").arg(environment), Kind::environment));
  auto* surfaces = new_item(tr("Surfaces"), Kind::surface);
  for (std::size_t k = 0; k < scene.surfaces.size(); ++k) {
    surfaces->addChild(
        new_item(to_qstring(scene.surfaces[k].mesh_file.filename()), Kind::surface, k));
  }
  addTopLevelItem(surfaces);
  expandAll();
  count_gaussians();
}

void Outliner::count_gaussians() {
  const std::size_t count = document_.medium().size();
  gaussians_->setText(0, count == 1 ? tr("1 Gaussian") : tr("%1 Gaussians").arg(count_text(count)));
}

void Outliner::changeEvent(QEvent* event) {
  QTreeWidget::changeEvent(event);
  if (event->type() == QEvent::PaletteChange) rebuild();
}

}  // namespace brume
