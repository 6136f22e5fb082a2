#include "app/window/dialogs/fog_shape_dialog.h"

#include <QComboBox>
#include <QFormLayout>
#include <QLabel>
#include <QPushButton>

#include "app/panels/forms/numbers_form.h"
#include "app/widgets/frame_text.h"
#include "app/widgets/rows.h"
#include "core/math/rounded.h"

namespace brume {

FogShapeDialog::FogShapeDialog(Document& document, const FogPlace& place, QWidget* window)
    : QDialog(window),
      document_(document),
      place_(place),
      kind_(named(new QComboBox(this), "fog_shape_kind")),
      count_(named(new QLabel(this), "fog_shape_count")),
      add_(named(new QPushButton(tr("Add"), this), "fog_shape_add")) {
  setAttribute(Qt::WA_DeleteOnClose);
  setObjectName("fog_shape_dialog");
  setWindowTitle(tr("Add Fog Shape"));
  kind_->addItems({tr("Box"), tr("Sphere"), tr("Height fog")});
  connect(kind_, &QComboBox::activated, this,
          [this](int index) { set_kind(static_cast<FogShape::Kind>(index)); });
  auto* form = new QFormLayout;
  form->addRow(tr("Shape"), kind_);

  form_ = new NumbersForm(document, "fog_shape_",
                          std::function<const FogShape*()>([this] { return &shape_; }),
                          std::function<void(const FogShape&)>([this](const FogShape& shape) {
                            shape_ = shape;
                            update_count();
                          }),
                          this);
  connect(form_, &SceneForm::refused, count_, &QLabel::setText);
  count_->setWordWrap(true);
  add_->setDefault(true);
  connect(add_, &QPushButton::clicked, this, &FogShapeDialog::add_shape);
  auto* close_button = new QPushButton(tr("Close"), this);
  connect(close_button, &QPushButton::clicked, this, &QWidget::close);
  auto* layout = new QVBoxLayout(this);
  layout->addLayout(form);
  layout->addWidget(form_);
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
  form_->refresh();
  const QString problem = fog_problem(shape_);
  add_->setEnabled(problem.isEmpty());
  if (!problem.isEmpty()) return count_->setText(problem);
  const std::size_t count = fill(shape_).size();
  count_->setText(tr("%1 Gaussian(s)", nullptr, static_cast<int>(count)).arg(count_text(count)));
}

void FogShapeDialog::add_shape() {
  add_fog_shape(document_, shape_);
}

}  // namespace brume
