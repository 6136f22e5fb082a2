#pragma once

#include "app/file_reader.h"
#include "app/panels/scene_form.h"
#include "core/scene/scene.h"

class QComboBox;

namespace brume {

// What a surface is made of, and whether it shadows and lights itself.
class MaterialPanel : public SceneForm {
  Q_OBJECT
 public:
  MaterialPanel(Document& document, QWidget* parent);

  void show_surface(std::size_t index);
  // Reads a measured material in the background; the surface shown now becomes of it.
  void load_measured(const std::filesystem::path& file);

 private:
  void add_fields(QFormLayout& form);
  void choose_type(int type);
  void set_type(int index, Material::Type type, const std::filesystem::path& file,
                const std::shared_ptr<const MeasuredBrdf>& measured);
  void change_surface(const QString& text, MergeId gesture,
                      const std::function<void(Surface&)>& how);
  void change(const QString& text, MergeId gesture, const std::function<void(Material&)>& how);
  [[nodiscard]] const Surface* surface() const;    // the one shown; nullptr if none
  [[nodiscard]] const Material* material() const;  // its

  QComboBox* surfaces_;
  QComboBox* type_;
  QComboBox* transfer_;
  FileReader<std::shared_ptr<const MeasuredBrdf>> reader_;
};

}  // namespace brume
