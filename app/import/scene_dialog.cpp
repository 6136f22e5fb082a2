#include "app/import/scene_dialog.h"

#include <QCheckBox>
#include <QDialogButtonBox>
#include <QPushButton>
#include <QVBoxLayout>

#include "app/document/paths.h"
#include "app/widgets/plain_text.h"

namespace brume {

SceneDialog::SceneDialog(const ImportedScene& scene, QWidget* parent) : QDialog(parent) {
  setObjectName("import_scene");
  setWindowTitle(tr("Import %1").arg(to_qstring(scene.files.front().filename())));
  setAttribute(Qt::WA_DeleteOnClose);
  auto* layout = new QVBoxLayout(this);
  layout->addWidget(
      new PlainLabel(tr("%n mesh(es) of %1 nodes", nullptr, static_cast<int>(scene.parts.size()))
                         .arg(scene.nodes.size())));
  QCheckBox* cameras = add_box("import_cameras", tr("Cameras (%1)"), scene.cameras.size());
  QCheckBox* lights = add_box("import_lights", tr("Lights (%1)"), scene.lights.size());
  lights->setToolTip(tr("Candela and lux become W/sr and W/u² at 683 lm/W"));
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel, this);
  buttons->addButton(tr("Import"), QDialogButtonBox::AcceptRole)->setObjectName("import");
  layout->addWidget(buttons);
  connect(buttons, &QDialogButtonBox::accepted, this, [this, cameras, lights] {
    Q_EMIT requested(cameras->isChecked(), lights->isChecked());
    accept();
  });
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
}

QCheckBox* SceneDialog::add_box(const QString& name, const QString& text, std::size_t count) {
  auto* box = new QCheckBox(text.arg(count), this);
  box->setObjectName(name);
  box->setEnabled(count > 0);
  box->setChecked(count > 0);
  layout()->addWidget(box);
  return box;
}

}  // namespace brume
