#include "app/import/dialogs/appearance_fields.h"

#include <QComboBox>
#include <QDoubleValidator>
#include <QFormLayout>
#include <QLineEdit>
#include <algorithm>
#include <array>

#include "app/document/text/number_text.h"
#include "app/widgets/rows.h"
#include "core/number_domain.h"

namespace brume {

QLineEdit* number_edit(const char* name, double value, double min_value, double max_value,
                       QWidget* parent) {
  auto* edit = named(new QLineEdit(exact_number_text(value), parent), name);
  auto* domain = new QDoubleValidator(min_value, max_value, 12, edit);
  domain->setLocale(QLocale::c());
  edit->setValidator(domain);
  return edit;
}

AppearanceFields::AppearanceFields(QFormLayout* form, const std::vector<VolumeGridInfo>& grids)
    : QObject(form->parentWidget()) {
  const AppearanceOptions defaults;
  constexpr double min_factor = 1e-12;
  constexpr double max_factor = 1e12;
  color_ = add_grid(form, tr("Colour"), "volume_color", OpticsRole::color, grids);
  emission_ = add_grid(form, tr("Emission"), "volume_emission", OpticsRole::emission, grids);
  temperature_ =
      add_grid(form, tr("Temperature"), "volume_temperature", OpticsRole::temperature, grids);
  temperature_scale_ = add_number(form, tr("Temperature of 1, K"), "volume_temperature_scale",
                                  defaults.temperature_scale, min_factor, max_factor);
  flame_ = add_grid(form, tr("Flames"), "volume_flame", OpticsRole::flame, grids);
  flame_scale_ = add_number(form, tr("Flame extinction, 1/u"), "volume_flame_scale",
                            defaults.flame_scale, min_factor, max_factor);
  flame_temperature_ = add_number(form, tr("Flame temperature, K"), "volume_flame_temperature",
                                  defaults.flame_temperature, domain::temperature.min_value,
                                  domain::temperature.max_value);
  flame_temperature_->setToolTip(tr("Where the volume has no temperature from 800 K"));
  emission_scale_ = add_number(form, tr("Emission scale"), "volume_emission_scale",
                               defaults.emission_scale, min_factor, max_factor);
}

QComboBox* AppearanceFields::add_grid(QFormLayout* form, const QString& title, const char* name,
                                      OpticsRole role, const std::vector<VolumeGridInfo>& grids) {
  auto* combo = named(new QComboBox(form->parentWidget()), name);
  const std::vector<std::string> possible = possible_grids(role, grids);
  const std::string found = default_grid(role, possible);
  combo->addItem(
      tr("Automatic: %1").arg(found == no_grid ? tr("none") : QString::fromStdString(found)),
      auto_grid);
  combo->addItem(tr("None"), no_grid);
  for (const std::string& grid : possible) {
    combo->addItem(QString::fromStdString(grid), QString::fromStdString(grid));
  }
  form->addRow(title, combo);
  return combo;
}

QLineEdit* AppearanceFields::add_number(QFormLayout* form, const QString& title, const char* name,
                                        double value, double min_value, double max_value) {
  QLineEdit* edit = number_edit(name, value, min_value, max_value, form->parentWidget());
  connect(edit, &QLineEdit::textChanged, this, &AppearanceFields::changed);
  form->addRow(title, edit);
  return edit;
}

AppearanceOptions AppearanceFields::options() const {
  const auto grid = [](const QComboBox* combo) {
    return combo->currentData().toString().toStdString();
  };
  AppearanceOptions options;
  options.grids = {grid(color_), grid(emission_), grid(temperature_), grid(flame_)};
  options.temperature_scale = temperature_scale_->text().toDouble();
  options.emission_scale = emission_scale_->text().toDouble();
  options.flame_scale = flame_scale_->text().toDouble();
  options.flame_temperature = flame_temperature_->text().toDouble();
  return options;
}

bool AppearanceFields::is_acceptable() const {
  return std::ranges::all_of(
      std::array{temperature_scale_, emission_scale_, flame_scale_, flame_temperature_},
      [](const QLineEdit* edit) { return edit->hasAcceptableInput(); });
}

}  // namespace brume
