#include "app/import/dialogs/scene_dialog.h"

#include <QCheckBox>
#include <QPushButton>
#include <QVBoxLayout>

#include "app/document/paths.h"
#include "app/widgets/plain_text.h"
#include "app/widgets/rows.h"

namespace brume {

SceneDialog::SceneDialog(const ImportedScene& scene, QWidget* parent) : QDialog(parent) {
  setObjectName("import_scene");
  setWindowTitle(tr("Import %1").arg(to_qstring(scene.files.front().filename())));
  setAttribute(Qt::WA_DeleteOnClose);
  auto* layout = new QVBoxLayout(this);
  layout->addWidget(
      new PlainLabel(tr("%1 of %2")
                         .arg(tr("%n mesh(es)", nullptr, static_cast<int>(scene.parts.size())),
                              tr("%n node(s)", nullptr, static_cast<int>(scene.nodes.size())))));
  QCheckBox* cameras = add_box("import_cameras", tr("Cameras (%1)"), scene.cameras.size());
  QCheckBox* lights = add_box("import_lights", tr("Lights (%1)"), scene.lights.size());
  lights->setToolTip(tr("Candela and lux become W/sr and W/u² at 683 lm/W"));
  auto* import = named(new QPushButton(tr("Import")), "import");
  layout->addWidget(dialog_buttons(this, import, [this, cameras, lights] {
    Q_EMIT requested(cameras->isChecked(), lights->isChecked());
    accept();
  }));
}

QCheckBox* SceneDialog::add_box(const QString& name, const QString& text, std::size_t count) {
  auto* box = named(new QCheckBox(text.arg(count), this), name);
  box->setEnabled(count > 0);
  box->setChecked(count > 0);
  layout()->addWidget(box);
  return box;
}

}  // namespace brume
