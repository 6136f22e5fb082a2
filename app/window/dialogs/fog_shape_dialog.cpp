#include "app/window/dialogs/fog_shape_dialog.h"

#include <QComboBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>

#include "app/document/document.h"
#include "app/widgets/frame_text.h"
#include "app/widgets/rows.h"
#include "app/widgets/value_field.h"
#include "core/math/rounded.h"
#include "core/number_domain.h"

namespace brume {
namespace {

constexpr double max_cells = 50'000.0;  // more would be slow to edit and to render
constexpr NumberDomain flatness_domain{1.0, 20.0, "a number from 1 to 20"};
constexpr NumberDomain shape_seed_domain{0.0, 1e9, "an integer from 0 to 1e9"};

}  // namespace

FogShapeDialog::FogShapeDialog(Document& document, const FogPlace& place, QWidget* window)
    : QDialog(window),
      document_(document),
      place_(place),
      kind_(named(new QComboBox(this), "fog_shape_kind")),
      count_(named(new QLabel(this), "fog_shape_count")),
      add_(named(new QPushButton(tr("Add"), this), "fog_shape_add")) {
  setAttribute(Qt::WA_DeleteOnClose);
  setObjectName("fog_shape_dialog");
  setWindowTitle(tr("Add fog shape"));
  kind_->addItems({tr("Box"), tr("Sphere"), tr("Height fog")});
  connect(kind_, &QComboBox::activated, this,
          [this](int index) { set_kind(static_cast<FogShape::Kind>(index)); });
  auto* form = new QFormLayout;
  form->addRow(tr("Shape"), kind_);

  const auto field = [this](const QString& title, const char* name, const NumberDomain& domain,
                            ValueField::Scale scale, double step, const QString& tip,
                            const std::function<double()>& get,
                            const std::function<void(double)>& set) {
    auto* made = new ValueField(title, domain, scale, step, this);
    made->setObjectName(name);
    made->setToolTip(tip);
    connect(made, &ValueField::edited, this, [this, set](double value) {
      set(value);
      update_count();
    });
    connect(made, &ValueField::refused, this, [this](const QString& why) { count_->setText(why); });
    updates_.push_back([made, get] { made->show_value(get()); });
    return made;
  };
  const auto vector = [&](const QString& title, const char* name, const NumberDomain& domain,
                          ValueField::Scale scale, const QString& tip, glm::dvec3 FogShape::*part) {
    auto* row = new QHBoxLayout;
    for (int k = 0; k < 3; ++k) {
      row->addWidget(field(
          QString("xyz").mid(k, 1), qPrintable(QString("%1_%2").arg(name).arg(QString("xyz")[k])),
          domain, scale, 0.01, tip, [this, part, k] { return (shape_.*part)[k]; },
          [this, part, k](double value) { (shape_.*part)[k] = value; }));
    }
    form->addRow(title, row);
  };
  const auto number = [&](const QString& title, const char* name, const NumberDomain& domain,
                          ValueField::Scale scale, const QString& tip, double FogShape::*part) {
    ValueField* made = field(
        title, name, domain, scale, 0.01, tip, [this, part] { return shape_.*part; },
        [this, part](double value) { shape_.*part = value; });
    form->addRow(made->detach_title(), made);
  };
  using Scale = ValueField::Scale;
  vector(tr("Center"), "fog_shape_center", domain::coordinate, Scale::linear,
         tr("In scene units; of height fog the middle of its footprint, on the ground"),
         &FogShape::center);
  vector(tr("Size"), "fog_shape_size", domain::length, Scale::logarithmic,
         tr("Edges or diameters in scene units; of height fog y is the height over which its "
            "density falls to 1/e"),
         &FogShape::size);
  number(tr("Density, 1/u"), "fog_shape_density", domain::density, Scale::logarithmic,
         tr("Scattering coefficient within the shape; of height fog at the ground"),
         &FogShape::density);
  number(tr("Spacing"), "fog_shape_spacing", domain::length, Scale::logarithmic,
         tr("Distance between Gaussians in scene units, along y; their radius is 0.8 of it"),
         &FogShape::spacing);
  number(tr("Flatness"), "fog_shape_flatness", flatness_domain, Scale::logarithmic,
         tr("So many times as wide as high are the Gaussians, and as far apart: fewer for layers"),
         &FogShape::flatness);
  number(tr("Jitter"), "fog_shape_jitter", domain::unit, Scale::linear,
         tr("0: an even lattice; 1: random within its cells, so that the fog is patchy"),
         &FogShape::jitter);
  ValueField* seed = field(
      tr("Seed"), "fog_shape_seed", shape_seed_domain, Scale::linear, 1.0,
      tr("Another number makes another pattern"),
      [this] { return static_cast<double>(shape_.seed); },
      [this](double value) { shape_.seed = static_cast<std::uint64_t>(value); });
  form->addRow(seed->detach_title(), seed);

  show_length_units(*this, {"fog_shape_center", "fog_shape_size", "fog_shape_spacing"});
  count_->setWordWrap(true);
  add_->setDefault(true);
  connect(add_, &QPushButton::clicked, this, &FogShapeDialog::add_shape);
  auto* close_button = new QPushButton(tr("Close"), this);
  connect(close_button, &QPushButton::clicked, this, &QWidget::close);
  auto* layout = new QVBoxLayout(this);
  layout->addLayout(form);
  layout->addLayout(row_of({count_, close_button, add_}));
  setMinimumWidth(400);
  set_kind(FogShape::Kind::box);
}

// The size suits the place.
void FogShapeDialog::set_kind(FogShape::Kind kind) {
  const auto round2 = [](double value) { return rounded(value, 2); };
  const bool is_height = kind == FogShape::Kind::height;
  shape_.kind = kind;
  const double side = round2(place_.size * (is_height ? 1.5 : 0.5));
  const double height = is_height ? round2(0.15 * place_.size) : side;
  shape_.size = {side, height, side};
  for (int k = 0; k < 3; ++k) shape_.center[k] = rounded(place_.target[k], 3);
  if (!is_height) shape_.center.y = rounded(place_.target.y + 0.5 * height, 3);
  shape_.spacing = round2(side / (is_height ? 14.0 : 6.0));
  shape_.flatness = is_height ? 2.0 : 1.0;
  shape_.density = round2(1.0 / side);
  update_count();
}

void FogShapeDialog::update_count() {
  for (const auto& update : updates_) update();
  const double cells = cell_count(shape_);
  const bool is_possible = cells <= max_cells;
  add_->setEnabled(is_possible);
  const QString limit = count_text(static_cast<std::uint64_t>(max_cells));
  count_->setText(is_possible ? tr("%1 Gaussians").arg(count_text(fill(shape_).size()))
                              : tr("More than %1 Gaussians: make the spacing larger.").arg(limit));
}

void FogShapeDialog::add_shape() {
  add_fog_shape(document_, shape_);
}

}  // namespace brume
