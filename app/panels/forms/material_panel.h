#pragma once

#include "app/commands/objects/edit_materials.h"
#include "app/jobs/background_job.h"
#include "app/panels/forms/scene_form.h"
#include "brume/scene.h"

class QComboBox;
class QToolButton;

namespace brume {

// Placement, material and radiance transfer of a surface.
class MaterialPanel : public SceneForm {
  Q_OBJECT
 public:
  MaterialPanel(Document& document, QWidget* parent);

  void show_surface(std::size_t index);
  // Loads a measured material in the background for the one that is shown now.
  void load_measured(const std::filesystem::path& file);

 private:
  // The button for keyframes of a value of the surface, by its name in files.
  KeyButton* new_surface_key(const QString& field, const char* name);
  void add_placement_fields(QFormLayout& form);
  void add_holdout(QFormLayout& form);
  void add_copies_fields(QFormLayout& form);
  void add_material_fields(QFormLayout& form);
  void show_materials();
  void show_object();  // that of the document, if it is a surface
  void choose_type(int type);
  void set_type(const MaterialRef& ref, Material::Type type, const std::filesystem::path& file,
                const std::shared_ptr<const MeasuredBrdf>& measured);
  void change_shown(const QString& text, MergeId gesture, const std::function<void(Surface&)>& how);
  void change(const QString& text, MergeId gesture, const std::function<void(Material&)>& how);
  [[nodiscard]] const Surface* surface() const;  // the current one; may be null
  [[nodiscard]] MaterialRef shown_material() const;
  [[nodiscard]] const Material* material() const;  // that; may be null
  [[nodiscard]] const Scatter* scatter() const;    // null: its copies are not scattered

  [[nodiscard]] glm::dvec3 angles() const;  // of its rotation [degrees]

  glm::dvec3 entered_angles_{0.0};
  QComboBox* surfaces_;
  QComboBox* materials_;  // of an imported scene
  QToolButton* restore_;
  QComboBox* type_;
  QComboBox* transfer_;
  QComboBox* copies_;
  BackgroundJob reading_{BackgroundJob::Policy::latest_wins};
};

}  // namespace brume
