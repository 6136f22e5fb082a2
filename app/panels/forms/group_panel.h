#pragma once

#include "app/panels/forms/scene_form.h"
#include "brume/group.h"

class QComboBox;
class QFormLayout;

namespace brume {

// The active group's effect on its Gaussians, and its colour.
class GroupPanel : public SceneForm {
  Q_OBJECT
 public:
  GroupPanel(Document& document, QWidget* parent);

 private:
  void show_groups();
  void change(const QString& verb, MergeId gesture, const std::function<void(Group&)>& how);

  QComboBox* groups_;
};

}  // namespace brume
