#pragma once

#include "app/commands/objects/edit_materials.h"
#include "app/jobs/background_job.h"
#include "app/panels/forms/scene_form.h"
#include "brume/scene.h"

namespace brume {

// The values and textures of a metallic-roughness material.
class MetallicRoughnessForm : public SceneForm {
  Q_OBJECT
 public:
  // `shown`: the material that is shown, of any type.
  MetallicRoughnessForm(Document& document, std::function<MaterialRef()> shown, QWidget* parent);

  // Call when another material is shown.
  void show_current() { refresh(); }

  // Loads a texture in the background for the material that is shown now.
  using Slot = TextureReference MetallicRoughness::*;
  void load_texture(Slot slot, const std::filesystem::path& file);

 private:
  void add_values(QFormLayout& form);
  void add_alpha(QFormLayout& form);
  void add_texture(QFormLayout& form, const QString& title, const char* name, Slot slot);
  void ask_for_texture(Slot slot);
  [[nodiscard]] const MetallicRoughness* material() const;  // null: none
  void change(const QString& verb, MergeId gesture,
              const std::function<void(MetallicRoughness&)>& how);

  std::function<MaterialRef()> shown_;
  BackgroundJob reading_{BackgroundJob::Policy::latest_wins};
};

}  // namespace brume
