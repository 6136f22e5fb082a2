#include "app/import/splat_dialog.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QLineEdit>
#include <QPushButton>

#include "app/document/paths.h"
#include "app/import/folder_dialog.h"
#include "app/widgets/opacity_along_box.h"

namespace brume {

SplatDialog::SplatDialog(const QString& what, const std::optional<FrameRun>& run, QWidget* parent)
    : QDialog(parent),
      along_(new OpacityAlongBox(this)),
      up_(new QComboBox(this)),
      albedos_(new QCheckBox(tr("become albedos"), this)) {
  setObjectName("import_splats");
  setWindowTitle(tr("Import %1").arg(what));
  setAttribute(Qt::WA_DeleteOnClose);
  auto* form = new QFormLayout(this);
  along_->setObjectName("splat_opacity");
  form->addRow(tr("As opaque as stored along"), along_);
  up_->setObjectName("splat_up");
  up_->addItems({tr("y"), tr("-y (turned by half about z)"), tr("z (turned about x)")});
  form->addRow(tr("Up axis"), up_);
  albedos_->setObjectName("splat_albedos");
  albedos_->setToolTip(tr("As they are from all sides; else the fog has the medium's albedo"));
  form->addRow(tr("Colours"), albedos_);
  if (run) folder_ = add_folder_row(form, run->files.file_of(run->first), *run);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel, this);
  buttons->addButton(tr("Import"), QDialogButtonBox::AcceptRole)->setObjectName("import");
  form->addRow(buttons);
  connect(buttons, &QDialogButtonBox::accepted, this, [this] {
    Q_EMIT requested({{along_->along(), albedos_->isChecked()}, SplatUp(up_->currentIndex())});
    accept();
  });
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
}

std::filesystem::path SplatDialog::folder() const {
  return folder_ ? to_path(folder_->text()) : std::filesystem::path();
}

}  // namespace brume
