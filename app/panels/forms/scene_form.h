#pragma once

#include <QWidget>
#include <cmath>
#include <functional>
#include <glm/vec3.hpp>
#include <optional>
#include <string_view>
#include <vector>

#include "app/document/time/keyframe_tracks.h"
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
  // Becomes the layout of this widget.
  QFormLayout* new_form(int margin = 6);
  // Return the title. `keys`: a button at the end of the row.
  QLabel* add_number(QFormLayout& form, const QString& title, const Number& number,
                     KeyButton* keys = nullptr);
  QLabel* add_vector(QFormLayout& form, const QString& title, const Vector& vector,  // three fields
                     KeyButton* keys = nullptr);
  void add_color(QFormLayout& form, const QString& title, const Color& color,
                 KeyButton* keys = nullptr);
  QWidget* add_toggle(QFormLayout& form, const QString& title, const Toggle& toggle);

  // An object with values that core/scene/fields describes.
  template <class Owner>
  struct Fields {
    QString prefix;                     // of the object names of their widgets
    std::function<const Owner*()> get;  // nullptr: there is none
    std::function<void(const Owner&, const FieldInfo&, MergeId)> set;
    std::function<Track(const Scene&, const FieldInfo&)> track;  // empty: without keyframes
    QString object = {};  // before the labels, which then say whose value it is: "Noise frequency"
    QStringList ends = {};  // labels of the two numbers of a range; empty: at birth and at death
  };
  // A row for one of them: label, unit, tool tip, and a button for keyframes if it can have any.
  template <class F>
  void add_field(QFormLayout& form, const F& field, const Fields<typename F::Owner>& fields);
  // Rows for all of them.
  template <class Owner>
  void add_fields(QFormLayout& form, const Fields<Owner>& fields) {
    visit_fields<Owner>([&](const auto& field) { add_field(form, field, fields); });
  }

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

// A value of an object; nullopt if there is none. `value_of`: a member or a function.
template <class Owner, class Get>
auto value_if(const Owner* owner, Get value_of) {
  using Value = std::remove_cvref_t<std::invoke_result_t<Get, const Owner&>>;
  return owner ? std::optional<Value>(std::invoke(value_of, *owner)) : std::nullopt;
}

// A text of core/scene/fields, translated; and the name of a value in a form and in undo texts.
QString fields_text(const char* text);
QString field_label(const FieldInfo& info);
QString object_label(const QString& object, const QString& label);  // "Noise frequency"
QString at_birth(const QString& label);                             // "Radius at birth"
QString at_death();

template <class F>
void SceneForm::add_field(QFormLayout& form, const F& field,
                          const Fields<typename F::Owner>& fields) {
  using Value = typename F::Value;
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
    field.of(changed) = static_cast<Value>(value);
    fields.set(changed, field.info, gesture);
  };
  KeyButton* keys = nullptr;
  if (F::can_have_keys && fields.track) {
    keys = new_key_button(
        name, [track = fields.track, info](const Scene& scene) { return track(scene, info); });
  }
  const QString label = object_label(fields.object, field_label(info));
  const QString title = *info.unit ? label + ", " + fields_text(info.unit) : label;
  const auto scale =
      info.is_logarithmic ? ValueField::Scale::logarithmic : ValueField::Scale::linear;
  if constexpr (std::is_same_v<Value, glm::dvec3>) {
    finish_field(info, name,
                 *add_vector(form, label,
                             {name, field.domain, info.step, get, set,
                              std::string_view(info.unit) == "RGB" ? "RGB" : "xyz"},
                             keys));
  } else if constexpr (std::is_same_v<Value, glm::dvec2>) {
    // Values at birth and at death.
    const auto add_end = [&](int k, const QString& end, const QString& text, KeyButton* button) {
      const auto get_end = [get, k]() -> std::optional<double> {
        const auto both = get();
        return both ? std::optional((*both)[k]) : std::nullopt;
      };
      const auto set_end = [get, set, k](double value, MergeId gesture) {
        glm::dvec2 both = *get();
        both[k] = value;
        set(both, gesture);
      };
      finish_field(
          info, name + end,
          *add_number(form, text, {name + end, field.domain, scale, info.step, get_end, set_end},
                      button));
    };
    add_end(0, "_birth", fields.ends.isEmpty() ? at_birth(label) : fields.ends[0], keys);
    add_end(1, "_death", fields.ends.isEmpty() ? at_death() : fields.ends[1], nullptr);
  } else if constexpr (std::is_same_v<Value, bool>) {
    finish_field(info, name, *add_toggle(form, label, {name, get, set}));
  } else {
    // Integers beyond 2^53 are no doubles.
    constexpr NumberDomain integers{-9e15, 9e15, domain::integer.allowed};
    const bool is_integer = std::is_same_v<Value, std::int64_t>;
    finish_field(info, name,
                 *add_number(form, title,
                             {name, is_integer ? integers : field.domain, scale, info.step, get,
                              [set, is_integer](double value, MergeId gesture) {
                                set(is_integer ? std::round(value) : value, gesture);
                              }},
                             keys));
  }
}

}  // namespace brume
