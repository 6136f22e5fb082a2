#include "app/panels/forms/light_panel.h"

#include <QCheckBox>
#include <QComboBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QListWidget>
#include <QMenu>
#include <QPushButton>
#include <QToolButton>
#include <algorithm>
#include <cmath>
#include <glm/common.hpp>

#include "app/commands/edit_lights.h"
#include "app/commands/undo_text.h"
#include "app/document/document.h"
#include "app/document/gaussian_attribute.h"
#include "app/document/number_text.h"
#include "app/document/paths.h"
#include "app/files/file_dialogs.h"
#include "app/panels/forms/environment_panel.h"
#include "app/view/view.h"
#include "app/widgets/color_button.h"
#include "app/widgets/plain_text.h"
#include "brume/limits.h"
#include "core/io/ies_file.h"
#include "core/number_domain.h"
#include "core/scene/lights/photometry.h"

namespace brume {

LightPanel::LightPanel(Document& document, std::function<const View&()> active_view,
                       QWidget* parent)
    : SceneForm(document, parent),
      active_view_(std::move(active_view)),
      list_(new QListWidget(this)) {
  auto* form = new QFormLayout(this);
  form->setContentsMargins(6, 6, 6, 6);
  add_light_list(*form);
  add_light_fields(*form);
  auto* environment = new EnvironmentPanel(document, this);
  form->addRow(environment);
  connect(environment, &EnvironmentPanel::refused, this, &LightPanel::refused);
  on_change(document_, Change::active_light, this, &LightPanel::refresh);
  on_change(document_, Change::scene, &reading_, &BackgroundJob::cancel);
  connect(&reading_, &BackgroundJob::failed, this, &LightPanel::refused);
  refresh();
}

// Above what the view looks at.
LightPlace LightPanel::place() const {
  const View& view = active_view_();
  const glm::dvec3 above = view.shift_on_film({0.0, -0.3 * view.film().height});
  return {view.pivot() + above, view.pivot(), view.rays().eye()};
}

void LightPanel::show_last() {
  document_.set_object(ObjectRef{ObjectRef::Kind::light, document_.scene().lights.size() - 1});
}

void LightPanel::add(LightType type) {
  add_light(document_, type, place());
  show_last();
}

const Light* LightPanel::light() const {
  const Lights& lights = document_.scene().lights;
  return document_.active_light() < lights.size() ? &lights[document_.active_light()] : nullptr;
}

void LightPanel::add_light_list(QFormLayout& form) {
  list_->setObjectName("lights");
  list_->setMaximumHeight(110);
  form.addRow(list_);
  auto* add = new QPushButton(tr("Add light"), this);
  add->setObjectName("add_light");
  auto* add_cone = new QPushButton(tr("Add spot"), this);
  add_cone->setObjectName("add_spot");
  add_cone->setToolTip(tr("Adds a light that shines in a cone, at what the view looks at"));
  auto* add_sun = new QPushButton(tr("Add sun"), this);
  add_sun->setObjectName("add_directional");
  add_sun->setToolTip(tr("Adds a directional light: its rays are parallel"));
  auto* remove = new QPushButton(tr("Delete"), this);
  remove->setObjectName("delete_light");
  const auto menu_button = [this](const char* name, const QString& text, const QString& tip) {
    auto* button = new QToolButton(this);
    button->setObjectName(name);
    button->setText(text);
    button->setToolTip(tip);
    button->setPopupMode(QToolButton::InstantPopup);
    button->setMenu(new QMenu(button));
    return button;
  };
  auto* add_surface = menu_button("add_area", tr("Add area"),
                                  tr("Adds a light that is a surface: its shadows are soft"));
  auto* more = menu_button("light_presets", tr("Presets"),
                           tr("Adds a light with the colour and shape of one in the world"));
  const auto add_row = [&form](std::initializer_list<QWidget*> widgets) {
    auto* row = new QHBoxLayout;
    for (QWidget* widget : widgets) {
      widget->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
      row->addWidget(widget);
    }
    form.addRow(row);
  };
  add_row({add, add_cone, add_sun, add_surface});
  add_row({more, remove});
  const auto add_on_click = [this](QAbstractButton* button, LightType type) {
    connect(button, &QAbstractButton::clicked, this, [this, type] { LightPanel::add(type); });
  };
  add_on_click(add, LightType::point);
  add_on_click(add_cone, LightType::spot);
  add_on_click(add_sun, LightType::directional);
  const auto add_shape = [&](const QString& title, const char* name, LightType type) {
    QAction* action = add_surface->menu()->addAction(title);
    action->setObjectName(name);
    connect(action, &QAction::triggered, this, [this, type] { LightPanel::add(type); });
  };
  add_shape(tr("Rectangle"), "add_rectangle", LightType::rectangle);
  add_shape(tr("Disk"), "add_disk", LightType::disk);
  add_shape(tr("Sphere"), "add_sphere", LightType::sphere);
  for (const LightPreset& preset : light_presets()) {
    QAction* action = more->menu()->addAction(undo_text(preset.title));
    action->setObjectName(preset.name);
    connect(action, &QAction::triggered, this, [this, &preset] {
      add_preset(document_, preset, place());
      show_last();
    });
  }
  connect(remove, &QPushButton::clicked, this,
          [this] { delete_light(document_, document_.active_light()); });
  connect(list_, &QListWidget::currentRowChanged, this, [this](int row) {
    if (!showing_ && row >= 0) document_.set_active_light(static_cast<std::size_t>(row));
  });
  connect(list_, &QListWidget::itemChanged, this, [this](QListWidgetItem* item) {
    if (showing_) return;
    const bool on = item->checkState() == Qt::Checked;
    change_light(document_, static_cast<std::size_t>(list_->row(item)),
                 on ? tr("Turn %1 on") : tr("Turn %1 off"), no_merge,
                 [on](Light& l) { l.on = on; });
  });
  on_refresh([this, remove] {
    show_lights();
    remove->setEnabled(light() != nullptr);
  });
}

void LightPanel::show_lights() {
  showing_ = true;
  const Lights& lights = document_.scene().lights;
  while (list_->count() > static_cast<int>(lights.size())) delete list_->takeItem(0);
  while (list_->count() < static_cast<int>(lights.size())) list_->addItem(QString());
  for (int row = 0; row < list_->count(); ++row) {
    const auto k = static_cast<std::size_t>(row);
    QListWidgetItem* item = list_->item(row);
    item->setText(QString("%1 · %2 %3")
                      .arg(light_title(lights[k], k), number_text(light_strength(lights[k])),
                           light_unit(lights[k])));
    item->setFlags(Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemIsUserCheckable);
    item->setCheckState(lights[k].on ? Qt::Checked : Qt::Unchecked);
    item->setIcon(color_swatch(light_color(lights[k])));
  }
  list_->setCurrentRow(light() ? static_cast<int>(document_.active_light()) : -1);
  showing_ = false;
}

void LightPanel::add_light_fields(QFormLayout& form) {
  const auto change = [this](const QString& verb, MergeId gesture,
                             const std::function<void(Light&)>& how) {
    change_light(document_, document_.active_light(), verb, gesture, how);
  };
  add_type_field(form);
  QLabel* title =
      add_number(form, tr("Intensity"),
                 {"light_intensity", domain::intensity, ValueField::Scale::logarithmic, 0.01,
                  [this]() -> std::optional<double> {
                    return light() ? std::optional(light_strength(*light())) : std::nullopt;
                  },
                  [change](double value, MergeId gesture) {
                    change(tr("Set intensity of %1"), gesture,
                           [value](Light& l) { l.intensity = value * light_color(l); });
                  }});
  // The unit is the type's.
  on_refresh([this, title] {
    const Light shown = light() ? *light() : Light();
    title->setText((shown.directional ? tr("Irradiance, %1")
                    : shown.area      ? tr("Radiance, %1")
                                      : tr("Intensity, %1"))
                       .arg(light_unit(shown)));
  });
  add_photometric_fields(form);
  add_color(form, tr("Colour"),
            {"light_color",
             [this]() -> std::optional<glm::dvec3> {
               return light() ? std::optional(light_color(*light())) : std::nullopt;
             },
             [change](const glm::dvec3& color, MergeId gesture) {
               change(tr("Set colour of %1"), gesture,
                      [color](Light& l) { l.intensity = light_strength(l) * color; });
             }});
  add_vector(form, tr("Position"),
             {"light_position", domain::coordinate, 0.01,
              [this]() -> std::optional<glm::dvec3> {
                return light() && !light()->directional ? std::optional(light()->position)
                                                        : std::nullopt;
              },
              [change](const glm::dvec3& position, MergeId gesture) {
                change(tr("Move %1"), gesture, [position](Light& l) { l.position = position; });
              }});
  add_direction_fields(form);
  add_profile_fields(form);
  add_area_fields(form);
}

void LightPanel::add_profile_fields(QFormLayout& form) {
  auto* name = new PlainLabel(this);
  name->setObjectName("light_profile");
  auto* choose = new QPushButton(tr("Choose…"), this);
  choose->setObjectName("choose_profile");
  choose->setToolTip(tr("Spreads the light as a luminaire does, measured in an IES file"));
  auto* remove = new QPushButton(tr("Remove"), this);
  remove->setObjectName("remove_profile");
  auto* row = new QHBoxLayout;
  row->addWidget(name, 1);
  row->addWidget(choose);
  row->addWidget(remove);
  form.addRow(tr("Profile"), row);
  connect(choose, &QPushButton::clicked, this, [this] {
    const std::filesystem::path file =
        ask_for_file(this, FileKind::profile, tr("Choose a photometric profile"),
                     tr("Photometric profiles (*.ies);;All files (*)"), document_.folder());
    if (!file.empty()) load_profile(file);
  });
  connect(remove, &QPushButton::clicked, this, [this] {
    change_light(document_, document_.active_light(), tr("Remove profile of %1"), no_merge,
                 [](Light& l) { set_profile(l, {}); });
  });
  on_refresh([this, name, choose, remove] {
    const bool can_have = light() && !light()->directional && !light()->area;
    choose->setEnabled(can_have);
    remove->setEnabled(profile() != nullptr);
    name->setText(profile() ? to_qstring(profile()->file.filename()) : tr("none"));
  });
  add_number(form, tr("Rotation, degrees"),
             {"light_profile_rotation", domain::degrees, ValueField::Scale::linear, 0.5,
              [this]() -> std::optional<double> {
                return profile() ? std::optional(profile()->rotation) : std::nullopt;
              },
              [this](double value, MergeId gesture) {
                change_light(document_, document_.active_light(), tr("Rotate profile of %1"),
                             gesture, [value](Light& l) { l.profile.rotation = value; });
              }});
}

void LightPanel::load_profile(const std::filesystem::path& file) {
  const std::filesystem::path path = std::filesystem::absolute(file);
  if (!light()) return;
  reading_.start([this, path, id = light()->id](const Job&) {
    return [this, path, id, content = read_ies(path)] {
      const Lights& lights = document_.scene().lights;
      const auto found = std::ranges::find(lights, id, &Light::id);
      if (found == lights.end() || found->directional || found->area) return;
      const auto index = static_cast<std::size_t>(found - lights.begin());
      change_light(document_, index, tr("Set profile of %1"), no_merge, [&](Light& l) {
        set_profile(l, {path, content, l.profile.rotation});
      });
    };
  });
}

const LightProfile* LightPanel::profile() const {
  return light() && light()->profile.content ? &light()->profile : nullptr;
}

void LightPanel::add_area_fields(QFormLayout& form) {
  const auto change = [this](const QString& verb, MergeId gesture,
                             const std::function<void(AreaLight&)>& how) {
    change_light(document_, document_.active_light(), verb, gesture,
                 [&how](Light& l) { how(*l.area); });
  };
  const auto is_rectangle = [this] {
    return area() && area()->shape == AreaLight::Shape::rectangle;
  };
  const auto add = [&](const QString& title, const char* name, double AreaLight::*number,
                       bool of_rectangle, const QString& verb) {
    add_number(form, title,
               {name, domain::length, ValueField::Scale::logarithmic, 0.01,
                [this, number, of_rectangle, is_rectangle]() -> std::optional<double> {
                  const bool has = area() && is_rectangle() == of_rectangle;
                  return has ? std::optional(area()->*number) : std::nullopt;
                },
                [change, number, verb](double value, MergeId gesture) {
                  change(verb, gesture, [=](AreaLight& a) { a.*number = value; });
                }});
  };
  add(tr("Width"), "light_width", &AreaLight::width, true, tr("Set width of %1"));
  add(tr("Height"), "light_height", &AreaLight::height, true, tr("Set height of %1"));
  add(tr("Radius"), "light_radius", &AreaLight::radius, false, tr("Set radius of %1"));
  show_length_units(*this, {"light_position", "light_width", "light_height", "light_radius"});
  add_vector(form, tr("Up"),
             {"light_up", domain::coordinate, 0.01,
              [this, is_rectangle]() -> std::optional<glm::dvec3> {
                return is_rectangle() ? std::optional(area()->up) : std::nullopt;
              },
              [change](const glm::dvec3& up, MergeId gesture) {
                change(tr("Turn %1"), gesture, [up](AreaLight& a) { a.up = up; });
              }});
  auto* two_sided = new QCheckBox(tr("Two-sided"), this);
  two_sided->setObjectName("light_two_sided");
  two_sided->setToolTip(tr("Shines to both sides; a sphere then lights what is inside it, too"));
  form.addRow({}, two_sided);
  connect(two_sided, &QCheckBox::clicked, this, [change](bool both) {
    change(tr("Set sides of %1"), no_merge, [both](AreaLight& a) { a.two_sided = both; });
  });
  on_refresh([this, two_sided] {
    two_sided->setEnabled(area() != nullptr);
    two_sided->setChecked(area() && area()->two_sided);
  });
}

const AreaLight* LightPanel::area() const {
  return light() && light()->area ? &*light()->area : nullptr;
}

void LightPanel::add_photometric_fields(QFormLayout& form) {
  using Value = std::function<std::optional<double>(const Light&)>;
  const auto add = [&](const QString& text, const char* name, const Value& value_of) {
    const auto get = [this, value_of]() -> std::optional<double> {
      return light() ? value_of(*light()) : std::nullopt;
    };
    const auto set = [this, value_of](double value, MergeId gesture) {
      change_light(document_, document_.active_light(), tr("Set intensity of %1"), gesture,
                   [&](Light& l) {
                     if (l.intensity == glm::dvec3(0.0)) l.intensity = glm::dvec3(1.0);
                     // A cone of no width has no flux.
                     const double factor = value / value_of(l).value_or(0.0);
                     if (!std::isfinite(factor)) return;
                     l.intensity = glm::min(factor * l.intensity, limits::intensity);
                   });
    };
    return add_number(form, text,
                      {name, domain::not_negative, ValueField::Scale::logarithmic, 0.01, get, set});
  };
  QLabel* title = add(tr("Intensity, cd"), "light_candela", photometric_strength);
  on_refresh([this, title] {
    title->setText(light() && light()->directional ? tr("Illuminance, lx")
                   : area()                        ? tr("Luminance, cd/u²")
                                                   : tr("Intensity, cd"));
  });
  title->setToolTip(tr("The same in photometric units: 1 W of white light is 683 lm"));
  add(tr("Luminous flux, lm"), "light_lumen", luminous_flux);
  add_number(form, tr("Temperature, K"),
             {"light_temperature", domain::temperature, ValueField::Scale::logarithmic, 0.01,
              [this]() -> std::optional<double> {
                if (!light()) return {};
                return std::round(nearest_temperature(light_color(*light())));
              },
              [this](double value, MergeId gesture) {
                change_light(document_, document_.active_light(), tr("Set temperature of %1"),
                             gesture, [value](Light& l) {
                               l.intensity = light_strength(l) * black_body_color(value);
                             });
              }})
      ->setToolTip(
          tr("Makes the colour that of a black body: a candle 1850 K, a light bulb 2700 K, "
             "the sun 5500 K, a blue sky 10000 K"));
}

void LightPanel::add_type_field(QFormLayout& form) {
  auto* type = new QComboBox(this);
  type->setObjectName("light_type");
  type->addItems(
      {tr("Point"), tr("Spot"), tr("Directional"), tr("Rectangle"), tr("Disk"), tr("Sphere")});
  type->setItemData(0, tr("Shines in all directions"), Qt::ToolTipRole);
  type->setItemData(1, tr("Shines in a cone"), Qt::ToolTipRole);
  for (const int shape : {3, 4, 5}) {
    type->setItemData(shape, tr("A surface that shines"), Qt::ToolTipRole);
  }
  type->setItemData(2, tr("The sun: far away, its rays are parallel"), Qt::ToolTipRole);
  form.addRow(tr("Type"), type);
  connect(type, &QComboBox::activated, this, [this](int index) {
    if (!light() || index == static_cast<int>(type_of(*light()))) return;
    const LitRegion region = LitRegion::of(document_.scene());
    change_light(document_, document_.active_light(), tr("Change type of %1"), no_merge,
                 [&](Light& l) { set_type(l, static_cast<LightType>(index), region); });
  });
  on_refresh([this, type] {
    type->setEnabled(light() != nullptr);
    type->setCurrentIndex(light() ? static_cast<int>(type_of(*light())) : -1);
  });
}

void LightPanel::add_direction_fields(QFormLayout& form) {
  add_vector(form, tr("Direction"),
             {"light_direction", domain::coordinate, 0.01,
              [this]() -> std::optional<glm::dvec3> {
                return light() ? light_direction(*light()) : std::nullopt;
              },
              [this](const glm::dvec3& direction, MergeId gesture) {
                if (direction == glm::dvec3(0.0)) return;
                change_light(document_, document_.active_light(), tr("Turn %1"), gesture,
                             [&](Light& l) { turn(l, direction); });
              }});
  add_number(form, tr("Disc, degrees"),
             {"light_angular_diameter", domain::angular_diameter, ValueField::Scale::linear, 0.01,
              [this]() -> std::optional<double> {
                return light() && light()->directional
                           ? std::optional(light()->directional->angular_diameter)
                           : std::nullopt;
              },
              [this](double value, MergeId gesture) {
                change_light(document_, document_.active_light(), tr("Set angular diameter of %1"),
                             gesture,
                             [value](Light& l) { l.directional->angular_diameter = value; });
              }})
      ->setToolTip(tr("Angular diameter: the wider, the softer the shadows, at the cost of eight "
                      "lights; the sun's is 0.53"));
  const auto change = [this](const QString& verb, MergeId gesture,
                             const std::function<SpotCone(const SpotCone&)>& how) {
    change_light(document_, document_.active_light(), verb, gesture,
                 [&how](Light& l) { l.spot = how(*l.spot); });
  };
  const auto add_angle = [&](const QString& title, const char* name, double SpotCone::*angle,
                             SpotCone (*with)(SpotCone, double), const QString& verb) {
    add_number(form, title,
               {name, domain::cone_angle, ValueField::Scale::linear, 0.25,
                [this, angle]() -> std::optional<double> {
                  return cone() ? std::optional(cone()->*angle) : std::nullopt;
                },
                [change, with, verb](double value, MergeId gesture) {
                  change(verb, gesture, [=](const SpotCone& c) { return with(c, value); });
                }});
  };
  add_angle(tr("Inner angle, degrees"), "light_inner_angle", &SpotCone::inner_angle,
            with_inner_angle, tr("Set inner angle of %1"));
  add_angle(tr("Outer angle, degrees"), "light_outer_angle", &SpotCone::outer_angle,
            with_outer_angle, tr("Set outer angle of %1"));
}

const SpotCone* LightPanel::cone() const {
  return light() && light()->spot ? &*light()->spot : nullptr;
}

}  // namespace brume
