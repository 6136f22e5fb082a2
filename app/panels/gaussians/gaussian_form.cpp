#include "app/panels/gaussians/gaussian_form.h"

#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <optional>

#include "app/commands/gaussians/edit_medium.h"
#include "app/document/document.h"
#include "app/document/gaussian_attribute.h"
#include "app/widgets/number_field.h"
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

// The first of them, and its angles once others have been compared with them.
struct First {
  GaussianId id = 0;
  std::optional<glm::dvec3> angles;
};

void compare_shapes(GaussianId id, const Gaussian& gaussian, const EnteredAngles& entered,
                    First& first, Common& common) {
  constexpr double rounding = 1e-14;
  const glm::dvec3 radii = gaussian.radii();
  const glm::dvec3 radii_off = glm::abs(radii - common.first->radii());
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const int k = static_cast<int>(axis);
    if (radii_off[k] > rounding * radii[k]) common.is_mixed[of_shape + axis] = true;
  }
  common.any_ellipsoid = common.any_ellipsoid || !gaussian.is_ball();
  // A selection may be of very many, and angles take long.
  const std::span are_mixed = std::span(common.is_mixed).subspan(of_rotation, 3);
  if (gaussian.shape.rotation == common.first->shape.rotation ||
      std::ranges::find(are_mixed, false) == are_mixed.end()) {
    return;
  }
  if (!first.angles) first.angles = entered.of(first.id, *common.first);
  const glm::dvec3 angles = entered.of(id, gaussian);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const int k = static_cast<int>(axis);
    if (angles[k] != (*first.angles)[k]) are_mixed[axis] = true;
  }
}

