#include "app/panels/forms/metallic_roughness_form.h"

#include <QFormLayout>
#include <QHBoxLayout>
#include <QPushButton>
#include <QToolButton>

#include "app/document/document.h"
#include "app/files/file_dialogs.h"
#include "app/widgets/plain_text.h"
#include "core/io/image/texture_file.h"
#include "core/number_domain.h"

namespace brume {
namespace {

bool has_colors(MetallicRoughnessForm::Slot slot) {
  return slot == &MetallicRoughness::base_color_texture ||
         slot == &MetallicRoughness::emissive_texture;
}

}  // namespace

MetallicRoughnessForm::MetallicRoughnessForm(Document& document, Target target, QWidget* parent)
    : SceneForm(document, parent), target_(std::move(target)) {
  auto* form = new QFormLayout(this);
  form->setContentsMargins(0, 0, 0, 0);
  add_fields(*form);
  add_texture(*form, tr("Base color texture"), "base_color_texture",
              &MetallicRoughness::base_color_texture);
  add_texture(*form, tr("Roughness texture"), "metallic_roughness_texture",
              &MetallicRoughness::metallic_roughness_texture);
  add_texture(*form, tr("Normal map"), "normal_texture", &MetallicRoughness::normal_texture);
  add_texture(*form, tr("Emissive texture"), "emissive_texture",
              &MetallicRoughness::emissive_texture);
  on_refresh([this] { setVisible(material() != nullptr); });
  on_change(document_, brume::Change::scene, &reading_, &BackgroundJob::cancel);
  connect(&reading_, &BackgroundJob::failed, this, &MetallicRoughnessForm::refused);
  refresh();
}

const MetallicRoughness* MetallicRoughnessForm::material() const {
  const std::optional<std::size_t> index = target_.index();
  return index ? &document_.scene().surfaces[*index].material.metallic_roughness : nullptr;
}

void MetallicRoughnessForm::change(const QString& verb, MergeId gesture,
                                   const std::function<void(MetallicRoughness&)>& how) {
  const std::optional<std::size_t> index = target_.index();
  if (!index) return;
  target_.change(*index, verb, gesture,
                 [&](Surface& surface) { how(surface.material.metallic_roughness); });
}

void MetallicRoughnessForm::add_fields(QFormLayout& form) {
  const auto get = [this](auto value) {
    return [this, value]() {
      const MetallicRoughness* shown = material();
      return shown ? std::optional(shown->*value) : std::nullopt;
    };
  };
  const auto set = [this](auto value, const QString& verb) {
    return [this, value, verb](const auto& number, MergeId gesture) {
      change(verb, gesture, [&](MetallicRoughness& m) { m.*value = number; });
    };
  };
  const auto add_unit = [&](const QString& title, const char* name, const NumberDomain& domain,
                            double MetallicRoughness::*value, const QString& verb) {
    add_number(form, title,
               {name, domain, ValueField::Scale::linear, 0.01, get(value), set(value, verb)});
  };
  add_color(form, tr("Base color"),
            {"base_color", get(&MetallicRoughness::base_color),
             set(&MetallicRoughness::base_color, tr("Set base color of %1"))});
  add_unit(tr("Metallic"), "metallic", domain::unit, &MetallicRoughness::metallic,
           tr("Set metallic of %1"));
  add_unit(tr("Roughness"), "roughness", domain::unit, &MetallicRoughness::roughness,
           tr("Set roughness of %1"));
  add_vector(form, tr("Emissive"),
             {"emissive", domain::intensity, 0.01, get(&MetallicRoughness::emissive),
              set(&MetallicRoughness::emissive, tr("Set emissive of %1")), "rgb"});
  add_unit(tr("Normal scale"), "normal_scale", domain::normal_scale,
           &MetallicRoughness::normal_scale, tr("Set normal scale of %1"));
}

void MetallicRoughnessForm::add_texture(QFormLayout& form, const QString& title, const char* name,
                                        Slot slot) {
  auto* choose = new QPushButton(this);
  choose->setObjectName(name);
  auto* remove = new QToolButton(this);
  remove->setObjectName(QString(name) + "_remove");
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
    choose->setToolTip(!has_file           ? tr("PNG or JPEG; of colors also OpenEXR or HDR")
                       : !texture->content ? plain_tool_tip(tr("%1 is missing").arg(file))
                                           : plain_tool_tip(QString::fromStdString(texture->file)));
    remove->setEnabled(has_file);
  });
  auto* row = new QHBoxLayout;
  row->addWidget(choose, 1);
  row->addWidget(remove);
  form.addRow(title, row);
}

void MetallicRoughnessForm::ask_for_texture(Slot slot) {
  const QString filter =
      has_colors(slot) ? tr("Images (*.png *.jpg *.jpeg *.tga *.bmp *.exr *.hdr);;All files (*)")
                       : tr("Images (*.png *.jpg *.jpeg *.tga *.bmp);;All files (*)");
  const std::filesystem::path file =
      ask_for_file(this, FileKind::material, tr("Choose a texture"), filter, document_.folder());
  if (!file.empty()) load_texture(slot, file);
}

void MetallicRoughnessForm::load_texture(Slot slot, const std::filesystem::path& file) {
  const std::optional<std::size_t> index = target_.index();
  if (!index) return;
  reading_.start([this, slot, file, index = *index](const Job&) {
    std::vector<std::string> warnings;
    const auto content = read_texture(file, has_colors(slot), &warnings);
    return [this, slot, file, index, content, warnings] {
      for (const std::string& warning : warnings) Q_EMIT refused(QString::fromStdString(warning));
      target_.change(index, tr("Set texture of %1"), no_merge, [&](Surface& surface) {
        TextureReference& texture = surface.material.metallic_roughness.*slot;
        texture.file = file;
        texture.content = content;
      });
    };
  });
}

}  // namespace brume
