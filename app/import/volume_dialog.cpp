#include "app/import/volume_dialog.h"

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QLineEdit>
#include <QPushButton>
#include <QSpinBox>
#include <algorithm>
#include <exception>
#include <vector>

#include "app/document/paths.h"
#include "app/import/appearance_fields.h"
#include "app/import/folder_dialog.h"
#include "app/widgets/plain_text.h"
#include "app/widgets/rows.h"
#include "core/io/volume/volume_file.h"

namespace brume {

VolumeDialog::VolumeDialog(const std::filesystem::path& file, const std::optional<FrameRun>& run,
                           QWidget* parent)
    : QDialog(parent),
      grid_(named(new QComboBox(this), "volume_grid")),
      count_(named(new QSpinBox(this), "volume_count")),
      error_(named(new QDoubleSpinBox(this), "volume_error")),
      scale_(number_edit("volume_scale", 1.0, 1e-12, 1e12, this)),
      up_(named(new QComboBox(this), "volume_up")) {
  setWindowTitle(tr("Import %1").arg(to_qstring(file.filename())));
  setAttribute(Qt::WA_DeleteOnClose);
  auto* form = new QFormLayout(this);
  QString problem;
  std::vector<VolumeGridInfo> grids;
  try {
    grids = volume_grids(file);
    for (const VolumeGridInfo& grid : grids) {
      const QString name = QString::fromStdString(grid.name);
      if (grid_->findText(name, Qt::MatchExactly) < 0) grid_->addItem(name);  // their sum
    }
    grid_->setCurrentIndex(std::max(0, grid_->findText("density")));
  } catch (const std::exception& error) {
    problem = QString::fromUtf8(error.what());
  }
  form->addRow(tr("Grid"), grid_);
  count_->setRange(1, 1'000'000);
  count_->setValue(500);
  form->addRow(tr("Max Gaussians"), count_);
  error_->setRange(0.0, 100.0);
  error_->setSuffix(" %");
  error_->setSpecialValueText(tr("minimum"));
  if (!run) form->addRow(tr("Max density error"), error_);
  form->addRow(tr("Density scale, 1/u"), scale_);
  up_->addItems({tr("y"), tr("z (rotated to y)")});
  form->addRow(tr("Up axis"), up_);
  appearance_ = new AppearanceFields(form, grids);
  if (run) folder_ = add_folder_row(form, file, *run);
  auto* import = named(new QPushButton(tr("Import")), "import_volume");
  import->setEnabled(grid_->count() > 0);
  if (grid_->count() == 0) {
    auto* why = new PlainLabel(problem.isEmpty() ? tr("The file has no grids.") : problem, this);
    why->setWordWrap(true);
    form->addRow(why);
  }
  form->addRow(dialog_buttons(this, import, [this] { confirm(); }));
  const auto update = [this, import] {
    import->setEnabled(scale_->hasAcceptableInput() && appearance_->is_acceptable() &&
                       grid_->count() > 0);
  };
  connect(scale_, &QLineEdit::textChanged, this, update);
  connect(appearance_, &AppearanceFields::changed, this, update);
}

std::filesystem::path VolumeDialog::folder() const {
  return folder_ ? to_path(folder_->text()) : std::filesystem::path();
}

void VolumeDialog::confirm() {
  VolumeFit how;
  how.grid = grid_->currentText().toStdString();
  how.options.count = static_cast<std::size_t>(count_->value());
  how.options.max_error = 0.01 * error_->value();
  how.density_scale = scale_->text().toDouble();
  how.z_up = up_->currentIndex() == 1;
  how.appearance = appearance_->options();
  Q_EMIT requested(how);
  accept();
}

}  // namespace brume
