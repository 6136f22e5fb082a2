#pragma once

#include <QWidget>
#include <functional>
#include <glm/vec3.hpp>
#include <optional>
#include <vector>

#include "app/panels/value_field.h"

class QFormLayout;
class QHBoxLayout;

namespace brume {

class ColorButton;
class Document;

// Fields that show numbers and colours of the scene and edit them. Each has a way to read its value
// (nullopt: there is none, and the field is disabled) and a way to set it, by a command that merges
// within one gesture.
class SceneForm : public QWidget {
  Q_OBJECT
 public:
  SceneForm(Document& document, QWidget* parent);

 Q_SIGNALS:
  void refused(const QString& problem);

 protected:
  struct Number {
    const char* name;  // of the widget
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
    const char* parts = "xyz";  // a letter for each field
  };
  struct Color {
    const char* name;
    std::function<std::optional<glm::dvec3>()> get;
    std::function<void(const glm::dvec3&, MergeId)> set;
  };
  void add_number(QFormLayout& form, const QString& title, const Number& number);
  void add_vector(QFormLayout& form, const QString& title, const Vector& vector);  // three fields
  void add_color(QFormLayout& form, const QString& title, const Color& color);

  // After what else decides on the values, such as which light is meant.
  void refresh();
  // Calls `update` at every refresh().
  void on_refresh(std::function<void()> update) { updates_.push_back(std::move(update)); }

  Document& document_;

 private:
  ValueField* new_field(const Number& number, const QString& title);

  std::vector<std::function<void()>> updates_;
};

}  // namespace brume
