#pragma once

#include <QWidget>
#include <functional>
#include <glm/vec3.hpp>
#include <optional>
#include <string_view>
#include <vector>

#include "app/document/keyframe_tracks.h"
#include "app/widgets/value_field.h"
#include "core/number_domain.h"
#include "core/scene/fields/field.h"

class QFormLayout;
class QLabel;
class QHBoxLayout;

namespace brume {

class ColorButton;
class Document;
class KeyButton;

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
    QString name;  // object name of the widget
    NumberDomain domain;
    ValueField::Scale scale;
    double step;
    std::function<std::optional<double>()> get;
    std::function<void(double, MergeId)> set;
  };
  struct Vector {
    QString name;
    NumberDomain domain;
    double step;
    std::function<std::optional<glm::dvec3>()> get;
    std::function<void(const glm::dvec3&, MergeId)> set;
    const char* parts = "xyz";  // component letters
  };
  struct Toggle {
    QString name;
    std::function<std::optional<bool>()> get;
    std::function<void(bool, MergeId)> set;
  };
  struct Color {
    const char* name;
    std::function<std::optional<glm::dvec3>()> get;
    std::function<void(const glm::dvec3&, MergeId)> set;
  };
  // Return the title. `keys`: a button at the end of the row.
  QLabel* add_number(QFormLayout& form, const QString& title, const Number& number,
                     KeyButton* keys = nullptr);
  QLabel* add_vector(QFormLayout& form, const QString& title, const Vector& vector,  // three fields
                     KeyButton* keys = nullptr);
  void add_color(QFormLayout& form, const QString& title, const Color& color);
  QWidget* add_toggle(QFormLayout& form, const QString& title, const Toggle& toggle);

  // An object with values that core/scene/fields describes.
  template <class Owner>
  struct Fields {
    QString prefix;                     // of the object names of their widgets
    std::function<const Owner*()> get;  // nullptr: there is none
    std::function<void(const Owner&, const FieldInfo&, MergeId)> set;
    std::function<Track(const Scene&, const FieldInfo&)> track;
  };
  // A row for one of them: label, unit, tool tip, and a button for keyframes if it can have any.
  template <class F>
  void add_field(QFormLayout& form, const F& field, const Fields<typename F::Owner>& fields);

  // Call when other state that affects the values changes, such as the active light.
  void refresh();
  // Calls `update` at every refresh().
  void on_refresh(std::function<void()> update) { updates_.push_back(std::move(update)); }
  KeyButton* new_key_button(const QString& name, std::function<Track(const Scene&)> track);

  Document& document_;

 private:
  ValueField* new_field(const Number& number, const QString& title);
  void add_keys(QHBoxLayout& row, KeyButton* keys, std::function<bool()> is_there);
  void finish_field(const FieldInfo& info, const QString& name, QWidget& title);

  std::vector<std::function<void()>> updates_;
};

// A text of core/scene/fields, translated; and the name of a value in a form and in undo texts.
QString fields_text(const char* text);
QString field_label(const FieldInfo& info);

template <class F>
void SceneForm::add_field(QFormLayout& form, const F& field,
                          const Fields<typename F::Owner>& fields) {
  const FieldInfo& info = field.info;
  const QString name = fields.prefix + info.name;
  const auto get = [get_owner = fields.get, field] {
    const typename F::Owner* owner = get_owner();
    using Got = decltype(std::optional(field.of(*owner)));
    const bool is_there = owner && !replacement(field, *owner);
    return is_there ? std::optional(field.of(*owner)) : Got();
  };
  const auto set = [fields, field](const auto& value, MergeId gesture) {
    typename F::Owner changed = *fields.get();
    field.of(changed) = value;
    fields.set(changed, field.info, gesture);
  };
  KeyButton* keys = nullptr;
  if constexpr (F::can_have_keys) {
    keys = new_key_button(
        name, [track = fields.track, info](const Scene& scene) { return track(scene, info); });
  }
  if constexpr (std::is_same_v<typename F::Value, glm::dvec3>) {
    finish_field(info, name,
                 *add_vector(form, field_label(info),
                             {name, field.domain, info.step, get, set,
                              std::string_view(info.unit) == "RGB" ? "RGB" : "xyz"},
                             keys));
  } else if constexpr (std::is_same_v<typename F::Value, bool>) {
    finish_field(info, name, *add_toggle(form, field_label(info), {name, get, set}));
  } else {
    const QString unit = *info.unit ? QString(", ") + info.unit : QString();
    const auto scale =
        info.is_logarithmic ? ValueField::Scale::logarithmic : ValueField::Scale::linear;
    finish_field(info, name,
                 *add_number(form, field_label(info) + unit,
                             {name, field.domain, scale, info.step, get, set}, keys));
  }
}

}  // namespace brume
