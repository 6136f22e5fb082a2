#include "app/panels/forms/material_panel.h"

#include <QComboBox>
#include <QFormLayout>
#include <QToolButton>
#include <algorithm>

#include "app/commands/objects/edit_objects.h"
#include "app/document/document.h"
#include "app/document/euler_angles.h"
#include "app/document/object_titles.h"
#include "app/document/text/words.h"
#include "app/files/file_dialogs.h"
#include "app/panels/forms/metallic_roughness_form.h"
#include "app/widgets/rows.h"
#include "core/io/merl_file.h"
#include "core/number_domain.h"
#include "core/scene/fields/copies_fields.h"
#include "core/scene/fields/surface_fields.h"
#include "core/scene/imported_scene.h"

namespace brume {

MaterialPanel::MaterialPanel(Document& document, QWidget* parent)
    : SceneForm(document, parent),
      surfaces_(named(new QComboBox(this), "surface", tr("The surface that is shown here"))),
      materials_(named(new QComboBox(this), "surface_material")),
      restore_(named(new QToolButton(this), "restore_material")),
      type_(named(new QComboBox(this), "material_type", tr("How the surface reflects light"))),
      transfer_(named(new QComboBox(this), "transfer")),
      copies_(named(new QComboBox(this), "copies")) {
  type_->addItems({tr("Diffuse"), tr("Phong"), tr("Measured…"), tr("Metallic-roughness")});
  transfer_->addItems({tr("None"), tr("Shadows"), tr("Shadows and interreflection")});
  transfer_->setToolTip(
      tr("Precomputed self-shadowing and interreflection within the object, of the environment and "
         "of light scattered by fog"));
  auto* form = new_form();
  form->addRow(tr("Surface"), surfaces_);
  connect(surfaces_, &QComboBox::currentIndexChanged, this, &MaterialPanel::refresh);
  connect(type_, &QComboBox::activated, this, &MaterialPanel::choose_type);
  on_refresh([this] {
    const Surfaces& surfaces = document_.scene().surfaces;
    const QSignalBlocker blocker(surfaces_);
    const int index = surfaces_->currentIndex();
    surfaces_->clear();
    surfaces_->addItems(surface_names(surfaces));
    surfaces_->setCurrentIndex(
        std::clamp(index, std::min(0, surfaces_->count() - 1), surfaces_->count() - 1));
    surfaces_->setEnabled(!surfaces.empty());
    transfer_->setEnabled(surface() != nullptr);
    if (surface()) transfer_->setCurrentIndex(static_cast<int>(surface()->transfer));
  });
  connect(transfer_, &QComboBox::activated, this, [this](int index) {
    change_shown(tr("Set radiance transfer of %1"), no_merge,
                 [index](Surface& s) { s.transfer = static_cast<Surface::Transfer>(index); });
  });
  on_change(document_, Change::object, this, &MaterialPanel::show_object);
  on_change(document_, Change::scene, &reading_, &BackgroundJob::cancel);
  connect(&reading_, &BackgroundJob::failed, this, &MaterialPanel::refused);
  // After the list, which says what surface the fields are about.
  add_placement_fields(*form);
  add_copies_fields(*form);
  restore_->setText(QStringLiteral("↺"));
  restore_->setToolTip(tr("The material of the file again"));
  connect(restore_, &QToolButton::clicked, this,
          [this] { restore_material(document_, shown_material()); });
  connect(materials_, &QComboBox::activated, this, &MaterialPanel::refresh);
  on_refresh([this] { show_materials(); });
  QHBoxLayout* materials = row_of({materials_, restore_});
  form->addRow(tr("Material of file"), materials);
  on_refresh([this, form, materials] {
    form->setRowVisible(materials, surface() && surface()->imported);
    type_->setEnabled(material() != nullptr);
    if (material()) type_->setCurrentIndex(static_cast<int>(material()->type));
  });
  form->addRow(tr("Material"), type_);
  add_material_fields(*form);
  on_refresh([this] {
    // Keyframes are of a surface's own material, not of those of an imported file.
    if (!surface() || !surface()->imported) return;
    for (const char* key : {"reflectance_key", "specular_key", "exponent_key"}) {
      findChild<QToolButton*>(key)->setEnabled(false);
    }
  });
  transfer_->setToolTip(tr("Where light is scattered once; all orders shadow and reflect anyway"));
  form->addRow(tr("Radiance transfer"), transfer_);
  add_holdout(*form);
  show_length_units(*this, {"surface_position", "surface_size"});
  refresh();
}

void MaterialPanel::show_surface(std::size_t index) {
  surfaces_->setCurrentIndex(static_cast<int>(index));
}

// The panel has the first material of a chosen node.
void MaterialPanel::show_object() {
  const auto& object = document_.object();
  if (!object || object->kind != ObjectRef::Kind::surface) return;
  show_surface(object->index);
  if (!object->node || !surface() || !surface()->imported) return;
  const ImportedScene& scene = *surface()->imported;
  if (*object->node >= scene.nodes.size()) return;
  const auto parts = parts_below(scene, *object->node);
  if (parts.empty()) return;
  materials_->setCurrentText(QString::fromStdString(parts.front()->material.name));
  refresh();
}

void MaterialPanel::show_materials() {
  const QString shown = materials_->currentText();
  materials_->clear();
  if (!surface()) return;
  for (const std::string& name : material_names(*surface())) {
    materials_->addItem(QString::fromStdString(name));
  }
  materials_->setCurrentIndex(std::max(0, materials_->findText(shown)));
  restore_->setEnabled(is_changed(document_.scene(), shown_material()));
}

const Surface* MaterialPanel::surface() const {
  const Surfaces& surfaces = document_.scene().surfaces;
  const auto index = static_cast<std::size_t>(surfaces_->currentIndex());
  return surfaces_->currentIndex() >= 0 && index < surfaces.size() ? &surfaces[index] : nullptr;
}

MaterialRef MaterialPanel::shown_material() const {
  const bool is_imported = surface() && surface()->imported;
  return {static_cast<std::size_t>(surfaces_->currentIndex()),
          is_imported ? materials_->currentText().toStdString() : std::string()};
}

const Material* MaterialPanel::material() const {
  return surface() ? find_material(document_.scene(), shown_material()) : nullptr;
}

void MaterialPanel::change_shown(const QString& text, MergeId gesture,
                                 const std::function<void(Surface&)>& how) {
  if (!surface()) return;
  change_surface(document_, static_cast<std::size_t>(surfaces_->currentIndex()), text, gesture,
                 how);
}

void MaterialPanel::change(const QString& text, MergeId gesture,
                           const std::function<void(Material&)>& how) {
  change_material(document_, shown_material(), text, gesture, how);
}

// The entered angles stay while they give the surface's rotation: other angles may give it, too.
glm::dvec3 MaterialPanel::angles() const {
  return from_euler_angles(entered_angles_) == surface()->rotate
             ? entered_angles_
             : to_euler_angles(surface()->rotate);
}

KeyButton* MaterialPanel::new_surface_key(const QString& field, const char* name) {
  return new_key_button(field, [this, name](const Scene& scene) {
    return value_track<Surfaces>(scene, name,
                                 static_cast<std::size_t>(std::max(0, surfaces_->currentIndex())));
  });
}

void MaterialPanel::add_placement_fields(QFormLayout& form) {
  add_vector(form, tr("Position"),
             {"surface_position", domain::coordinate, 0.01,
              [this] { return value_if(surface(), &Surface::translate); },
              [this](const glm::dvec3& position, MergeId gesture) {
                change_shown(tr("Move %1"), gesture,
                             [position](Surface& s) { s.translate = position; });
              }},
             new_surface_key("surface_position", "translate"))
      ->setToolTip(tr("Where the origin of the mesh is"));
  add_vector(form, tr("Rotation"),
             {"surface_rotation", domain::degrees, 0.5,
              [this] { return value_if(surface(), [this](const Surface&) { return angles(); }); },
              [this](const glm::dvec3& degrees, MergeId gesture) {
                entered_angles_ = degrees;
                change_shown(tr("Rotate %1"), gesture,
                             [degrees](Surface& s) { s.rotate = from_euler_angles(degrees); });
              }},
             new_surface_key("surface_rotation", "rotate"))
      ->setToolTip(tr("Euler angles in degrees"));
  add_vector(form, tr("Size"),
             {"surface_size", domain::length, 0.01,
              [this]() -> std::optional<glm::dvec3> {
                return surface() && surface()->primitive ? std::optional(surface()->primitive->size)
                                                         : std::nullopt;
              },
              [this](const glm::dvec3& size, MergeId gesture) {
                change_shown(tr("Set size of %1"), gesture, [size](Surface& s) {
                  s.primitive->size = size;
                  s.mesh = mesh_of(*s.primitive);
                });
              }})
      ->setToolTip(tr("Extent of a box, a plane or another simple shape"));
  add_number(form, tr("Scale"),
             {"surface_scale", domain::length, ValueField::Scale::logarithmic, 0.01,
              [this] { return value_if(surface(), &Surface::scale); },
              [this](double scale, MergeId gesture) {
                change_shown(tr("Scale %1"), gesture, [scale](Surface& s) { s.scale = scale; });
              }},
             new_surface_key("surface_scale", "scale"))
      ->setToolTip(tr("Factor of the size of the mesh"));
}

// The outliner has the other values of surfaces that are true or false.
void MaterialPanel::add_holdout(QFormLayout& form) {
  visit_fields<Surface>([&](const auto& field) {
    if (field.info.name != std::string_view("holdout")) return;
    add_field(form, field,
              {.prefix = "surface_",
               .get = [this] { return surface(); },
               .set =
                   [this](const Surface& changed, const FieldInfo&, MergeId gesture) {
                     change_shown(tr("Set holdout of %1"), gesture,
                                  [&](Surface& s) { s.holdout = changed.holdout; });
                   },
               .track = {}});
  });
}

const Scatter* MaterialPanel::scatter() const {
  const bool is_scattered = surface() && surface()->copies && !surface()->copies->placements;
  return is_scattered ? &surface()->copies->scatter : nullptr;
}

// The list has the surfaces that copies can be scattered over: those with a name.
void MaterialPanel::add_copies_fields(QFormLayout& form) {
  copies_->setToolTip(tr("More placements of this surface, at random points of another one"));
  connect(copies_, &QComboBox::activated, this, [this](int index) {
    const std::string over = copies_->itemData(index).toString().toStdString();
    if (index > 0 && over.empty()) return;  // those of its file
    change_shown(tr("Scatter copies of %1"), no_merge, [&](Surface& s) {
      if (index == 0) {
        s.copies.reset();
      } else {
        if (!s.copies || s.copies->placements) s.copies = Copies();
        s.copies->scatter.over = over;
      }
    });
  });
  on_refresh([this] {
    const QSignalBlocker blocker(copies_);
    copies_->clear();
    copies_->addItem(tr("None"));
    copies_->setEnabled(surface() != nullptr);
    if (!surface()) return;
    for (const Surface& other : document_.scene().surfaces) {
      const QString name = QString::fromStdString(other.name);
      if (!name.isEmpty() && &other != surface() && copies_->findData(name) < 0) {
        copies_->addItem(tr("Scattered over %1").arg(name), name);
      }
    }
    if (!surface()->copies) return;
    const QString over = QString::fromStdString(surface()->copies->scatter.over);
    if (!scatter()) {
      copies_->addItem(
          tr("Of %1").arg(QString::fromStdString(surface()->copies->file.filename().string())));
    } else if (copies_->findData(over) < 0) {
      copies_->addItem(tr("Scattered over %1, which is missing").arg(over), over);
    }
    copies_->setCurrentIndex(scatter() ? copies_->findData(over) : copies_->count() - 1);
  });
  form.addRow(tr("Copies"), copies_);
  add_fields<Scatter>(
      form, {.prefix = "scatter_",
             .get = [this] { return scatter(); },
             .set =
                 [this](const Scatter& changed, const FieldInfo& info, MergeId gesture) {
                   change_shown(
                       tr("Set %1 of the copies of %2").arg(in_sentence(field_label(info)), "%1"),
                       gesture, [&](Surface& s) { s.copies->scatter = changed; });
                 },
             .track = {},
             .object = tr("Copies"),
             .ends = {tr("Copies scale, min"), tr("Copies scale, max")}});
}

void MaterialPanel::add_material_fields(QFormLayout& form) {
  add_color(form, tr("Reflectance"),
            {"reflectance",
             [this]() -> std::optional<glm::dvec3> {
               if (!material() || material()->type == Material::Type::measured ||
                   material()->type == Material::Type::metallic_roughness) {
                 return std::nullopt;
               }
               return material()->reflectance;
             },
             [this](const glm::dvec3& color, MergeId gesture) {
               change(tr("Set reflectance of %1"), gesture,
                      [color](Material& m) { m.reflectance = color; });
             }},
            new_surface_key("reflectance", "reflectance"));
  add_color(form, tr("Specular"),
            {"specular",
             [this]() -> std::optional<glm::dvec3> {
               if (!material() || material()->type != Material::Type::phong) return std::nullopt;
               return material()->specular;
             },
             [this](const glm::dvec3& color, MergeId gesture) {
               change(tr("Set specular reflectance of %1"), gesture,
                      [color](Material& m) { m.specular = color; });
             }},
            new_surface_key("specular", "specular"));
  add_number(form, tr("Exponent"),
             {"exponent", domain::not_negative, ValueField::Scale::logarithmic, 0.01,
              [this]() -> std::optional<double> {
                if (!material() || material()->type != Material::Type::phong) return std::nullopt;
                return material()->exponent;
              },
              [this](double value, MergeId gesture) {
                change(tr("Set exponent of %1"), gesture,
                       [value](Material& m) { m.exponent = value; });
              }},
             new_surface_key("exponent", "exponent"))
      ->setToolTip(tr("How sharp the highlight is"));
  auto* metallic_roughness = new MetallicRoughnessForm(
      document_, [this] { return shown_material(); }, this);
  connect(metallic_roughness, &MetallicRoughnessForm::refused, this, &MaterialPanel::refused);
  on_refresh([metallic_roughness] { metallic_roughness->show_current(); });
  form.addRow(metallic_roughness);
}

void MaterialPanel::choose_type(int index) {
  const auto type = static_cast<Material::Type>(index);
  if (type != Material::Type::measured) {
    set_type(shown_material(), type, {}, nullptr);
    return;
  }
  const std::filesystem::path file =
      ask_for_file(this, FileKind::material, tr("Choose a Measured Material"),
                   tr("MERL materials (*.binary);;All files (*)"), document_.folder());
  refresh();  // until it is read, the type is what it was
  if (!file.empty()) load_measured(file);
}

void MaterialPanel::load_measured(const std::filesystem::path& file) {
  reading_.start([this, file, shown = shown_material()](const Job&) {
    return [this, file, shown, measured = read_merl(file)] {
      set_type(shown, Material::Type::measured, file, measured);
    };
  });
}

void MaterialPanel::set_type(const MaterialRef& ref, Material::Type type,
                             const std::filesystem::path& file,
                             const std::shared_ptr<const MeasuredBrdf>& measured) {
  change_material(document_, ref, tr("Set material of %1"), no_merge, [&](Material& material) {
    if (type == Material::Type::metallic_roughness &&
        material.metallic_roughness == MetallicRoughness{}) {
      // It nearly keeps its looks, instead of glTF's white metal.
      material.metallic_roughness.base_color = material.reflectance;
      material.metallic_roughness.metallic = 0.0;
      material.metallic_roughness.roughness = 0.5;
    }
    material.type = type;
    material.file = file;
    material.measured = measured;
  });
}

}  // namespace brume
