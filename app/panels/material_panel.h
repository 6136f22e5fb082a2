#pragma once

#include "app/panels/scene_form.h"

class QComboBox;

namespace brume {

struct Material;
struct Surface;

// What a surface is made of, and whether it shadows and lights itself.
class MaterialPanel : public SceneForm {
  Q_OBJECT
 public:
  MaterialPanel(Document& document, QWidget* parent);

  void show_surface(std::size_t index);

 private:
  void add_fields(QFormLayout& form);
  void choose_type(int type);
  void change_surface(const QString& text, MergeId gesture,
                      const std::function<void(Surface&)>& how);
  void change(const QString& text, MergeId gesture, const std::function<void(Material&)>& how);
  [[nodiscard]] const Surface* surface() const;    // the one shown; nullptr if none
  [[nodiscard]] const Material* material() const;  // its

  QComboBox* surfaces_;
  QComboBox* type_;
  QComboBox* transfer_;
};

}  // namespace brume
