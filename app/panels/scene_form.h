#pragma once

#include <QWidget>
#include <functional>
#include <glm/vec3.hpp>
#include <optional>
#include <vector>

#include "app/widgets/value_field.h"
#include "core/number_domain.h"

class QFormLayout;
class QLabel;
class QHBoxLayout;

namespace brume {

class ColorButton;
class Document;

// Base of panels with numbers and colours of the scene. Each field has a getter (nullopt: disabled)
// and a setter, a command that merges within a gesture.
class SceneForm : public QWidget {
  Q_OBJECT
 public:
  SceneForm(Document& document, QWidget* parent);

 Q_SIGNALS:
  void refused(const QString& problem);

 protected:
  struct Number {
    const char* name;  // object name of the widget
    NumberDomain domain;
    ValueField::Scale scale;
    double step;
    std::function<std::optional<double>()> get;
    std::function<void(double, MergeId)> set;
  };
  struct Vector {
    const char* name;
    NumberDomain domain;
    double step;
    std::function<std::optional<glm::dvec3>()> get;
    std::function<void(const glm::dvec3&, MergeId)> set;
    const char* parts = "xyz";  // component letters
  };
  struct Color {
    const char* name;
    std::function<std::optional<glm::dvec3>()> get;
    std::function<void(const glm::dvec3&, MergeId)> set;
  };
  // Returns its title.
  QLabel* add_number(QFormLayout& form, const QString& title, const Number& number);
  void add_vector(QFormLayout& form, const QString& title, const Vector& vector);  // three fields
  void add_color(QFormLayout& form, const QString& title, const Color& color);

  // Call when other state that affects the values changes, such as the active light.
  void refresh();
  // Calls `update` at every refresh().
  void on_refresh(std::function<void()> update) { updates_.push_back(std::move(update)); }

  Document& document_;

 private:
  ValueField* new_field(const Number& number, const QString& title);

  std::vector<std::function<void()>> updates_;
};

}  // namespace brume
