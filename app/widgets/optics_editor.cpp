#include "app/widgets/optics_editor.h"

#include <QCheckBox>
#include <QFormLayout>
#include <glm/common.hpp>

#include "app/widgets/color_button.h"
#include "app/widgets/emission_editor.h"
#include "core/number_domain.h"

namespace brume {

OpticsEditor::OpticsEditor(QFormLayout& form, const QString& emission_title, const QString& prefix,
                           QWidget* parent)
    : QObject(parent),
      has_albedo_(new QCheckBox(tr("Own albedo"), parent)),
      albedo_(new ColorButton(parent)),
      emission_(new EmissionEditor(emission_title, prefix, parent)) {
  has_albedo_->setObjectName(prefix + "_has_albedo");
  has_albedo_->setToolTip(tr("An albedo of its own instead of the medium's: coloured smoke"));
  albedo_->setObjectName(prefix + "_albedo");
  form.addRow(has_albedo_, albedo_);
  form.addRow(emission_->title(), emission_);

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
  connect(emission_, &EmissionEditor::edited, this,
          [this](const EmissionEditor::Change& change, MergeId gesture) {
            Q_EMIT edited([change](GaussianOptics& optics) { change(optics.emission); }, gesture);
          });
  connect(emission_, &EmissionEditor::refused, this, &OpticsEditor::refused);
}

void OpticsEditor::show_optics(const std::optional<GaussianOptics>& optics,
                               const glm::dvec3& medium_albedo) {
  medium_albedo_ = medium_albedo;
  const std::optional<glm::dvec3> albedo = optics ? optics->albedo : std::nullopt;
  has_albedo_->setEnabled(optics.has_value());
  has_albedo_->setChecked(albedo.has_value());
  albedo_->show_color(albedo.value_or(medium_albedo));
  albedo_->setEnabled(albedo.has_value());
  emission_->show_emission(optics ? std::optional(optics->emission) : std::nullopt);
}

}  // namespace brume
