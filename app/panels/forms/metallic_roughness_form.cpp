#include "app/panels/forms/metallic_roughness_form.h"

#include <QComboBox>
#include <QFormLayout>
#include <QPushButton>
#include <QToolButton>
#include <string_view>

#include "app/document/document.h"
#include "app/document/text/words.h"
#include "app/files/file_dialogs.h"
#include "app/widgets/plain_text.h"
#include "app/widgets/rows.h"
#include "core/io/image/texture_file.h"
#include "core/scene/fields/material_fields.h"

namespace brume {
namespace {

bool has_colors(MetallicRoughnessForm::Slot slot) {
  return slot == &MetallicRoughness::base_color_texture ||
         slot == &MetallicRoughness::emissive_texture ||
         slot == &MetallicRoughness::transmission_texture;
}

}  // namespace

MetallicRoughnessForm::MetallicRoughnessForm(Document& document, std::function<MaterialRef()> shown,
                                             QWidget* parent)
    : SceneForm(document, parent), shown_(std::move(shown)) {
  auto* form = new_form(0);
  add_values(*form);
  add_alpha(*form);
  add_texture(*form, tr("Base colour texture"), "base_color_texture",
              &MetallicRoughness::base_color_texture);
  add_texture(*form, tr("Roughness texture"), "metallic_roughness_texture",
              &MetallicRoughness::metallic_roughness_texture);
  add_texture(*form, tr("Normal map"), "normal_texture", &MetallicRoughness::normal_texture);
  add_texture(*form, tr("Emissive texture"), "emissive_texture",
              &MetallicRoughness::emissive_texture);
  add_texture(*form, tr("Transmission texture"), "transmission_texture",
              &MetallicRoughness::transmission_texture);
  on_refresh([this] { setVisible(material() != nullptr); });
  on_change(document_, brume::Change::scene, &reading_, &BackgroundJob::cancel);
  connect(&reading_, &BackgroundJob::failed, this, &MetallicRoughnessForm::refused);
  refresh();
}

const MetallicRoughness* MetallicRoughnessForm::material() const {
  const Material* shown = find_material(document_.scene(), shown_());
  const bool is_there = shown && shown->type == Material::Type::metallic_roughness;
  return is_there ? &shown->metallic_roughness : nullptr;
}

void MetallicRoughnessForm::change(const QString& verb, MergeId gesture,
                                   const std::function<void(MetallicRoughness&)>& how) {
  change_material(document_, shown_(), verb, gesture,
                  [&](Material& m) { how(m.metallic_roughness); });
}

void MetallicRoughnessForm::add_values(QFormLayout& form) {
  const Fields<MetallicRoughness> values{
      .prefix = "",
      .get = [this] { return material(); },
      .set =
          [this](const MetallicRoughness& changed, const FieldInfo& info, MergeId gesture) {
            change(tr("Set %1 of %2").arg(in_sentence(field_label(info)), "%1"), gesture,
                   [&changed](MetallicRoughness& m) { m = changed; });
          },
      .track = {}};
  add_color(form, tr("Base colour"),
            {"base_color", [this] { return value_if(material(), &MetallicRoughness::base_color); },
             [this](const glm::dvec3& color, MergeId gesture) {
               change(tr("Set base colour of %1"), gesture,
                      [&color](MetallicRoughness& m) { m.base_color = color; });
             }});
  visit_fields<MetallicRoughness>([&](const auto& field) {
    if (std::string_view(field.info.name) != "base_color") add_field(form, field, values);
  });
}

void MetallicRoughnessForm::add_alpha(QFormLayout& form) {
  auto* alpha = named(new QComboBox(this), "alpha");
  alpha->addItems({tr("Opaque"), tr("Cutout"), tr("Blend")});
  alpha->setToolTip(tr("Whether opacity makes holes in the surface, or covers a share of it"));
  connect(alpha, &QComboBox::activated, this, [this](int index) {
    change(tr("Set alpha of %1"), no_merge,
           [index](MetallicRoughness& m) { m.alpha = static_cast<AlphaMode>(index); });
  });
  on_refresh([this, alpha] {
    if (material()) alpha->setCurrentIndex(static_cast<int>(material()->alpha));
  });
  form.addRow(tr("Alpha"), alpha);
}

void MetallicRoughnessForm::add_texture(QFormLayout& form, const QString& title, const char* name,
                                        Slot slot) {
  auto* choose = named(new QPushButton(this), name);
  auto* remove = named(new QToolButton(this), QString(name) + "_remove");
  remove->setText(QStringLiteral("×"));
  remove->setToolTip(tr("Remove the texture"));
  connect(choose, &QPushButton::clicked, this, [this, slot] { ask_for_texture(slot); });
  connect(remove, &QToolButton::clicked, this, [this, slot] {
    change(tr("Remove texture of %1"), no_merge, [slot](MetallicRoughness& m) { m.*slot = {}; });
  });
  on_refresh([this, choose, remove, slot] {
    const TextureReference* texture = material() ? &(material()->*slot) : nullptr;
    const bool has_file = texture && !texture->file.empty();
    const QString file = has_file ? QString::fromStdString(texture->file.filename()) : QString();
    choose->setText(has_file ? QString(file).replace('&', "&&") : tr("Choose…"));
    choose->setToolTip(!has_file           ? tr("PNG or JPEG; of colours also OpenEXR or HDR")
                       : !texture->content ? plain_tool_tip(tr("%1 is missing").arg(file))
                                           : plain_tool_tip(QString::fromStdString(texture->file)));
    remove->setEnabled(has_file);
  });
  form.addRow(title, row_of({choose, remove}));
}

void MetallicRoughnessForm::ask_for_texture(Slot slot) {
  const QString filter =
      has_colors(slot) ? tr("Images (*.png *.jpg *.jpeg *.tga *.bmp *.exr *.hdr);;All files (*)")
                       : tr("Images (*.png *.jpg *.jpeg *.tga *.bmp);;All files (*)");
  const std::filesystem::path file =
      ask_for_file(this, FileKind::material, tr("Choose a Texture"), filter, document_.folder());
  if (!file.empty()) load_texture(slot, file);
}

void MetallicRoughnessForm::load_texture(Slot slot, const std::filesystem::path& file) {
  reading_.start([this, slot, file, shown = shown_()](const Job&) {
    std::vector<std::string> warnings;
    const auto content = read_texture(file, has_colors(slot), &warnings);
    return [this, slot, file, shown, content, warnings] {
      for (const std::string& warning : warnings) Q_EMIT refused(QString::fromStdString(warning));
      change_material(document_, shown, tr("Set texture of %1"), no_merge, [&](Material& m) {
        TextureReference& texture = m.metallic_roughness.*slot;
        texture.file = file;
        texture.content = content;
        texture.uses_second_texcoords = false;
      });
    };
  });
}

}  // namespace brume
