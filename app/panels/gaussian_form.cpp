#include "app/panels/gaussian_form.h"

#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <glm/common.hpp>
#include <optional>
#include <vector>

#include "app/commands/edit_medium.h"
#include "app/document/document.h"
#include "app/document/euler_angles.h"
#include "app/widgets/number_field.h"
#include "app/widgets/optics_editor.h"
#include "app/widgets/value_field.h"

namespace brume {
namespace {

constexpr double step = 0.01;  // u, or part of the value, for each pixel of a drag
constexpr double degrees_step = 0.5;

// The first selected Gaussian, and which of the fields' numbers differ among them.
struct Common {
  std::optional<Gaussian> first;
  std::array<bool, GaussianForm::attributes.size()> is_mixed{};
  bool any_ellipsoid = false;
};

// The first of GaussianForm::attributes that are an ellipsoid's.
constexpr std::size_t of_shape = ball_attributes;
constexpr std::size_t of_rotation = of_shape + 3;

void compare_shapes(const Gaussian& gaussian, Common& common) {
  constexpr double rounding = 1e-14;
  const glm::dvec3 radii = gaussian.radii();
  const glm::dvec3 radii_off = glm::abs(radii - common.first->radii());
  const glm::dquat& first_rotation = common.first->shape.rotation;
  const glm::dvec3 angles_off =
      gaussian.shape.rotation == first_rotation
          ? glm::dvec3(0.0)
          : to_euler_angles(gaussian.shape.rotation) - to_euler_angles(first_rotation);
  for (int axis = 0; axis < 3; ++axis) {
    const std::size_t k = of_shape + static_cast<std::size_t>(axis);
    if (radii_off[axis] > rounding * radii[axis]) common.is_mixed[k] = true;
    if (angles_off[axis] != 0.0) common.is_mixed[k + 3] = true;
  }
  common.any_ellipsoid = common.any_ellipsoid || !gaussian.is_ball();
}

Common common_values(const Document& document) {
  const Medium& medium = document.medium();
  const std::vector<GaussianId>& selection = document.selection();
  Common common;
  std::array<double, of_shape> values{};  // of the first
  auto next = selection.begin();
  // Both are sorted by id.
  for (std::size_t i = 0; i < medium.size() && next != selection.end(); ++i) {
    if (medium.ids()[i] != *next) continue;
    const Gaussian gaussian = medium.gaussian(i);
    if (!common.first) {
      common.first = gaussian;
      common.any_ellipsoid = !gaussian.is_ball();
    }
    for (std::size_t k = 0; k < of_shape; ++k) {
      const double value = attribute_value(gaussian, GaussianForm::attributes[k]);
      if (next == selection.begin()) values[k] = value;
      if (value != values[k]) common.is_mixed[k] = true;
    }
    if (gaussian.radius != common.first->radius || gaussian.shape != common.first->shape) {
      compare_shapes(gaussian, common);
    }
    ++next;
  }
  return common;
}

}  // namespace

GaussianForm::GaussianForm(Document& document, QWidget* parent)
    : QWidget(parent), document_(document) {
  for (std::size_t k = 0; k < fields_.size(); ++k) add_field(k);
  const auto axes = [this](std::size_t first) {
    auto* row = new QHBoxLayout;
    for (std::size_t k = first; k < first + 3; ++k) row->addWidget(fields_[k]);
    return row;
  };
  const auto one = [this](std::size_t k) {
    QLabel* title = fields_[k]->detach_title();
    title->setObjectName(fields_[k]->number().objectName() + "_title");
    return title;
  };
  layout_ = new QFormLayout(this);
  layout_->setContentsMargins(8, 8, 8, 4);
  layout_->addRow(tr("Center"), axes(0));
  // Beside each other: the table below needs the height.
  auto* radius_and_density = new QHBoxLayout;
  QLabel* radius = one(3);
  radius_and_density->addWidget(fields_[3]);
  radius_and_density->addWidget(one(4));
  radius_and_density->addWidget(fields_[4]);
  layout_->addRow(radius, radius_and_density);
  layout_->addRow(tr("Radii"), axes(of_shape));
  rotation_ = axes(of_rotation);
  layout_->addRow(tr("Rotation"), rotation_);

  optics_ = new OpticsEditor(*layout_, tr("Emission"), "gaussian", this);
  connect(optics_, &OpticsEditor::refused, this, &GaussianForm::refused);
  connect(optics_, &OpticsEditor::edited, this, &GaussianForm::change_optics);

  // What Gaussians without their own albedo show.
  connect(&document_, &Document::part_changed, this, [this] {
    if (document_.scene().optics.albedo != shown_albedo_) refresh();
  });
  connect(&document_, &Document::scene_replaced, this, &GaussianForm::refresh);
  connect(&document_, &Document::medium_changed, this, &GaussianForm::refresh);
  connect(&document_, &Document::selection_changed, this, &GaussianForm::refresh);
  refresh();
}

void GaussianForm::add_field(std::size_t k) {
  using Scale = ValueField::Scale;
  const GaussianAttribute field = attributes[k];
  const bool is_center = k < 3;
  const bool is_rotation = k >= of_rotation;
  const bool is_of_axis = is_center || is_of_shape(field);
  fields_[k] = new ValueField(
      is_of_axis ? QString(attribute_name(field).back()) : attribute_title(field),
      attribute_domain(field), is_center || is_rotation ? Scale::linear : Scale::logarithmic,
      is_rotation ? degrees_step : step, this);
  if (!is_rotation && field != GaussianAttribute::density) fields_[k]->number().show_length_unit();
  fields_[k]->number().setObjectName(attribute_name(field).replace(' ', '_'));
  if (is_of_shape(field)) {
    fields_[k]->setToolTip(is_rotation ? tr("Euler angles in degrees that turn an ellipsoid's axes")
                                       : tr("Along its own axes: equal ones make it a ball"));
  }
  connect(fields_[k], &ValueField::edited, this, [this, field](double value, MergeId gesture) {
    const std::vector<GaussianId> ids = document_.selection();
    if (field >= rotation_attribute(0)) return rotate(field, value, gesture);
    set_attribute(document_, ids, field, value, gesture);
  });
  connect(fields_[k], &ValueField::adjusted, this, [this, field](const Adjustment& adjustment) {
    const std::vector<GaussianId> ids = document_.selection();
    adjust_attribute(document_, ids, field, adjustment);
  });
  connect(fields_[k], &ValueField::refused, this, &GaussianForm::refused);
}

glm::dvec3 GaussianForm::angles(const Gaussian& gaussian) const {
  if (gaussian.is_ball()) return glm::dvec3(0.0);
  return from_euler_angles(entered_angles_) == gaussian.shape.rotation
             ? entered_angles_
             : to_euler_angles(gaussian.shape.rotation);
}

void GaussianForm::rotate(GaussianAttribute field, double degrees, MergeId gesture) {
  const int axis = static_cast<int>(field) - static_cast<int>(rotation_attribute(0));
  const std::vector<GaussianId> ids = document_.selection();
  std::vector<Gaussian> after;
  std::optional<glm::dvec3> entered;
  for (const GaussianId id : ids) {
    Gaussian& gaussian =
        after.emplace_back(document_.medium().gaussian(*document_.medium().index_of(id)));
    if (gaussian.is_ball()) continue;
    glm::dvec3 turned = angles(gaussian);
    turned[axis] = degrees;
    gaussian.shape.rotation = from_euler_angles(turned);
    if (!entered) entered = turned;
  }
  entered_angles_ = entered.value_or(entered_angles_);
  change_gaussians(document_, ids, after, set_attribute_text(field, ids.size(), degrees), gesture);
}

void GaussianForm::refresh() {
  const Common common = common_values(document_);
  const bool any = common.first.has_value();
  for (std::size_t k = 0; k < fields_.size(); ++k) {
    const bool is_there = k < of_rotation ? any : common.any_ellipsoid;
    if (is_there && common.is_mixed[k]) {
      fields_[k]->show_mixed();
    } else if (is_there) {
      fields_[k]->show_value(k < of_rotation
                                 ? attribute_value(*common.first, attributes[k])
                                 : angles(*common.first)[static_cast<int>(k - of_rotation)]);
    } else {
      fields_[k]->show_value(std::nullopt);
    }
    fields_[k]->setEnabled(is_there);
  }
  layout_->setRowVisible(rotation_, common.any_ellipsoid);
  shown_albedo_ = document_.scene().optics.albedo;
  optics_->show_optics(any ? std::optional(common.first->optics) : std::nullopt, shown_albedo_);
}

void GaussianForm::change_optics(const OpticsEditor::Change& change, MergeId gesture) {
  const std::vector<GaussianId> ids = document_.selection();
  std::vector<Gaussian> after;
  for (const GaussianId id : ids) {
    after.push_back(document_.medium().gaussian(*document_.medium().index_of(id)));
    change(after.back().optics);
  }
  change_gaussians(document_, ids, after, tr("Set colours of %1").arg(gaussians_text(ids.size())),
                   gesture);
}

}  // namespace brume
