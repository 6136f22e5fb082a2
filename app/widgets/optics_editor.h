#pragma once

#include <QObject>
#include <functional>
#include <optional>

#include "app/commands/merge_id.h"
#include "brume/gaussian.h"

class QCheckBox;
class QFormLayout;
class QWidget;

namespace brume {

class ColorButton;
class EmissionEditor;

// Rows of a form that edit the optics of a Gaussian, or of many: whether they have an albedo of
// their own, its colour, and their emission.
class OpticsEditor : public QObject {
  Q_OBJECT
 public:
  // Adds them to the form of a widget. `prefix`: of the widgets' object names.
  OpticsEditor(QFormLayout& form, const QString& emission_title, const QString& prefix,
               QWidget* parent);

  // nullopt: disabled. `medium_albedo`: what those without their own have.
  void show_optics(const std::optional<GaussianOptics>& optics, const glm::dvec3& medium_albedo);

  using Change = std::function<void(GaussianOptics&)>;

 Q_SIGNALS:
  void edited(const brume::OpticsEditor::Change& change, brume::MergeId gesture);
  void refused(const QString& problem);

 private:
  QCheckBox* has_albedo_;
  ColorButton* albedo_;
  EmissionEditor* emission_;
  glm::dvec3 medium_albedo_{1.0};
};

}  // namespace brume
