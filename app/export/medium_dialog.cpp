#include "app/export/medium_dialog.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleValidator>
#include <QFileDialog>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLineEdit>
#include <QPushButton>
#include <QSignalBlocker>
#include <algorithm>
#include <array>

#include "app/document/document.h"
#include "app/document/gaussian_attribute.h"
#include "app/document/paths.h"
#include "app/document/text/number_text.h"
#include "app/document/text/words.h"
#include "app/document/time/scene_at.h"
#include "app/document/time/timeline.h"
#include "app/files/file_dialogs.h"
#include "app/widgets/color_button.h"
#include "app/widgets/opacity_along_box.h"
#include "app/widgets/plain_text.h"
#include "app/widgets/rows.h"
#include "app/widgets/whole_number_box.h"
#include "brume/limits.h"
#include "core/io/disk/file_bytes.h"
#include "core/io/scene/usd_file.h"
#include "core/number_domain.h"
#include "core/volume/medium_grid.h"

namespace brume {

namespace {

struct Format {
  MediumFormat format;
  const char* title;
  QStringList extensions;  // the first one is offered
};

const std::array<Format, 6>& formats() {
  static const std::array<Format, 6> all{
      {{MediumFormat::volume, QT_TR_NOOP("Volume"), {".vdb"}},
       {MediumFormat::gaussians, QT_TR_NOOP("Gaussians"), {".ply", ".csv"}},
       {MediumFormat::splats, QT_TR_NOOP("Gaussian splats"), {".ply", ".glb", ".gltf"}},
       {MediumFormat::lit_splats, QT_TR_NOOP("Lit splats"), {".ply"}},
       {MediumFormat::page, QT_TR_NOOP("Web page"), {".html"}},
       {MediumFormat::stage, QT_TR_NOOP("USD stage"), {".usda"}}}};
  return all;
}

const Format& chosen_of(const QComboBox& box) {
  return formats().at(static_cast<std::size_t>(box.currentIndex()));
}

bool has_extension(const Format& format, const QString& file) {
  const std::string extension = lower_case_extension(to_path(file));
  return format.extensions.contains(QString::fromStdString(extension));
}

bool has_volume(MediumFormat format) {
  return format == MediumFormat::volume || format == MediumFormat::stage;
}

bool is_lit(MediumFormat format) {
  return format == MediumFormat::lit_splats || format == MediumFormat::page;
}

constexpr NumberDomain exposure_domain{-100.0, 100.0, "a number of stops from -100 to 100"};

void set_domain(double low, double high, QLineEdit* line) {
  auto* validator = new QDoubleValidator(low, high, 12, line);
  validator->setLocale(QLocale::c());
  line->setValidator(validator);
}

}  // namespace

MediumDialog::MediumDialog(const Document& document, const Timeline& timeline, double exposure,
                           QWidget* parent)
    : QDialog(parent),
      scene_(document.snapshot()),
      selection_(document.selection()),
      time_(timeline.time()),
      frames_per_second_(timeline.frames_per_second()),
      form_(new QFormLayout(this)),
      what_(named(new QComboBox(this), "medium_what")),
      format_(named(new QComboBox(this), "medium_format")),
      file_(named(
          new QLineEdit(last_folder(FileKind::medium, document.folder()) + "/medium.vdb", this),
          "medium_file")),
      voxel_(named(new QLineEdit(this), "medium_voxel")),
      half_(new QCheckBox(tr("half precision"), this)),
      along_(named(new OpacityAlongBox(this), "medium_opacity")),
      up_(named(new QComboBox(this), "medium_up")),
      exposure_(named(new QLineEdit(this), "medium_exposure")),
      is_range_(named(new QCheckBox(tr("Frames"), this), "medium_is_range")),
      first_(named(new WholeNumberBox(tr("First frame"), 0, limits::frame, this), "medium_first")),
      last_(named(new WholeNumberBox(tr("Last frame"), 0, limits::frame, this), "medium_last")),
      memory_(named(new PlainLabel(this), "medium_memory")),
      export_(named(new QPushButton(tr("Export")), "export_medium")) {
  setWindowTitle(tr("Export Medium"));
  setAttribute(Qt::WA_DeleteOnClose);
  add_what();
  for (const Format& format : formats()) {
    format_->addItem(tr("%1 (%2)").arg(tr(format.title), format.extensions.join(", ")));
  }
  form_->addRow(tr("Format"), format_);
  file_->setMinimumWidth(360);
  auto* browse = new QPushButton(tr("Choose…"), this);
  form_->addRow(tr("File"), row_of({file_, browse}));
  add_options(form_, exposure);
  for (WholeNumberBox* box : {first_, last_}) {
    box->setEnabled(false);
    connect(is_range_, &QCheckBox::toggled, box, &QWidget::setEnabled);
  }
  first_->setValue(timeline.first());
  last_->setValue(timeline.last());
  auto* range_row = new QHBoxLayout;
  range_row->addWidget(first_);
  range_row->addWidget(new PlainLabel(tr("to"), this));
  range_row->addWidget(last_);
  form_->addRow(is_range_, range_row);
  form_->addRow(tr("Memory"), memory_);
  form_->addRow(dialog_buttons(this, export_, [this] {
    const MediumExport request = chosen();
    if (!may_replace_all(request)) return;
    remember_folder(FileKind::medium, request.file);
    Q_EMIT requested(request);
    accept();
  }));

  connect(browse, &QPushButton::clicked, this, &MediumDialog::browse);
  connect(format_, &QComboBox::currentIndexChanged, this, &MediumDialog::follow_format);
  connect(file_, &QLineEdit::textChanged, this, &MediumDialog::follow_file);
  for (QLineEdit* line : {voxel_, exposure_}) {
    connect(line, &QLineEdit::textChanged, this, &MediumDialog::show_memory);
  }
  connect(is_range_, &QCheckBox::toggled, this, &MediumDialog::show_memory);
  for (WholeNumberBox* box : {first_, last_}) {
    connect(box, &WholeNumberBox::changed, this, &MediumDialog::show_memory);
  }
  show_options();
}

void MediumDialog::add_what() {
  what_->addItem(tr("All Gaussians"));
  if (!selection_.empty()) {
    what_->addItem(tr("Selected %1").arg(gaussians_text(selection_.size())), qulonglong{0});
  }
  for (const Group& group : scene_->groups) {
    what_->addItem(QIcon(color_swatch(group.color)), QString::fromStdString(group.name),
                   qulonglong{group.id});
  }
  what_->setToolTip(tr("Lit splats are lit as they are among the others"));
  form_->addRow(tr("Gaussians"), what_);
  form_->setRowVisible(what_, what_->count() > 1);
  connect(what_, &QComboBox::currentIndexChanged, this, &MediumDialog::show_memory);
}

std::optional<std::vector<GaussianId>> MediumDialog::only() const {
  const QVariant group = what_->currentData();
  if (!group.isValid()) return std::nullopt;
  return group.toULongLong() == 0 ? selection_
                                  : members_of(*scene_, static_cast<GroupId>(group.toULongLong()));
}

void MediumDialog::add_options(QFormLayout* form, double exposure) {
  set_domain(1e-12, 1e12, voxel_);
  const double fitting = fitting_voxel_size(scene_now().medium);
  voxel_->setText(number_text(fitting > 0.0 ? fitting : 1.0));
  voxel_row_ = row_of({voxel_, half_});
  form->addRow(tr("Voxel size, u"), voxel_row_);
  form->addRow(tr("As opaque as fog along"), along_);
  up_->addItems({tr("y"), tr("-y (turned by half about z)")});
  up_->setToolTip(tr("Most viewers of .ply splats expect -y, as captures have it"));
  form->addRow(tr("Up axis"), up_);
  set_domain(exposure_domain.min_value, exposure_domain.max_value, exposure_);
  exposure_->setText(number_text(exposure));
  exposure_->setToolTip(tr("The light is written as it is displayed: in stops, as the view's"));
  form->addRow(tr("Exposure, stops"), exposure_);
}

void MediumDialog::follow_format() {
  const Format& chosen = chosen_of(*format_);
  if (!has_extension(chosen, file_->text())) {
    const QSignalBlocker blocker(file_);
    std::filesystem::path file = to_path(file_->text());
    file_->setText(to_qstring(file.replace_extension(chosen.extensions.front().toStdString())));
  }
  show_options();
}

void MediumDialog::follow_file() {
  const auto has = [this](const Format& format) { return has_extension(format, file_->text()); };
  const auto found = std::ranges::find_if(formats(), has);
  // A .ply may be any of three.
  if (!has(chosen_of(*format_)) && found != formats().end()) {
    const QSignalBlocker blocker(format_);
    format_->setCurrentIndex(static_cast<int>(found - formats().begin()));
  }
  show_options();
}

void MediumDialog::show_options() {
  const MediumFormat chosen = chosen_of(*format_).format;
  const bool are_files = chosen == MediumFormat::splats || chosen == MediumFormat::lit_splats;
  const bool is_ply = lower_case_extension(to_path(file_->text())) == ".ply";
  form_->setRowVisible(voxel_row_, has_volume(chosen));
  form_->setRowVisible(along_,
                       are_files || chosen == MediumFormat::page || chosen == MediumFormat::stage);
  form_->setRowVisible(up_, are_files && is_ply);
  form_->setRowVisible(exposure_, is_lit(chosen));
  show_memory();
}

// Where a frame cannot be read the export says so.
Scene MediumDialog::scene_now() const {
  QString ignored;
  Scene scene = scene_at(*scene_, time_, ignored);
  if (const auto ids = only()) keep_only(scene.medium, *ids);
  return scene;
}

MediumExport MediumDialog::chosen() const {
  MediumExport request;
  request.scene = scene_;
  request.only = only();
  request.file = to_path(file_->text());
  request.format = chosen_of(*format_).format;
  request.along = along_->along();
  request.y_down = up_->isVisibleTo(this) && up_->currentIndex() == 1;
  request.exposure = exposure_->text().toDouble();
  request.voxel_size = voxel_->text().toDouble();
  request.half = half_->isChecked();
  request.time = time_;
  if (is_range_->isChecked()) {
    request.range = {first_->value(), last_->value(), frames_per_second_};
  }
  return request;
}

QString MediumDialog::range_problem() const {
  if (!is_range_->isChecked()) return {};
  return first_->problem().isEmpty() ? last_->problem() : first_->problem();
}

void MediumDialog::show_memory() {
  const Format& chosen = chosen_of(*format_);
  bool possible = has_extension(chosen, file_->text());
  QString text = tr("little");
  if (!possible) {
    text = tr("The file must end in %1.").arg(chosen.extensions.join(tr(" or ")));
  } else if (const QString problem = range_problem(); !problem.isEmpty()) {
    possible = false;
    text = problem;
  } else if (is_lit(chosen.format) && !exposure_->hasAcceptableInput()) {
    possible = false;
    text = tr("The exposure must be %1.").arg(allowed_text(exposure_domain));
  } else if (has_volume(chosen.format) && !voxel_->hasAcceptableInput()) {
    possible = false;
    text = tr("The voxel size must be greater than 0.");
  } else if (has_volume(chosen.format)) {
    const auto bytes = grid_bytes(scene_now().medium, voxel_->text().toDouble());
    possible = bytes.has_value();
    text = bytes ? tr("%1 MB").arg((*bytes + 999'999) / 1'000'000)
                 : tr("More than 2 GB: use larger voxels.");
  }
  memory_->setText(text);
  export_->setEnabled(possible);
}

bool MediumDialog::may_replace_all(const MediumExport& request) {
  std::optional<std::pair<int, int>> frames;
  if (request.range) frames = {request.range->first, request.range->last};
  if (request.format != MediumFormat::stage) return may_replace(this, request.file, frames);
  return may_replace(this, request.file, std::nullopt) &&
         may_replace(this, volume_of_stage(request.file), frames);
}

void MediumDialog::browse() {
  QStringList filters;
  for (const Format& format : formats()) {
    filters << QString("%1 (*%2)").arg(tr(format.title), format.extensions.join(" *"));
  }
  QString filter = filters[format_->currentIndex()];
  filters << tr("All files (*)");
  const QString name =
      QFileDialog::getSaveFileName(this, tr("Export Medium"), file_->text(), filters.join(";;"),
                                   &filter, QFileDialog::DontConfirmOverwrite);
  if (!name.isEmpty()) file_->setText(name);
}

}  // namespace brume
