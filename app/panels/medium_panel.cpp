#include "app/panels/medium_panel.h"

#include <QFormLayout>
#include <cmath>

#include "app/commands/edit_medium.h"
#include "app/commands/scene_part_command.h"
#include "app/document/document.h"

namespace brume {
namespace {

constexpr NumberDomain seed_domain{-9e15, 9e15, "an integer"};

}  // namespace

MediumPanel::MediumPanel(Document& document, QWidget* parent) : SceneForm(document, parent) {
  using Scale = ValueField::Scale;
  auto* form = new QFormLayout(this);
  form->setContentsMargins(6, 6, 6, 6);
  const auto change = [this](const QString& text, MergeId gesture, auto how) {
    MediumOptics optics = document_.scene().optics;
    how(optics);
    set_scene_part(document_, std::move(optics), text, gesture);
  };
  const auto optics = [this]() -> const MediumOptics& { return document_.scene().optics; };

  add_number(*form, tr("Homogeneous density, 1/u"),
             {"homogeneous_density", domain::density, Scale::logarithmic, 0.01,
              [this] { return std::optional(document_.medium().homogeneous_density()); },
              [this](double value, MergeId gesture) {
                set_homogeneous_density(document_, value, gesture);
              }});
  add_vector(*form, tr("Albedo"),
             {"albedo", domain::albedo, 0.005, [optics] { return std::optional(optics().albedo); },
              [change](const glm::dvec3& value, MergeId gesture) {
                change(tr("Set albedo"), gesture, [&](MediumOptics& o) { o.albedo = value; });
              },
              "RGB"});
  add_number(*form, tr("Anisotropy g"),
             {"anisotropy", domain::anisotropy, Scale::linear, 0.005,
              [optics] { return std::optional(optics().anisotropy); },
              [change](double value, MergeId gesture) {
                change(tr("Set anisotropy"), gesture,
                       [&](MediumOptics& o) { o.anisotropy = value; });
              }});
  add_number(*form, tr("Noise amplitude"),
             {"noise_amplitude", domain::not_negative, Scale::logarithmic, 0.01,
              [optics] { return std::optional(optics().noise.amplitude); },
              [change](double value, MergeId gesture) {
                change(tr("Set amplitude of noise"), gesture,
                       [&](MediumOptics& o) { o.noise.amplitude = value; });
              }});
  add_number(*form, tr("Noise frequency, 1/u"),
             {"noise_frequency", domain::not_negative, Scale::logarithmic, 0.01,
              [optics] { return std::optional(optics().noise.frequency); },
              [change](double value, MergeId gesture) {
                change(tr("Set frequency of noise"), gesture,
                       [&](MediumOptics& o) { o.noise.frequency = value; });
              }});
  add_vector(*form, tr("Wind, u/s"),
             {"noise_velocity", domain::coordinate, 0.01,
              [optics] { return std::optional(optics().noise.velocity); },
              [change](const glm::dvec3& value, MergeId gesture) {
                change(tr("Set wind"), gesture, [&](MediumOptics& o) { o.noise.velocity = value; });
              }});
  add_number(*form, tr("Noise seed"),
             {"noise_seed", seed_domain, Scale::linear, 1.0,
              [optics] { return std::optional(static_cast<double>(optics().noise.seed)); },
              [change](double value, MergeId gesture) {
                change(tr("Set seed of noise"), gesture, [&](MediumOptics& o) {
                  o.noise.seed = static_cast<std::int64_t>(std::round(value));
                });
              }});
  refresh();
}

}  // namespace brume
