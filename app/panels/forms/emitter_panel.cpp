#include "app/panels/forms/emitter_panel.h"

#include <QFormLayout>
#include <QListWidget>
#include <QPushButton>
#include <cmath>

#include "app/commands/edit_emitters.h"
#include "app/document/document.h"
#include "app/widgets/emission_editor.h"
#include "app/widgets/optics_editor.h"
#include "core/number_domain.h"

namespace brume {
namespace {

constexpr NumberDomain seed_domain{-9e15, 9e15, "an integer"};

}  // namespace

EmitterPanel::EmitterPanel(Document& document, QWidget* parent)
    : SceneForm(document, parent), list_(new QListWidget(this)) {
  auto* form = new QFormLayout(this);
  form->setContentsMargins(6, 6, 6, 6);
  add_list(*form);
  add_fields(*form);
  on_change(document_, Change::active_emitter, this, &EmitterPanel::refresh);
  refresh();
}

const Emitter* EmitterPanel::emitter() const {
  const Emitters& emitters = document_.scene().emitters;
  return document_.active_emitter() < emitters.size() ? &emitters[document_.active_emitter()]
                                                      : nullptr;
}

void EmitterPanel::add_list(QFormLayout& form) {
  list_->setObjectName("emitters");
  list_->setMaximumHeight(80);
  auto* remove = new QPushButton(tr("Delete"), this);
  remove->setObjectName("delete_emitter");
  form.addRow(list_);
  form.addRow(remove);
  connect(remove, &QPushButton::clicked, this,
          [this] { delete_emitter(document_, document_.active_emitter()); });
  connect(list_, &QListWidget::currentRowChanged, this, [this](int row) {
    if (!showing_ && row >= 0) document_.set_active_emitter(static_cast<std::size_t>(row));
  });
  on_refresh([this, remove] {
    showing_ = true;
    const int count = static_cast<int>(document_.scene().emitters.size());
    while (list_->count() > count) delete list_->takeItem(list_->count() - 1);
    while (list_->count() < count) list_->addItem(tr("Emitter %1").arg(list_->count() + 1));
    list_->setCurrentRow(emitter() ? static_cast<int>(document_.active_emitter()) : -1);
    remove->setEnabled(emitter() != nullptr);
    showing_ = false;
  });
}

void EmitterPanel::add_fields(QFormLayout& form) {
  using Scale = ValueField::Scale;
  // `read` answers a reference to the number in an emitter.
  const auto number = [&](const QString& title, const char* name, const NumberDomain& domain,
                          Scale scale, double step, auto read, const QString& verb) {
    add_number(form, title,
               {name, domain, scale, step,
                [this, read]() -> std::optional<double> {
                  if (!emitter()) return std::nullopt;
                  Emitter copy = *emitter();
                  return static_cast<double>(read(copy));
                },
                [this, read, verb](double value, MergeId gesture) {
                  change_emitter(
                      document_, document_.active_emitter(), verb, gesture, [&](Emitter& e) {
                        auto& target = read(e);
                        target = static_cast<std::remove_reference_t<decltype(target)>>(value);
                      });
                }});
  };
  const auto vector = [&](const QString& title, const char* name, glm::dvec3 Emitter::*member,
                          const QString& verb) {
    add_vector(form, title,
               {name, domain::coordinate, 0.01,
                [this, member]() -> std::optional<glm::dvec3> {
                  return emitter() ? std::optional(emitter()->*member) : std::nullopt;
                },
                [this, member, verb](const glm::dvec3& value, MergeId gesture) {
                  change_emitter(document_, document_.active_emitter(), verb, gesture,
                                 [&](Emitter& e) { e.*member = value; });
                }});
  };
  vector(tr("Position"), "emitter_position", &Emitter::position, tr("Move %1"));
  number(
      tr("Rate, 1/s"), "emitter_rate", domain::not_negative, Scale::logarithmic, 0.01,
      [](Emitter& e) -> double& { return e.rate; }, tr("Set rate of %1"));
  number(
      tr("Lifetime, s"), "emitter_lifetime", domain::not_negative, Scale::logarithmic, 0.01,
      [](Emitter& e) -> double& { return e.lifetime; }, tr("Set lifetime of %1"));
  vector(tr("Velocity, u/s"), "emitter_velocity", &Emitter::velocity, tr("Set velocity of %1"));
  number(
      tr("Spread, u/s"), "emitter_spread", domain::not_negative, Scale::logarithmic, 0.01,
      [](Emitter& e) -> double& { return e.spread; }, tr("Set spread of %1"));
  vector(tr("Acceleration"), "emitter_acceleration", &Emitter::acceleration,
         tr("Set acceleration of %1"));
  number(
      tr("Radius at birth"), "emitter_radius_birth", domain::length, Scale::logarithmic, 0.01,
      [](Emitter& e) -> double& { return e.radius.x; }, tr("Set radius of %1"));
  number(
      tr("at death"), "emitter_radius_death", domain::length, Scale::logarithmic, 0.01,
      [](Emitter& e) -> double& { return e.radius.y; }, tr("Set radius of %1"));
  number(
      tr("Density at birth"), "emitter_density_birth", domain::density, Scale::logarithmic, 0.01,
      [](Emitter& e) -> double& { return e.density.x; }, tr("Set density of %1"));
  number(
      tr("at death"), "emitter_density_death", domain::density, Scale::logarithmic, 0.01,
      [](Emitter& e) -> double& { return e.density.y; }, tr("Set density of %1"));
  add_optics(form);
  number(
      tr("Seed"), "emitter_seed", seed_domain, Scale::linear, 1.0,
      [](Emitter& e) -> std::int64_t& { return e.seed; }, tr("Set seed of %1"));
}

void EmitterPanel::add_optics(QFormLayout& form) {
  auto* optics = new OpticsEditor(form, tr("Emission at birth"), "emitter", this);
  show_length_units(*this, {"emitter_position", "emitter_radius_birth", "emitter_radius_death"});
  auto* at_death = new EmissionEditor(tr("at death"), "emitter_death", this);
  form.addRow(at_death->title(), at_death);
  connect(optics, &OpticsEditor::edited, this,
          [this](const OpticsEditor::Change& change, MergeId gesture) {
            change_emitter(document_, document_.active_emitter(), tr("Set colours of %1"), gesture,
                           [&](Emitter& e) {
                             change(e.optics);
                             if (!e.optics.albedo) e.keys.albedo.clear();
                           });
          });
  connect(at_death, &EmissionEditor::edited, this,
          [this](const EmissionEditor::Change& change, MergeId gesture) {
            change_emitter(document_, document_.active_emitter(), tr("Set emission of %1"), gesture,
                           [&](Emitter& e) { change(e.emission_at_death); });
          });
  connect(optics, &OpticsEditor::refused, this, &EmitterPanel::refused);
  connect(at_death, &EmissionEditor::refused, this, &EmitterPanel::refused);
  on_refresh([this, optics, at_death] {
    const Emitter* shown = emitter();
    optics->show_optics(shown ? std::optional(shown->optics) : std::nullopt,
                        document_.scene().optics.albedo);
    at_death->show_emission(shown ? std::optional(shown->emission_at_death) : std::nullopt);
  });
}

}  // namespace brume
