#pragma once

#include <filesystem>

#include "app/commands/objects/edit_lights.h"
#include "app/jobs/background_job.h"
#include "app/panels/forms/scene_form.h"
#include "brume/scene.h"

class QLabel;
class QListWidget;

namespace brume {

class View;

// List of lights, parameters of the active one, and below them the environment.
class LightPanel : public SceneForm {
  Q_OBJECT
 public:
  // `active_view`: where lights are added.
  LightPanel(Document& document, std::function<const View&()> active_view, QWidget* parent);

  // Adds a light above what the active view looks at.
  void add(const Light::Kind& kind);

  // Gives the active light, a point light or a spot, a photometric profile; read in the background.
  void load_profile(const std::filesystem::path& file);
  // Puts a picture into the beam of the active light, a spot, in the same way.
  void load_texture(const std::filesystem::path& file);

 private:
  void add_light_list(QFormLayout& form);
  void add_light_fields(QFormLayout& form);
  void add_photometric_fields(QFormLayout& form);
  void add_type_field(QFormLayout& form);
  void add_strength_field(QFormLayout& form);
  // A file that a light may have, which is chosen and removed; `of`: that of a light, or null where
  // it has none.
  struct LightFile {
    const char* name;
    QString label, says;
    std::function<bool(const Light&)> may_have;
    std::function<const std::filesystem::path*(const Light&)> of;
    std::function<std::filesystem::path()> ask;
    std::function<void(const std::filesystem::path&)> load;
    std::function<void(Light&)> remove;
  };
  void add_file_field(QFormLayout& form, const LightFile& file);
  void add_profile_field(QFormLayout& form);
  void add_texture_field(QFormLayout& form);
  // Reads a file in the background, then changes the light that was active if it may have it.
  template <class Read, class Set>
  void load_file(const std::filesystem::path& file, const QString& text, Read read, Set set);
  // A row for a value that several kinds may have.
  template <class F>
  void add_value(QFormLayout& form, const F& field);
  void set_value(Light light, const FieldInfo& info, MergeId gesture);
  void change(const QString& text, MergeId gesture, const std::function<void(Light&)>& how);
  void show_lights();
  [[nodiscard]] LightPlace place() const;
  void show_last();
  [[nodiscard]] const Light* light() const;  // the active one; may be null

  std::function<const View&()> active_view_;
  QListWidget* list_;
  bool showing_ = false;
  BackgroundJob reading_{BackgroundJob::Policy::latest_wins};
};

}  // namespace brume
