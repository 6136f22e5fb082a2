#include "app/widgets/emission_editor.h"

#include <QHBoxLayout>
#include <cmath>

#include "app/document/gaussian_attribute.h"
#include "app/widgets/color_button.h"
#include "app/widgets/value_field.h"
#include "core/number_domain.h"
#include "core/scene/lights/photometry.h"

namespace brume {
namespace {

// With a colour; what does not shine yet begins at 1.
void set_color(glm::dvec3& emission, const glm::dvec3& color) {
  const double strength = emission_strength(emission);
  emission = (strength > 0.0 ? strength : 1.0) * color;
}

}  // namespace

EmissionEditor::EmissionEditor(const QString& title, const QString& prefix, QWidget* parent)
    : QWidget(parent),
      strength_(
          new ValueField(title, domain::intensity, ValueField::Scale::logarithmic, 0.01, this)),
      color_(new ColorButton(this)),
      temperature_(
          new ValueField(tr("K"), domain::temperature, ValueField::Scale::logarithmic, 0.01, this)),
      title_(strength_->detach_title()) {
  strength_->setObjectName(prefix + "_emission");
  color_->setObjectName(prefix + "_emission_color");
  temperature_->setObjectName(prefix + "_temperature");
  title_->setObjectName(prefix + "_emission_title");
  title_->setToolTip(tr("Radiance of a body of it that nothing shines through, W/(sr u²)"));
  temperature_->setToolTip(
      tr("Gives the emission the colour of a black body: embers 1000 K, a candle 1850 K"));
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(0, 0, 0, 0);
  row->addWidget(strength_, 1);
  row->addWidget(color_);
  row->addWidget(temperature_, 1);

  connect(strength_, &ValueField::edited, this, [this](double value, MergeId gesture) {
    Q_EMIT edited([value](glm::dvec3& emission) { emission = value * emission_color(emission); },
                  gesture);
  });
  connect(color_, &ColorButton::edited, this, [this](const glm::dvec3& color, MergeId gesture) {
    Q_EMIT edited([color](glm::dvec3& emission) { set_color(emission, color); }, gesture);
  });
  connect(temperature_, &ValueField::edited, this, [this](double value, MergeId gesture) {
    const glm::dvec3 color = black_body_color(value);
    Q_EMIT edited([color](glm::dvec3& emission) { set_color(emission, color); }, gesture);
  });
  for (ValueField* field : {strength_, temperature_}) {
    connect(field, &ValueField::refused, this, &EmissionEditor::refused);
  }
}

void EmissionEditor::show_emission(const std::optional<glm::dvec3>& emission) {
  const glm::dvec3 shown = emission.value_or(glm::dvec3(0.0));
  const double strength = emission_strength(shown);
  strength_->show_value(emission ? std::optional(strength) : std::nullopt);
  color_->show_color(emission_color(shown));
  temperature_->show_value(
      strength > 0.0 ? std::optional(std::round(nearest_temperature(emission_color(shown))))
                     : std::nullopt);
  setEnabled(emission.has_value());
}

}  // namespace brume
