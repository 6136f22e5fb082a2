#pragma once

#include "app/jobs/background_job.h"
#include "app/panels/forms/scene_form.h"
#include "brume/scene.h"

namespace brume {

// A surface's metallic-roughness material: its values and textures.
class MetallicRoughnessForm : public SceneForm {
  Q_OBJECT
 public:
  using Change = std::function<void(Surface&)>;
  struct Target {
    // Index among the scene's surfaces of the one that is shown; nullopt: none of this material.
    std::function<std::optional<std::size_t>()> index;
    // `verb`: see change_surface().
    std::function<void(std::size_t index, const QString& verb, MergeId gesture, Change)> change;
  };
  MetallicRoughnessForm(Document& document, Target target, QWidget* parent);

  // Call when another surface is shown.
  void show_current() { refresh(); }

  // Loads a texture in the background for the surface that is shown now.
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

  Target target_;
  BackgroundJob reading_{BackgroundJob::Policy::latest_wins};
};

}  // namespace brume
