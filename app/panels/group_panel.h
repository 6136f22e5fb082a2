#pragma once

#include "app/panels/scene_form.h"
#include "brume/group.h"
#include "core/number_domain.h"

class QComboBox;
class QFormLayout;

namespace brume {

// What the active group makes of its Gaussians, and its colour.
class GroupPanel : public SceneForm {
  Q_OBJECT
 public:
  GroupPanel(Document& document, QWidget* parent);

 private:
  void show_groups();
  void add_numbers(QFormLayout& form, const QString& title, const QString& unit, const char* factor,
                   const char* offset, const NumberDomain& factor_domain,
                   double Group::*factor_value, double Group::*offset_value);
  void add_albedo(QFormLayout& form);
  void change(const QString& verb, MergeId gesture, const std::function<void(Group&)>& how);

  QComboBox* groups_;
};

}  // namespace brume
