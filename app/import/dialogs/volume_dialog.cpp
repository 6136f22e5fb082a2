#include "app/import/dialogs/volume_dialog.h"

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QHeaderView>
#include <QLineEdit>
#include <QPushButton>
#include <QSpinBox>
#include <QThread>
#include <QTreeWidget>
#include <algorithm>
#include <cmath>
#include <exception>

#include "app/document/paths.h"
#include "app/document/text/number_text.h"
#include "app/import/dialogs/appearance_fields.h"
#include "app/import/dialogs/folder_dialog.h"
#include "app/widgets/frame_text.h"
#include "app/widgets/plain_text.h"
#include "app/widgets/rows.h"
#include "core/fit/volume_survey.h"
#include "core/io/volume/vdb_tree.h"

namespace brume {
namespace {

enum Column { name_column, voxels_column, size_column, values_column };

QString size_text(const VolumeGridInfo& grid) {
  if (grid.voxels == 0) return {};
  const glm::dvec3 size = grid.max_corner - grid.min_corner + grid.voxel_size;
  return QString("%1 × %2 × %3")
      .arg(number_text(size.x, 3), number_text(size.y, 3), number_text(size.z, 3));
}

QString range_text(const std::optional<ValueRange>& range) {
  if (!range) return "–";
  return VolumeDialog::tr("%1 to %2")
      .arg(number_text(range->min_value, 3), number_text(range->max_value, 3));
}

bool can_be_density(const VolumeGridInfo& grid) {
  const auto values = VdbValues::of_type(grid.type);
  return values && values->components == 1;
}

QTreeWidget* new_grid_list(QWidget* parent) {
  auto* list = named(new QTreeWidget(parent), "volume_grid",
                     VolumeDialog::tr("The grid whose values are the density"));
  list->setHeaderLabels({VolumeDialog::tr("Density from grid"), VolumeDialog::tr("Voxels"),
                         VolumeDialog::tr("Size, u"), VolumeDialog::tr("Values")});
  list->setRootIsDecorated(false);
  list->setUniformRowHeights(true);
  return list;
}

}  // namespace

VolumeDialog::VolumeDialog(const std::filesystem::path& file, const std::optional<FrameRun>& run,
                           QWidget* parent)
    : QDialog(parent),
      file_(file),
      frames_(run ? run->last - run->first + 1 : 1),
      grid_list_(new_grid_list(this)),
      cost_(named(new PlainLabel(this), "volume_cost")),
      count_(named(new QSpinBox(this), "volume_count")),
      shape_(named(new QComboBox(this), "volume_shape")),
      error_(named(new QDoubleSpinBox(this), "volume_error")),
      scale_(number_edit("volume_scale", 1.0, 1e-12, 1e12, this)),
      up_(named(new QComboBox(this), "volume_up", tr("First guessed from the size of the grid"))) {
  setWindowTitle(tr("Import %1").arg(to_qstring(file.filename())));
  setAttribute(Qt::WA_DeleteOnClose);
  auto* form = new QFormLayout(this);
  QString problem;
  try {
    grids_ = volume_grids(file);
  } catch (const std::exception& error) {
    problem = QString::fromUtf8(error.what());
  }
  form->addRow(grid_list_);
  count_->setRange(1, 1'000'000);
  count_->setValue(500);
  form->addRow(tr("Max Gaussians"), count_);
  shape_->addItems({tr("ellipsoids"), tr("balls")});
  shape_->setToolTip(tr("Half as many ellipsoids make the error of balls, in twice the time"));
  form->addRow(tr("Shape"), shape_);
  error_->setRange(0.0, 100.0);
  error_->setSuffix(" %");
  error_->setSpecialValueText(tr("minimum"));
  if (!run) form->addRow(tr("Max density error"), error_);
  form->addRow(tr("Density scale, 1/u"), scale_);
  up_->addItems({tr("y"), tr("z (rotated to y)")});
  form->addRow(tr("Up axis"), up_);
  appearance_ = new AppearanceFields(form, grids_);
  if (run) folder_ = add_folder_row(form, file, *run);
  form->addRow(tr("Takes about"), cost_);
  auto* import = named(new QPushButton(tr("Import")), "import_volume");
  if (problem.isEmpty()) {
    if (grids_.empty()) {
      problem = tr("The file has no grids.");
    } else if (std::ranges::none_of(grids_, can_be_density)) {
      problem = tr("None of its grids can be a density; allowed: grids of one number per voxel.");
    }
  }
  if (!problem.isEmpty()) {
    auto* why = named(new PlainLabel(problem, this), "volume_problem");
    why->setWordWrap(true);
    form->addRow(why);
  }
  form->addRow(dialog_buttons(this, import, [this] { confirm(); }));
  const auto update = [this, import] {
    import->setEnabled(scale_->hasAcceptableInput() && appearance_->is_acceptable() && grid());
  };
  connect(scale_, &QLineEdit::textChanged, this, update);
  connect(appearance_, &AppearanceFields::changed, this, update);
  connect(count_, &QSpinBox::valueChanged, this, &VolumeDialog::show_cost);
  connect(shape_, &QComboBox::currentIndexChanged, this, &VolumeDialog::show_cost);
  connect(up_, &QComboBox::activated, this, [this] { is_up_chosen_ = true; });
  connect(grid_list_, &QTreeWidget::currentItemChanged, this, &VolumeDialog::choose_grid);
  list_grids();
  update();
  read_ranges();
}

void VolumeDialog::list_grids() {
  QTreeWidgetItem* chosen = nullptr;
  for (const VolumeGridInfo& grid : grids_) {
    const QString name = QString::fromStdString(grid.name);
    auto* row =
        new QTreeWidgetItem(grid_list_, {name, count_text(grid.voxels), size_text(grid), "…"});
    row->setDisabled(!can_be_density(grid));
    if (row->isDisabled()) continue;
    if (!chosen || (name == "density" && chosen->text(name_column) != name)) chosen = row;
  }
  grid_list_->setCurrentItem(chosen);
  const QHeaderView& header = *grid_list_->header();
  grid_list_->setFixedHeight(header.sizeHint().height() +
                             grid_list_->fontMetrics().height() * 3 / 2 *
                                 std::clamp(static_cast<int>(grids_.size()) + 1, 3, 8));
  grid_list_->header()->setSectionResizeMode(QHeaderView::ResizeToContents);
  constexpr int min_width = 440;  // with the ranges, which come later
  grid_list_->setMinimumWidth(min_width);
}

// Reading values takes long where files are large.
void VolumeDialog::read_ranges() {
  if (grids_.empty()) return;
  reading_.start([this, file = file_](const Job& job) -> BackgroundJob::Apply {
    return [this, ranges = value_ranges(file, job.stop)] { show_ranges(ranges); };
  });
  connect(&reading_, &BackgroundJob::failed, this, [this] { show_ranges({}); });
}

// Grids without a range have a dash.
void VolumeDialog::show_ranges(std::vector<std::optional<ValueRange>> ranges) {
  ranges.resize(grids_.size());
  for (std::size_t k = 0; k < grids_.size(); ++k) {
    grid_list_->topLevelItem(static_cast<int>(k))->setText(values_column, range_text(ranges[k]));
  }
}

const VolumeGridInfo* VolumeDialog::grid() const {
  const int row = grid_list_->indexOfTopLevelItem(grid_list_->currentItem());
  return row < 0 ? nullptr : &grids_[static_cast<std::size_t>(row)];
}

void VolumeDialog::choose_grid() {
  const VolumeGridInfo* chosen = grid();
  if (chosen && !is_up_chosen_) up_->setCurrentIndex(is_probably_z_up(*chosen));
  show_cost();
}

void VolumeDialog::show_cost() {
  const VolumeGridInfo* chosen = grid();
  if (!chosen) return cost_->setText({});
  std::uint64_t blocks = 0;  // of all grids of the name, which are summed
  for (const VolumeGridInfo& info : grids_) {
    if (info.name == chosen->name) blocks += info.blocks;
  }
  const FitCost cost =
      estimate_fit_cost(blocks, fit().options, static_cast<unsigned>(QThread::idealThreadCount()));
  std::error_code error;
  const auto file_bytes = static_cast<double>(std::filesystem::file_size(file_, error));
  const auto megabytes =
      static_cast<int>(std::ceil(1e-6 * (cost.bytes + (error ? 0.0 : file_bytes))));
  cost_->setText(
      tr("%1 and %2 MB of memory").arg(estimated_time_text(frames_ * cost.seconds)).arg(megabytes));
}

VolumeFit VolumeDialog::fit() const {
  VolumeFit how;
  if (const VolumeGridInfo* chosen = grid()) how.grid = chosen->name;
  how.options.count = static_cast<std::size_t>(count_->value());
  how.options.max_error = 0.01 * error_->value();
  how.options.shape = shape_->currentIndex() == 1 ? FitShape::ball : FitShape::ellipsoid;
  how.density_scale = scale_->text().toDouble();
  how.z_up = up_->currentIndex() == 1;
  how.appearance = appearance_->options();
  return how;
}

std::filesystem::path VolumeDialog::folder() const {
  return folder_ ? to_path(folder_->text()) : std::filesystem::path();
}

void VolumeDialog::confirm() {
  Q_EMIT requested(fit());
  accept();
}

}  // namespace brume
