#include "app/export/medium_dialog.h"

#include <QCheckBox>
#include <QDialogButtonBox>
#include <QDoubleValidator>
#include <QFileDialog>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSpinBox>

#include "app/document/gaussian_attribute.h"
#include "app/document/number_text.h"
#include "app/document/paths.h"
#include "app/document/scene_at.h"
#include "app/document/timeline.h"
#include "app/files/file_dialogs.h"
#include "app/widgets/plain_text.h"
#include "core/io/file_bytes.h"
#include "core/volume/medium_grid.h"

namespace brume {

MediumDialog::MediumDialog(std::shared_ptr<const Scene> scene, const Timeline& timeline,
                           const QString& folder, QWidget* parent)
    : QDialog(parent),
      scene_(std::move(scene)),
      time_(timeline.time()),
      frames_per_second_(timeline.frames_per_second()),
      file_(new QLineEdit(last_folder(FileKind::medium, folder) + "/medium.vdb", this)),
      voxel_(new QLineEdit(this)),
      half_(new QCheckBox(tr("half precision"), this)),
      is_range_(new QCheckBox(tr("Frames"), this)),
      first_(new QSpinBox(this)),
      last_(new QSpinBox(this)),
      memory_(new PlainLabel(this)) {
  setWindowTitle(tr("Export medium"));
  setAttribute(Qt::WA_DeleteOnClose);
  file_->setObjectName("medium_file");
  file_->setMinimumWidth(360);
  auto* browse = new QPushButton(tr("Choose…"), this);
  auto* file_row = new QHBoxLayout;
  file_row->addWidget(file_, 1);
  file_row->addWidget(browse);
  auto* form = new QFormLayout(this);
  form->addRow(tr("File (.vdb, .ply, .csv)"), file_row);
  voxel_->setObjectName("medium_voxel");
  auto* domain = new QDoubleValidator(1e-12, 1e12, 12, voxel_);
  domain->setLocale(QLocale::c());
  voxel_->setValidator(domain);
  const double fitting = fitting_voxel_size(scene_now().medium);
  voxel_->setText(number_text(fitting > 0.0 ? fitting : 1.0));
  auto* voxel_row = new QHBoxLayout;
  voxel_row->addWidget(voxel_, 1);
  voxel_row->addWidget(half_);
  form->addRow(tr("Voxel size, u"), voxel_row);
  is_range_->setObjectName("medium_is_range");
  for (QSpinBox* box : {first_, last_}) {
    box->setRange(0, 1'000'000);
    box->setEnabled(false);
    connect(is_range_, &QCheckBox::toggled, box, &QWidget::setEnabled);
  }
  first_->setObjectName("medium_first");
  last_->setObjectName("medium_last");
  first_->setValue(timeline.first());
  last_->setValue(timeline.last());
  auto* range_row = new QHBoxLayout;
  range_row->addWidget(first_);
  range_row->addWidget(new PlainLabel(tr("to"), this));
  range_row->addWidget(last_);
  form->addRow(is_range_, range_row);
  memory_->setObjectName("medium_memory");
  form->addRow(tr("Memory"), memory_);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel, this);
  export_ = buttons->addButton(tr("Export"), QDialogButtonBox::AcceptRole);
  export_->setObjectName("export_medium");
  form->addRow(buttons);

  connect(browse, &QPushButton::clicked, this, &MediumDialog::browse);
  for (QLineEdit* line : {file_, voxel_}) {
    connect(line, &QLineEdit::textChanged, this, &MediumDialog::show_memory);
  }
  connect(buttons, &QDialogButtonBox::accepted, this, [this] {
    const MediumExport request = chosen();
    std::optional<std::pair<int, int>> frames;
    if (request.range) frames = {request.range->first, request.range->last};
    if (!may_replace(this, request.file, frames)) return;
    remember_folder(FileKind::medium, request.file);
    Q_EMIT requested(request);
    accept();
  });
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  show_memory();
}

// Where a frame cannot be read the export says so.
Scene MediumDialog::scene_now() const {
  QString ignored;
  return scene_at(*scene_, time_, ignored);
}

MediumExport MediumDialog::chosen() const {
  MediumExport request;
  request.scene = scene_;
  request.file = to_path(file_->text());
  request.voxel_size = voxel_->text().toDouble();
  request.half = half_->isChecked();
  request.time = time_;
  if (is_range_->isChecked()) {
    request.range = {first_->value(), last_->value(), frames_per_second_};
  }
  return request;
}

void MediumDialog::show_memory() {
  const std::string extension = lower_case_extension(to_path(file_->text()));
  const bool is_volume = extension == ".vdb";
  for (QWidget* widget : std::initializer_list<QWidget*>{voxel_, half_}) {
    widget->setEnabled(is_volume);
  }
  bool possible = is_volume || extension == ".ply" || extension == ".csv";
  QString text = possible ? tr("little") : tr("The file must end in .vdb, .ply or .csv.");
  if (is_volume && !voxel_->hasAcceptableInput()) {
    possible = false;
    text = tr("The voxel size must be greater than 0.");
  } else if (is_volume) {
    const auto bytes = grid_bytes(scene_now().medium, voxel_->text().toDouble());
    possible = bytes.has_value();
    text = bytes ? tr("%1 MB").arg((*bytes + 999'999) / 1'000'000)
                 : tr("More than 2 GB: use larger voxels.");
  }
  memory_->setText(text);
  export_->setEnabled(possible);
}

void MediumDialog::browse() {
  const QString name =
      QFileDialog::getSaveFileName(this, tr("Export medium"), file_->text(),
                                   tr("OpenVDB (*.vdb);;PLY (*.ply);;Table (*.csv);;All files (*)"),
                                   nullptr, QFileDialog::DontConfirmOverwrite);
  if (!name.isEmpty()) file_->setText(name);
}

}  // namespace brume
