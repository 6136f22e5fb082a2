#pragma once

#include <QWidget>
#include <functional>
#include <glm/vec3.hpp>
#include <optional>

#include "app/commands/merge_id.h"

class QLabel;

namespace brume {

class ColorButton;
class ValueField;

// Edits an emission, RGB: its strength, colour or temperature.
class EmissionEditor : public QWidget {
  Q_OBJECT
 public:
  // `prefix`: of the widgets' object names.
  EmissionEditor(const QString& title, const QString& prefix, QWidget* parent = nullptr);

  // For the form that it is in.
  [[nodiscard]] QLabel* title() const { return title_; }
  // nullopt: disabled.
  void show_emission(const std::optional<glm::dvec3>& emission);

  using Change = std::function<void(glm::dvec3&)>;

 Q_SIGNALS:
  void edited(const brume::EmissionEditor::Change& change, brume::MergeId gesture);
  void refused(const QString& problem);

 private:
  ValueField* strength_;
  ColorButton* color_;
  ValueField* temperature_;
  QLabel* title_;
};

}  // namespace brume
