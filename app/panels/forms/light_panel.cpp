#include "app/panels/forms/light_panel.h"

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
#include <functional>
#include <glm/common.hpp>
#include <string_view>

#include "app/commands/objects/edit_objects.h"
#include "app/commands/undo_text.h"
#include "app/document/document.h"
#include "app/document/gaussian_attribute.h"
#include "app/document/object_titles.h"
#include "app/document/paths.h"
#include "app/document/text/number_text.h"
#include "app/document/text/words.h"
#include "app/files/file_dialogs.h"
#include "app/panels/forms/environment_panel.h"
#include "app/panels/forms/key_button.h"
#include "app/view/view.h"
#include "app/widgets/color_button.h"
#include "app/widgets/keys.h"
#include "app/widgets/plain_text.h"
#include "app/widgets/rows.h"
#include "brume/limits.h"
#include "core/io/ies_file.h"
#include "core/io/image/texture_file.h"
#include "core/number_domain.h"
#include "core/scene/fields/light_fields.h"
#include "core/scene/light_rules.h"
#include "core/scene/lights/photometry.h"

namespace brume {

LightPanel::LightPanel(Document& document, std::function<const View&()> active_view,
                       QWidget* parent)
    : SceneForm(document, parent),
      active_view_(std::move(active_view)),
      list_(named(new QListWidget(this), "lights")) {
  auto* form = new_form();
  form->setRowWrapPolicy(QFormLayout::WrapLongRows);  // docks are narrow
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

void LightPanel::add(const Light::Kind& kind) {
  add_light(document_, kind, place());
  show_last();
}

const Light* LightPanel::light() const {
  const Lights& lights = document_.scene().lights;
  return document_.active_light() < lights.size() ? &lights[document_.active_light()] : nullptr;
}

void LightPanel::change(const QString& text, MergeId gesture,
                        const std::function<void(Light&)>& how) {
  change_light(document_, document_.active_light(), text, gesture, how);
}

void LightPanel::add_light_list(QFormLayout& form) {
  list_->setMaximumHeight(110);
  form.addRow(list_);
  auto* add = named(new QPushButton(tr("Add light"), this), "add_light");
  auto* add_cone = named(new QPushButton(tr("Add spot"), this), "add_spot",
                         tr("Adds a light that shines in a cone, at what the view looks at"));
  auto* add_sun = named(new QPushButton(tr("Add sun"), this), "add_directional",
                        tr("Adds a directional light: its rays are parallel"));
  auto* remove = named(new QPushButton(tr("Delete"), this), "delete_light");
  const auto menu_button = [this](const char* name, const QString& text, const QString& tip) {
    auto* button = named(new QToolButton(this), name);
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
  const auto add_on_click = [this](QAbstractButton* button, const Light::Kind& kind) {
    connect(button, &QAbstractButton::clicked, this, [this, kind] { LightPanel::add(kind); });
  };
  add_on_click(add, light::Point());
  add_on_click(add_cone, light::Spot());
  add_on_click(add_sun, light::Directional());
  visit_light_kinds([&](const LightKindInfo& info, const Light::Kind& kind) {
    if (!area_of({.kind = kind})) return;
    QAction* action = add_surface->menu()->addAction(fields_text(info.label));
    action->setObjectName(QString("add_") + info.name);
    connect(action, &QAction::triggered, this, [this, kind] { LightPanel::add(kind); });
  });
  for (const LightPreset& preset : light_presets()) {
    QAction* action = more->menu()->addAction(undo_text(preset.title));
    action->setObjectName(preset.name);
    connect(action, &QAction::triggered, this, [this, &preset] {
      add_preset(document_, preset, place());
      show_last();
    });
  }
  on_delete_key(*list_, [remove] { remove->click(); });
  connect(remove, &QPushButton::clicked, this, [this] {
    delete_object(document_, {ObjectRef::Kind::light, document_.active_light()});
  });
  connect(list_, &QListWidget::currentRowChanged, this, [this](int row) {
    if (showing_ || row < 0) return;
    document_.set_object(ObjectRef{ObjectRef::Kind::light, static_cast<std::size_t>(row)});
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
  add_type_field(form);
  add_strength_field(form);
  add_photometric_fields(form);
  add_color(form, tr("Colour"),
            {"light_color", [this] { return value_if(light(), light_color); },
             [this](const glm::dvec3& color, MergeId gesture) {
               change(tr("Set colour of %1"), gesture,
                      [color](Light& l) { l.intensity = light_strength(l) * color; });
             }});
  visit_light_fields([&](const auto& field, const Light&) {
    const std::string_view name = field.info.name;
    if (name == "profile_rotation") add_profile_field(form);
    if (name == "texture_rotation") add_texture_field(form);
    // Values in the list have no row; the strength has one with its color.
    const bool is_listed = name == "on" || name == "locked";
    if (!is_listed && !is_strength(field)) add_value(form, field);
  });
}

void LightPanel::add_strength_field(QFormLayout& form) {
  QLabel* title = add_number(form, tr("Intensity"),
                             {"light_intensity", domain::intensity, ValueField::Scale::logarithmic,
                              0.01, [this] { return value_if(light(), light_strength); },
                              [this](double value, MergeId gesture) {
                                change(tr("Set intensity of %1"), gesture,
                                       [value](Light& l) { l.intensity = value * light_color(l); });
                              }},
                             new_key_button("light_intensity", [this](const Scene& scene) {
                               return value_track<Lights>(scene, strength_info(*light()).name,
                                                          document_.active_light());
                             }));
  on_refresh([this, title] {
    const Light shown = light() ? *light() : Light();
    const FieldInfo& info = strength_info(shown);
    title->setText(field_label(info) + ", " + light_unit(shown));
    title->setToolTip(fields_text(info.says));
  });
}

template <class F>
void LightPanel::add_value(QFormLayout& form, const F& field) {
  using Value = typename F::Value;
  const char* name = field.info.name;
  // Where the light's kind has it.
  const auto get = [name](auto& light) -> auto& {
    return *find_value<Value>(light, name);
  };
  const Field<Light, decltype(get), decltype(field.keys)> found{get, field.keys, field.domain,
                                                                field.info};
  add_field(
      form, found,
      {.prefix = "light_",
       .get = [this,
               name] { return light() && find_value<Value>(*light(), name) ? light() : nullptr; },
       .set = std::bind_front(&LightPanel::set_value, this),
       .track =
           [this](const Scene& scene, const FieldInfo& info) {
             return value_track<Lights>(scene, info.name, document_.active_light());
           }});
}

void LightPanel::set_value(Light changed, const FieldInfo& info, MergeId gesture) {
  if (auto* spot = changed.as<light::Spot>()) {
    const std::string_view name = info.name;
    if (name == "inner_angle") *spot = with_inner_angle(*spot, spot->inner_angle);
    if (name == "outer_angle") *spot = with_outer_angle(*spot, spot->outer_angle);
  }
  if (refusal(changed)) return refresh();
  change(tr("Set %1 of %2").arg(in_sentence(field_label(info)), "%1"), gesture,
         [&changed](Light& l) { l = std::move(changed); });
}

void LightPanel::add_file_field(QFormLayout& form, const LightFile& file) {
  const QString title = in_sentence(file.label);
  const QString object = QString(file.name);
  auto* name = new PlainLabel(this);
  name->setObjectName("light_" + object);
  auto* choose = new QPushButton(tr("Choose…"), this);
  choose->setObjectName("choose_" + object);
  choose->setToolTip(file.says);
  auto* remove = new QPushButton(tr("Remove"), this);
  remove->setObjectName("remove_" + object);
  form.addRow(file.label, row_of({name, choose, remove}));
  connect(choose, &QPushButton::clicked, this, [file] {
    const std::filesystem::path chosen = file.ask();
    if (!chosen.empty()) file.load(chosen);
  });
  connect(remove, &QPushButton::clicked, this, [this, file, title] {
    change(tr("Remove %1 of %2").arg(title, "%1"), no_merge, [&file](Light& l) { file.remove(l); });
  });
  on_refresh([this, file, name, choose, remove] {
    const std::filesystem::path* of_light = light() ? file.of(*light()) : nullptr;
    choose->setEnabled(light() && file.may_have(*light()));
    remove->setEnabled(of_light != nullptr);
    name->setText(of_light ? to_qstring(of_light->filename()) : tr("none"));
  });
}

void LightPanel::add_profile_field(QFormLayout& form) {
  add_file_field(
      form, {.name = "profile",
             .label = tr("Profile"),
             .says = tr("Spreads the light as a luminaire does, measured in an IES file"),
             .may_have = [](const Light& l) { return profile_member(l) != nullptr; },
             .of =
                 [](const Light& l) {
                   const LightProfile* profile = profile_of(l);
                   return profile ? &profile->file : nullptr;
                 },
             .ask =
                 [this] {
                   return ask_for_file(this, FileKind::profile, tr("Choose a Photometric Profile"),
                                       tr("Photometric profiles (*.ies);;All files (*)"),
                                       document_.folder());
                 },
             .load = [this](const std::filesystem::path& file) { load_profile(file); },
             .remove = [](Light& l) { set_profile(l, {}); }});
}

void LightPanel::add_texture_field(QFormLayout& form) {
  add_file_field(form, {.name = "texture",
                        .label = tr("Texture"),
                        .says = tr("A picture in the beam of a spot, a gobo"),
                        .may_have =
                            [](const Light& l) {
                              const auto* spot = l.as<light::Spot>();
                              return spot && spot->outer_angle < 90.0;
                            },
                        .of =
                            [](const Light& l) {
                              const LightTexture* texture = texture_of(l);
                              return texture ? &texture->file : nullptr;
                            },
                        .ask =
                            [this] {
                              return ask_for_file(
                                  this, FileKind::texture, tr("Choose a Picture"),
                                  tr("Pictures (*.png *.jpg *.jpeg);;All files (*)"),
                                  document_.folder());
                            },
                        .load = [this](const std::filesystem::path& file) { load_texture(file); },
                        .remove = [](Light& l) { set_texture(l, {}); }});
}

template <class Read, class Set>
void LightPanel::load_file(const std::filesystem::path& file, const QString& text, Read read,
                           Set set) {
  const std::filesystem::path path = std::filesystem::absolute(file);
  if (!light()) return;
  reading_.start([this, path, text, read, set, id = light()->id](const Job&) {
    return [this, path, text, set, id, content = read(path)] {
      const Lights& lights = document_.scene().lights;
      const auto found = std::ranges::find(lights, id, &Light::id);
      if (found == lights.end()) return;
      Light changed = *found;
      set(changed, path, content);
      if (const auto why = refusal(changed)) {
        Q_EMIT refused(QString::fromStdString(std::string(why->member) + ": " + why->message));
        return;
      }
      const auto index = static_cast<std::size_t>(found - lights.begin());
      change_light(document_, index, text, no_merge, [&](Light& l) { l = changed; });
    };
  });
}

void LightPanel::load_profile(const std::filesystem::path& file) {
  load_file(file, tr("Set profile of %1"), read_ies,
            [](Light& l, const std::filesystem::path& path, const auto& content) {
              if (LightProfile* profile = profile_member(l)) {
                set_profile(l, {path, content, profile->rotation});
              }
            });
}

void LightPanel::load_texture(const std::filesystem::path& file) {
  load_file(
      file, tr("Set texture of %1"),
      [](const std::filesystem::path& path) { return read_texture(path, true, nullptr); },
      [](Light& l, const std::filesystem::path& path, const auto& content) {
        if (auto* spot = l.as<light::Spot>()) {
          set_texture(l, {path, content, spot->texture.rotation, spot->texture.focus});
        }
      });
}

void LightPanel::add_photometric_fields(QFormLayout& form) {
  using Value = std::function<std::optional<double>(const Light&)>;
  const auto add = [&](const QString& text, const char* name, const Value& value_of) {
    const auto get = [this, value_of]() -> std::optional<double> {
      return light() ? value_of(*light()) : std::nullopt;
    };
    const auto set = [this, value_of](double value, MergeId gesture) {
      change(tr("Set intensity of %1"), gesture, [&](Light& l) {
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
    const std::string_view name = strength_info(light() ? *light() : Light()).name;
    title->setText(name == "irradiance" ? tr("Illuminance, lx")
                   : name == "radiance" ? tr("Luminance, cd/u²")
                                        : tr("Intensity, cd"));
  });
  title->setToolTip(tr("The same in photometric units: 1 W of white light is 683 lm"));
  add(tr("Luminous flux, lm"), "light_lumen", luminous_flux)
      ->setToolTip(tr("Light in all directions together"));
  add_number(form, tr("Temperature, K"),
             {"light_temperature", domain::temperature, ValueField::Scale::logarithmic, 0.01,
              [this]() -> std::optional<double> {
                if (!light()) return {};
                return std::round(nearest_temperature(light_color(*light())));
              },
              [this](double value, MergeId gesture) {
                change(tr("Set temperature of %1"), gesture, [value](Light& l) {
                  l.intensity = light_strength(l) * black_body_color(value);
                });
              }})
      ->setToolTip(
          tr("Makes the colour that of a black body: a candle 1850 K, a light bulb 2700 K, "
             "the sun 5500 K, a blue sky 10000 K"));
}

void LightPanel::add_type_field(QFormLayout& form) {
  auto* type = named(new QComboBox(this), "light_type", tr("What the light comes from"));
  for (const LightKindInfo& info : light_kinds) {
    type->addItem(fields_text(info.label));
    type->setItemData(type->count() - 1, fields_text(info.says), Qt::ToolTipRole);
  }
  form.addRow(tr("Type"), type);
  connect(type, &QComboBox::activated, this, [this](int index) {
    const auto kind = static_cast<std::size_t>(index);
    if (!light() || kind == light()->kind.index()) return;
    const LitRegion region = LitRegion::of(document_.scene());
    change(tr("Change type of %1"), no_merge,
           [&](Light& l) { set_kind(l, light_kind(kind), region); });
  });
  on_refresh([this, type] {
    type->setEnabled(light() != nullptr);
    type->setCurrentIndex(light() ? static_cast<int>(light()->kind.index()) : -1);
  });
}

}  // namespace brume
