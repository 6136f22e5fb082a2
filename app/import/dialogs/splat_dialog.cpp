#include "app/import/dialogs/splat_dialog.h"

#include <QCheckBox>
#include <QComboBox>
#include <QFormLayout>
#include <QLineEdit>
#include <QPushButton>

#include "app/document/paths.h"
#include "app/import/dialogs/folder_dialog.h"
#include "app/widgets/opacity_along_box.h"
#include "app/widgets/rows.h"

namespace brume {

SplatDialog::SplatDialog(const QString& what, const std::optional<FrameRun>& run, QWidget* parent)
    : QDialog(parent),
      along_(named(new OpacityAlongBox(this), "splat_opacity")),
      up_(named(new QComboBox(this), "splat_up")),
      albedos_(named(new QCheckBox(tr("become albedos"), this), "splat_albedos")) {
  setObjectName("import_splats");
  setWindowTitle(tr("Import %1").arg(what));
  setAttribute(Qt::WA_DeleteOnClose);
  auto* form = new QFormLayout(this);
  form->addRow(tr("As opaque as stored along"), along_);
  up_->addItems({tr("y"), tr("-y (turned by half about z)"), tr("z (turned about x)")});
  form->addRow(tr("Up axis"), up_);
  albedos_->setToolTip(tr("As they are from all sides; else the fog has the medium's albedo"));
  form->addRow(tr("Colours"), albedos_);
  if (run) folder_ = add_folder_row(form, run->files.file_of(run->first), *run);
  auto* import = named(new QPushButton(tr("Import")), "import");
  form->addRow(dialog_buttons(this, import, [this] {
    Q_EMIT requested({{along_->along(), albedos_->isChecked()}, SplatUp(up_->currentIndex())});
    accept();
  }));
}

std::filesystem::path SplatDialog::folder() const {
  return folder_ ? to_path(folder_->text()) : std::filesystem::path();
}

}  // namespace brume
