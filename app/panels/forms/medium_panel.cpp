#include "app/panels/forms/medium_panel.h"

#include <QCheckBox>
#include <QComboBox>
#include <QFormLayout>
#include <QMenu>
#include <QPushButton>
#include <QSettings>
#include <array>
#include <glm/geometric.hpp>
#include <string_view>

#include "app/commands/gaussians/edit_medium.h"
#include "app/commands/scene_part_command.h"
#include "app/document/document.h"
#include "app/document/text/words.h"
#include "app/widgets/rows.h"
#include "core/number_domain.h"
#include "core/scene/fields/medium_fields.h"
#include "core/scene/lights/point_lights.h"

namespace brume {
namespace {

constexpr const char* scattering_key = "view/scattering";

// Materials of fog, in visible light. Drops of natural fog scatter more sharply forward,
// g = 0.85 (Hess, Koepke, Schult: Optical Properties of Aerosols and Clouds, 1998): their fog shows
// little but a glare around the lights. Those of thin fog are taken instead.
struct MediumPreset {
  const char* name;
  const char* title;
  glm::dvec3 albedo;
  double anisotropy;
};
constexpr std::array medium_presets{
    // Water haze L (Deirmendjian 1969; Garcia and Siewert 1985): g = 0.804. Water hardly absorbs.
    MediumPreset{"water_fog", QT_TRANSLATE_NOOP("brume::MediumPanel", "Water Fog"),
                 glm::dvec3(0.999), 0.8},
    // Mie theory for fresh drops, log-normal around a radius of 1 micrometre.
    MediumPreset{"steam", QT_TRANSLATE_NOOP("brume::MediumPanel", "Steam"), glm::dvec3(1.0), 0.75},
    // Desert dust over Solar Village (Dubovik et al. 2002): albedo 0.92 at 440 nm, 0.96 at 670 nm,
    // g = 0.69 and 0.66; interpolated to red, green and blue.
    MediumPreset{"dust", QT_TRANSLATE_NOOP("brume::MediumPanel", "Dust"),
                 glm::dvec3(0.95, 0.94, 0.92), 0.68},
    // Soot at 550 nm (Hess, Koepke, Schult 1998).
    MediumPreset{"black_smoke", QT_TRANSLATE_NOOP("brume::MediumPanel", "Black Smoke"),
                 glm::dvec3(0.21), 0.34},
};

// The diagonal of all that is in the scene, after which light from far away crosses no fog without
// an extent; 10 if there is nothing.
double derived_extent(const Scene& scene) {
  const auto bounds = lit_bounds(scene);
  const double diagonal = bounds ? glm::length(bounds->high - bounds->low) : 0.0;
  return diagonal > 0.0 ? domain::length.nearest(diagonal) : 10.0;
}

}  // namespace

MediumPanel::MediumPanel(Document& document, Scattering scattering, QWidget* parent)
    : SceneForm(document, parent), scattering_(named(new QComboBox(this), "scattering")) {
  on_change(document_, Change::medium, this, &MediumPanel::refresh);
  auto* form = new_form();
  add_number(*form, tr("Homogeneous density, 1/u"),
             {"homogeneous_density", domain::density, ValueField::Scale::logarithmic, 0.01,
              [this] { return std::optional(document_.medium().homogeneous_density()); },
              [this](double value, MergeId gesture) {
                set_homogeneous_density(document_, value, gesture);
              }},
             new_key_button("homogeneous_density", [](const Scene& scene) {
               return value_track<KeyedDensity>(scene, "density");
             }));
  form->addRow(tr("Preset"), new_presets());
  const auto optics = [this]() -> const MediumOptics& { return document_.scene().optics; };
  const Fields<MediumOptics> fields{
      .prefix = "",
      .get = [optics] { return &optics(); },
      .set =
          [this](const MediumOptics& changed, const FieldInfo& info, MergeId gesture) {
            set_scene_part(document_, changed, tr("Set %1").arg(in_sentence(field_label(info))),
                           gesture);
          },
      .track = [](const Scene& scene,
                  const FieldInfo& info) { return value_track<MediumOptics>(scene, info.name); }};
  visit_fields<MediumOptics>([&](const auto& field) {
    if (std::string_view(field.info.name) == "extent") add_endless(*form);
    add_field(*form, field, fields);
  });
  fill_scattering(scattering);
  form->addRow(tr("Scattering"), scattering_);
  add_fields<Noise>(
      *form, {.prefix = "noise_",
              .get = [optics] { return &optics().noise; },
              .set =
                  [this](const Noise& changed, const FieldInfo& info, MergeId gesture) {
                    change_optics(tr("Set %1 of noise").arg(in_sentence(field_label(info))),
                                  gesture, [&changed](MediumOptics& o) { o.noise = changed; });
                  },
              .track =
                  [](const Scene& scene, const FieldInfo& info) {
                    return value_track<MediumOptics>(scene, info.name, 1);
                  },
              .object = tr("Noise")});
  refresh();
}

void MediumPanel::change_optics(const QString& text, MergeId gesture,
                                const std::function<void(MediumOptics&)>& change) {
  MediumOptics optics = document_.scene().optics;
  change(optics);
  set_scene_part(document_, std::move(optics), text, gesture);
}

void MediumPanel::add_endless(QFormLayout& form) {
  auto* endless = named(new QCheckBox(tr("Homogeneous fog everywhere"), this), "endless_fog",
                        tr("Without an extent: as far as the view; light from far away crosses as "
                           "much of it as the scene is wide"));
  form.addRow({}, endless);
  connect(endless, &QCheckBox::clicked, this, [this](bool on) {
    change_optics(tr("Set homogeneous extent"), no_merge, [&](MediumOptics& optics) {
      optics.extent.reset();
      if (on) {
        optics.keys.extent.clear();
      } else {
        optics.extent = derived_extent(document_.scene());
      }
    });
  });
  on_refresh(
      [this, endless] { endless->setChecked(!document_.scene().optics.extent.has_value()); });
}

QPushButton* MediumPanel::new_presets() {
  auto* button = new QPushButton(tr("Choose…"), this);
  button->setToolTip(tr("Sets albedo and anisotropy to those of a substance"));
  auto* menu = new QMenu(button);
  for (const MediumPreset& preset : medium_presets) {
    QAction* action = menu->addAction(tr(preset.title));
    action->setObjectName(QString("preset_") + preset.name);
    connect(action, &QAction::triggered, this, [this, &preset] {
      change_optics(tr("Set medium to %1").arg(in_sentence(tr(preset.title))), no_merge,
                    [&](MediumOptics& optics) {
                      optics.albedo = preset.albedo;
                      optics.anisotropy = preset.anisotropy;
                    });
    });
  }
  button->setMenu(menu);
  return button;
}

void MediumPanel::fill_scattering(Scattering scattering) {
  scattering_->addItem(tr("Once"), static_cast<int>(Scattering::single));
  scattering_->addItem(tr("All orders"), static_cast<int>(Scattering::multiple));
  scattering_->setToolTip(tr(
      "How often light is scattered in the fog before it reaches the eye. All orders: any number "
      "of times, as in nature; dense fog is brighter. Once: faster. For all views and exports; "
      "not part of the scene. Paper always scatters once, and paths all orders."));
  const QString remembered = QSettings().value(scattering_key).toString();
  for (const Scattering known : {Scattering::single, Scattering::multiple}) {
    if (remembered == to_string(known)) scattering = known;
  }
  scattering_->setCurrentIndex(scattering_->findData(static_cast<int>(scattering)));
  connect(scattering_, &QComboBox::activated, this, [this] {
    QSettings().setValue(scattering_key, to_string(this->scattering()));
    Q_EMIT scattering_changed(this->scattering());
  });
}

Scattering MediumPanel::scattering() const {
  return static_cast<Scattering>(scattering_->currentData().toInt());
}

}  // namespace brume
