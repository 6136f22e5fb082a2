#include "app/widgets/optics_editor.h"

#include <QCheckBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <cmath>
#include <glm/common.hpp>

#include "app/document/gaussian_attribute.h"
#include "app/widgets/color_button.h"
#include "app/widgets/value_field.h"
#include "core/number_domain.h"
#include "core/scene/photometry.h"

namespace brume {
namespace {

// With a colour; what does not shine yet begins at 1.
void set_color(glm::dvec3& emission, const glm::dvec3& color) {
  const double strength = emission_strength(emission);
  emission = (strength > 0.0 ? strength : 1.0) * color;
}

}  // namespace

OpticsEditor::OpticsEditor(const QString& prefix, QWidget* parent)
    : QWidget(parent),
      has_albedo_(new QCheckBox(tr("Own albedo"), this)),
      albedo_(new ColorButton(this)),
      emission_(new ValueField(tr("Emission"), domain::intensity, ValueField::Scale::logarithmic,
                               0.01, this)),
      emission_color_(new ColorButton(this)),
      temperature_(new ValueField(tr("K"), domain::temperature, ValueField::Scale::logarithmic,
                                  0.01, this)) {
  has_albedo_->setObjectName(prefix + "_has_albedo");
  has_albedo_->setToolTip(tr("An albedo of its own instead of the medium's: coloured smoke"));
  albedo_->setObjectName(prefix + "_albedo");
  emission_->setObjectName(prefix + "_emission");
  emission_color_->setObjectName(prefix + "_emission_color");
  temperature_->setObjectName(prefix + "_temperature");
  auto* layout = new QFormLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addRow(has_albedo_, albedo_);
  auto* row = new QHBoxLayout;
  row->addWidget(emission_, 1);
  row->addWidget(emission_color_);
  row->addWidget(temperature_, 1);
  QLabel* title = emission_->detach_title();
  title->setObjectName(prefix + "_emission_title");
  title->setToolTip(tr("Radiance of a body of it that nothing shines through, W/(sr u²)"));
  layout->addRow(title, row);
  temperature_->setToolTip(
      tr("Gives the emission the colour of a black body: embers 1000 K, a candle 1850 K"));

  connect(has_albedo_, &QCheckBox::clicked, this, [this](bool has) {
    const glm::dvec3 start = medium_albedo_;
    Q_EMIT edited(
        [has, start](GaussianOptics& optics) {
          optics.albedo = has ? std::optional(optics.albedo.value_or(start)) : std::nullopt;
        },
        no_merge);
  });
  connect(albedo_, &ColorButton::edited, this, [this](const glm::dvec3& color, MergeId gesture) {
    const glm::dvec3 allowed = glm::clamp(color, domain::albedo.min_value, 1.0);
    Q_EMIT edited([allowed](GaussianOptics& optics) { optics.albedo = allowed; }, gesture);
  });
  connect(emission_, &ValueField::edited, this, [this](double value, MergeId gesture) {
    Q_EMIT edited(
        [value](GaussianOptics& optics) {
          optics.emission = value * emission_color(optics.emission);
        },
        gesture);
  });
  connect(emission_color_, &ColorButton::edited, this,
          [this](const glm::dvec3& color, MergeId gesture) {
            Q_EMIT edited([color](GaussianOptics& optics) { set_color(optics.emission, color); },
                          gesture);
          });
  connect(temperature_, &ValueField::edited, this, [this](double value, MergeId gesture) {
    const glm::dvec3 color = black_body_color(value);
    Q_EMIT edited([color](GaussianOptics& optics) { set_color(optics.emission, color); }, gesture);
  });
  for (ValueField* field : {emission_, temperature_}) {
    connect(field, &ValueField::refused, this, &OpticsEditor::refused);
  }
}

void OpticsEditor::show_optics(const std::optional<GaussianOptics>& optics,
                               const glm::dvec3& medium_albedo) {
  medium_albedo_ = medium_albedo;
  const GaussianOptics shown = optics.value_or(GaussianOptics());
  has_albedo_->setChecked(shown.albedo.has_value());
  albedo_->show_color(shown.albedo.value_or(medium_albedo));
  emission_->show_value(optics ? std::optional(emission_strength(shown.emission)) : std::nullopt);
  emission_color_->show_color(emission_color(shown.emission));
  const bool shines = optics && emission_strength(shown.emission) > 0.0;
  temperature_->show_value(
      shines ? std::optional(std::round(nearest_temperature(emission_color(shown.emission))))
             : std::nullopt);
  setEnabled(optics.has_value());
  albedo_->setEnabled(shown.albedo.has_value());
}

}  // namespace brume
