#pragma once

#include "app/panels/forms/scene_form.h"
#include "render/settings.h"

class QComboBox;
class QFormLayout;
class QPushButton;

namespace brume {

struct MediumOptics;

// Global parameters of the medium: homogeneous density, scattering, noise. Which orders of
// scattering are rendered is a setting of the views beside them, not part of the scene.
class MediumPanel : public SceneForm {
  Q_OBJECT
 public:
  // `scattering`: unless another one was chosen in an earlier session.
  MediumPanel(Document& document, Scattering scattering, QWidget* parent);

  // The scattering chosen here, kept for the next session.
  [[nodiscard]] Scattering scattering() const;

 Q_SIGNALS:
  void scattering_changed(brume::Scattering scattering);

 private:
  void change_optics(const QString& text, MergeId gesture,
                     const std::function<void(MediumOptics&)>& change);
  // Adds a check box and, for fog that is not endless, its extent.
  void add_endless(QFormLayout& form);
  QPushButton* new_presets();
  void fill_scattering(Scattering scattering);

  QComboBox* scattering_;
};

}  // namespace brume
