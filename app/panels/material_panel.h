#pragma once

#include "app/panels/scene_form.h"

class QComboBox;

namespace brume {

struct Material;

// What a surface is made of.
class MaterialPanel : public SceneForm {
  Q_OBJECT
 public:
  MaterialPanel(Document& document, QWidget* parent);

  void show_surface(std::size_t index);

 private:
  void add_fields(QFormLayout& form);
  void choose_type(int type);
  void change(const QString& text, MergeId gesture, const std::function<void(Material&)>& how);
  [[nodiscard]] const Material* material() const;  // of the surface shown; nullptr if none

  QComboBox* surfaces_;
  QComboBox* type_;
};

}  // namespace brume
