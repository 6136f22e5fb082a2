#include "app/panels/material_panel.h"

#include <QComboBox>
#include <QFormLayout>
#include <algorithm>

#include "app/commands/scene_part_command.h"
#include "app/document/document.h"
#include "app/document/paths.h"
#include "app/files/file_dialogs.h"
#include "core/io/merl_file.h"

namespace brume {

MaterialPanel::MaterialPanel(Document& document, QWidget* parent)
    : SceneForm(document, parent),
      surfaces_(new QComboBox(this)),
      type_(new QComboBox(this)),
      transfer_(new QComboBox(this)) {
  surfaces_->setObjectName("surface");
  type_->setObjectName("material_type");
  type_->addItems({tr("Diffuse"), tr("Phong"), tr("Measured…")});
  transfer_->setObjectName("transfer");
  transfer_->addItems({tr("None"), tr("Shadows"), tr("Shadows and interreflection")});
  transfer_->setToolTip(
      tr("Precomputed self-shadowing and interreflection within the object, of the environment and "
         "of light scattered by fog"));
  auto* form = new QFormLayout(this);
  form->setContentsMargins(6, 6, 6, 6);
  form->addRow(tr("Surface"), surfaces_);
  form->addRow(tr("Material"), type_);
  connect(surfaces_, &QComboBox::currentIndexChanged, this, &MaterialPanel::refresh);
  connect(type_, &QComboBox::activated, this, &MaterialPanel::choose_type);
  on_refresh([this] {
    const Surfaces& surfaces = document_.scene().surfaces;
    const QSignalBlocker blocker(surfaces_);
    const int index = surfaces_->currentIndex();
    surfaces_->clear();
    for (const Surface& surface : surfaces) {
      surfaces_->addItem(to_qstring(surface.mesh_file.filename()));
    }
    surfaces_->setCurrentIndex(
        std::clamp(index, std::min(0, surfaces_->count() - 1), surfaces_->count() - 1));
    surfaces_->setEnabled(!surfaces.empty());
    type_->setEnabled(material() != nullptr);
    if (material()) type_->setCurrentIndex(static_cast<int>(material()->type));
    transfer_->setEnabled(surface() != nullptr);
    if (surface()) transfer_->setCurrentIndex(static_cast<int>(surface()->transfer));
  });
  connect(transfer_, &QComboBox::activated, this, [this](int index) {
    change_surface(tr("Set radiance transfer of %1"), no_merge,
                   [index](Surface& s) { s.transfer = static_cast<Surface::Transfer>(index); });
  });
  connect(&document_, &Document::scene_replaced, &reading_, &BackgroundJob::cancel);
  connect(&reading_, &BackgroundJob::failed, this, &MaterialPanel::refused);
  // After the list, which says what surface the fields are about.
  add_fields(*form);
  transfer_->setToolTip(tr("Where light is scattered once; all orders shadow and reflect anyway"));
  form->addRow(tr("Radiance transfer"), transfer_);
  refresh();
}

void MaterialPanel::show_surface(std::size_t index) {
  surfaces_->setCurrentIndex(static_cast<int>(index));
}

const Surface* MaterialPanel::surface() const {
  const Surfaces& surfaces = document_.scene().surfaces;
  const auto index = static_cast<std::size_t>(surfaces_->currentIndex());
  return surfaces_->currentIndex() >= 0 && index < surfaces.size() ? &surfaces[index] : nullptr;
}

const Material* MaterialPanel::material() const {
  return surface() ? &surface()->material : nullptr;
}

void MaterialPanel::change(const QString& text, MergeId gesture,
                           const std::function<void(Material&)>& how) {
  change_surface(text, gesture, [&](Surface& s) { how(s.material); });
}

void MaterialPanel::change_surface(const QString& text, MergeId gesture,
                                   const std::function<void(Surface&)>& how) {
  if (!surface()) return;
  Surfaces surfaces = document_.scene().surfaces;
  how(surfaces[static_cast<std::size_t>(surfaces_->currentIndex())]);
  set_scene_part(document_, std::move(surfaces), text.arg(surfaces_->currentText()), gesture);
}

void MaterialPanel::add_fields(QFormLayout& form) {
  add_color(form, tr("Reflectance"),
            {"reflectance",
             [this]() -> std::optional<glm::dvec3> {
               if (!material() || material()->type == Material::Type::measured) return std::nullopt;
               return material()->reflectance;
             },
             [this](const glm::dvec3& color, MergeId gesture) {
               change(tr("Set reflectance of %1"), gesture,
                      [color](Material& m) { m.reflectance = color; });
             }});
  add_color(form, tr("Specular"),
            {"specular",
             [this]() -> std::optional<glm::dvec3> {
               if (!material() || material()->type != Material::Type::phong) return std::nullopt;
               return material()->specular;
             },
             [this](const glm::dvec3& color, MergeId gesture) {
               change(tr("Set specular reflectance of %1"), gesture,
                      [color](Material& m) { m.specular = color; });
             }});
  add_number(form, tr("Exponent"),
             {"exponent", domain::not_negative, ValueField::Scale::logarithmic, 0.01,
              [this]() -> std::optional<double> {
                if (!material() || material()->type != Material::Type::phong) return std::nullopt;
                return material()->exponent;
              },
              [this](double value, MergeId gesture) {
                change(tr("Set exponent of %1"), gesture,
                       [value](Material& m) { m.exponent = value; });
              }});
}

void MaterialPanel::choose_type(int index) {
  const auto type = static_cast<Material::Type>(index);
  if (type != Material::Type::measured) {
    set_type(surfaces_->currentIndex(), type, {}, nullptr);
    return;
  }
  const std::filesystem::path file =
      ask_for_file(this, FileKind::material, tr("Choose a measured material"),
                   tr("MERL materials (*.binary);;All files (*)"), document_.folder());
  refresh();  // until it is read, the type is what it was
  if (!file.empty()) load_measured(file);
}

void MaterialPanel::load_measured(const std::filesystem::path& file) {
  reading_.start([this, file, index = surfaces_->currentIndex()](const Job&) {
    return [this, file, index, measured = read_merl(file)] {
      set_type(index, Material::Type::measured, file, measured);
    };
  });
}

void MaterialPanel::set_type(int index, Material::Type type, const std::filesystem::path& file,
                             const std::shared_ptr<const MeasuredBrdf>& measured) {
  Surfaces surfaces = document_.scene().surfaces;
  if (index < 0 || static_cast<std::size_t>(index) >= surfaces.size()) return;
  Material& material = surfaces[static_cast<std::size_t>(index)].material;
  material.type = type;
  material.file = file;
  material.measured = measured;
  set_scene_part(document_, std::move(surfaces),
                 tr("Set material of %1").arg(surfaces_->itemText(index)));
}

}  // namespace brume