Common common_values(const Document& document, const EnteredAngles& entered) {
  const Medium& medium = document.medium();
  const std::vector<GaussianId>& selection = document.selection();
  Common common;
  First first;
  std::array<double, of_shape> values{};  // of the first
  auto next = selection.begin();
  // Both are sorted by id.
  for (std::size_t i = 0; i < medium.size() && next != selection.end(); ++i) {
    if (medium.ids()[i] != *next) continue;
    const Gaussian gaussian = medium.gaussian(i);
    if (!common.first) {
      common.first = gaussian;
      first.id = *next;
      common.any_ellipsoid = !gaussian.is_ball();
    }
    for (std::size_t k = 0; k < of_shape; ++k) {
      const double value = attribute_value(gaussian, GaussianForm::attributes[k]);
      if (next == selection.begin()) values[k] = value;
      if (value != values[k]) common.is_mixed[k] = true;
    }
    if (gaussian.radius != common.first->radius || gaussian.shape != common.first->shape) {
      compare_shapes(*next, gaussian, entered, first, common);
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
    title->setToolTip(fields_[k]->toolTip());
    return title;
  };
  layout_ = new QFormLayout(this);
  layout_->setContentsMargins(8, 8, 8, 4);
  layout_->addRow(tr("Centre"), axes(0));
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
  connect(optics_, &OpticsEditor::edited, this,
          [this](const OpticsEditor::Change& change, MergeId gesture) {
            change_optics(document_, document_.selection(), change, gesture);
          });

  // Gaussians without an albedo of their own show the medium's.
  on_change(document_, Change::part, this, [this] {
    if (document_.scene().optics.albedo != shown_albedo_) refresh();
  });
  on_change(document_, Change::scene, this, [this] {
    start_ = {};
    entered_angles_.forget();
    refresh();
  });
  on_change(document_, Change::medium, this, [this] {
    if (!applying_) start_ = {};  // stale
  });
  on_change(document_, Change::medium | Change::selection, this, &GaussianForm::refresh);
  refresh();
}

void GaussianForm::add_field(std::size_t k) {
  using Scale = ValueField::Scale;
  const GaussianAttribute field = attributes[k];
  const bool is_center = k < 3;
  const bool is_rotation = k >= of_rotation;
  const bool is_of_axis = is_center || is_of_shape(field);
  fields_[k] = new ValueField(
      is_of_axis ? QString(attribute_id(field)).last(1) : attribute_title(field),
      attribute_domain(field), is_center || is_rotation ? Scale::linear : Scale::logarithmic,
      is_rotation ? degrees_step : step, this);
  if (!is_rotation && field != GaussianAttribute::density) fields_[k]->number().show_length_unit();
  fields_[k]->number().setObjectName(attribute_id(field));
  fields_[k]->setToolTip(is_center ? tr("The place of its largest density")
                         : field == GaussianAttribute::radius
                             ? tr("At this distance its density is 1/e of the largest")
                         : field == GaussianAttribute::density
                             ? tr("The scattering coefficient at its centre, per unit of length")
                         : is_rotation ? tr("Euler angles in degrees that turn an ellipsoid's axes")
                                       : tr("Along its own axes: equal ones make it a ball"));
  connect(fields_[k], &ValueField::edited, this,
          [this, field](double value, MergeId gesture) { set(field, value, gesture); });
  connect(fields_[k], &ValueField::adjusted, this,
          [this, field](const Adjustment& adjustment) { adjust(field, adjustment); });
  connect(fields_[k], &ValueField::refused, this, &GaussianForm::refused);
}

void GaussianForm::set(GaussianAttribute field, double value, MergeId gesture) {
  if (field >= GaussianAttribute::rotation_x) {
    const std::vector<GaussianId> turned = selected_ellipsoids();
    return rotate(
        turned, field, [value](double) { return value; },
        set_attribute_text(field, turned.size(), value), gesture);
  }
  const std::vector<GaussianId> ids = document_.selection();
  if (!is_of_shape(field)) {
    set_attribute(document_, ids, field, value, gesture);
    return;
  }
  // From the start of the gesture: on its way an ellipsoid may be a ball, which has no rotation.
  if (gesture == no_merge || gesture != start_.gesture || ids != start_.ids) {
    start_ = {gesture, ids, document_.gaussians(ids)};
  }
  std::vector<Gaussian> after = start_.gaussians;
  for (Gaussian& gaussian : after) set_attribute_value(gaussian, field, value);
  applying_ = true;
  change_gaussians(document_, ids, after, set_attribute_text(field, ids.size(), value), gesture);
  applying_ = false;
}

void GaussianForm::adjust(GaussianAttribute field, const Adjustment& adjustment) {
  if (field < GaussianAttribute::rotation_x) {
    const std::vector<GaussianId> ids = document_.selection();
    return adjust_attribute(document_, ids, field, adjustment);
  }
  const std::vector<GaussianId> turned = selected_ellipsoids();
  rotate(
      turned, field, [&adjustment](double degrees) { return adjustment.of(degrees); },
      tr("Change %1 of %2").arg(attribute_name(field), gaussians_text(turned.size())), no_merge);
}

std::vector<GaussianId> GaussianForm::selected_ellipsoids() const {
  std::vector<GaussianId> ids = document_.selection();
  const Medium& medium = document_.medium();
  std::erase_if(ids, [&medium](GaussianId id) {
    return medium.shape(*medium.index_of(id)) == GaussianShape();
  });
  return ids;
}

void GaussianForm::rotate(std::span<const GaussianId> ids, GaussianAttribute field,
                          const std::function<double(double)>& becomes, const QString& text,
                          MergeId gesture) {
  const int axis = static_cast<int>(field) - static_cast<int>(GaussianAttribute::rotation_x);
  const NumberDomain& domain = attribute_domain(field);
  std::vector<Gaussian> after = document_.gaussians(ids);
  for (std::size_t k = 0; k < ids.size(); ++k) {
    glm::dvec3 angles = entered_angles_.of(ids[k], after[k]);
    const double degrees = becomes(angles[axis]);
    if (std::isnan(degrees)) return;  // as of 0 * (1 / 0)
    angles[axis] = std::clamp(degrees, domain.min_value, domain.max_value);
    entered_angles_.enter(ids[k], angles, after[k]);
  }
  change_gaussians(document_, ids, after, text, gesture);
}

void GaussianForm::refresh() {
  const Common common = common_values(document_, entered_angles_);
  const bool any = common.first.has_value();
  const glm::dvec3 angles = common.any_ellipsoid
                                ? entered_angles_.of(document_.selection().front(), *common.first)
                                : glm::dvec3(0.0);
  for (std::size_t k = 0; k < fields_.size(); ++k) {
    const bool is_there = k < of_rotation ? any : common.any_ellipsoid;
    if (is_there && common.is_mixed[k]) {
      fields_[k]->show_mixed();
    } else if (is_there) {
      fields_[k]->show_value(k < of_rotation ? attribute_value(*common.first, attributes[k])
                                             : angles[static_cast<int>(k - of_rotation)]);
    } else {
      fields_[k]->show_value(std::nullopt);
    }
    fields_[k]->setEnabled(is_there);
  }
  layout_->setRowVisible(rotation_, common.any_ellipsoid);
  shown_albedo_ = document_.scene().optics.albedo;
  optics_->show_optics(any ? std::optional(common.first->optics) : std::nullopt, shown_albedo_);
}

}  // namespace brume
