#include "app/panels/forms/scene_form.h"

#include <QCheckBox>
#include <QCoreApplication>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>

#include "app/document/document.h"
#include "app/document/text/words.h"
#include "app/panels/forms/key_button.h"
#include "app/widgets/color_button.h"
#include "app/widgets/rows.h"

namespace brume {

SceneForm::SceneForm(Document& document, QWidget* parent) : QWidget(parent), document_(document) {
  on_change(document_, Change::scene | Change::part, this, &SceneForm::refresh);
}

QFormLayout* SceneForm::new_form(int margin) {
  auto* form = new QFormLayout(this);
  form->setContentsMargins(margin, margin, margin, margin);
  return form;
}

void SceneForm::refresh() {
  for (const auto& update : updates_) update();
}

ValueField* SceneForm::new_field(const Number& number, const QString& title) {
  auto* field = new ValueField(title, number.domain, number.scale, number.step, this);
  field->setObjectName(number.name);
  connect(field, &ValueField::edited, this, number.set);
  connect(field, &ValueField::refused, this, &SceneForm::refused);
  on_refresh([field, get = number.get] {
    const std::optional<double> value = get();
    field->setEnabled(value.has_value());
    field->show_value(value);
  });
  return field;
}

KeyButton* SceneForm::new_key_button(const QString& name,
                                     std::function<Track(const Scene&)> track) {
  return named(new KeyButton(document_, std::move(track), this), name + "_key");
}

void SceneForm::finish_field(const FieldInfo& info, const QString& name, QWidget& title) {
  const QString unit = info.unit;
  const QString says = fields_text(info.says).remove('`');
  const bool has_unit = !unit.isEmpty() && unit != "RGB";
  title.setToolTip(has_unit ? says + '\n' + tr("Unit: %1").arg(fields_text(info.unit)) : says);
  if (unit == "u") show_length_units(*this, {name.toUtf8().constData()});
}

void SceneForm::add_keys(QHBoxLayout& row, KeyButton* keys, std::function<bool()> is_there) {
  if (keys == nullptr) return;
  for (int k = 0; k < row.count(); ++k) keys->watch(*row.itemAt(k)->widget());
  row.addWidget(keys);
  on_refresh([keys, is_there = std::move(is_there)] {
    keys->setEnabled(is_there());
    if (keys->isEnabled()) keys->refresh();
  });
}

QLabel* SceneForm::add_number(QFormLayout& form, const QString& title, const Number& number,
                              KeyButton* keys) {
  ValueField* field = new_field(number, title);
  QLabel* label = field->detach_title();
  label->setObjectName(number.name + "_title");
  auto* row = new QHBoxLayout;
  row->addWidget(field);
  add_keys(*row, keys, [get = number.get] { return get().has_value(); });
  if (keys) keys->watch(*label);
  form.addRow(label, row);
  return label;
}

QLabel* SceneForm::add_vector(QFormLayout& form, const QString& title, const Vector& vector,
                              KeyButton* keys) {
  auto* row = new QHBoxLayout;
  for (int k = 0; k < 3; ++k) {
    const auto get = [vector, k]() -> std::optional<double> {
      const std::optional<glm::dvec3> value = vector.get();
      return value ? std::optional((*value)[k]) : std::nullopt;
    };
    const auto set = [vector, k](double number, MergeId gesture) {
      glm::dvec3 value = vector.get().value_or(glm::dvec3(0.0));
      value[k] = number;
      vector.set(value, gesture);
    };
    auto* field =
        new_field({vector.name, vector.domain, ValueField::Scale::linear, vector.step, get, set},
                  QString(vector.parts).at(k));
    field->setObjectName(QString("%1_%2").arg(vector.name).arg(QString("xyz").at(k)));
    row->addWidget(field);
  }
  add_keys(*row, keys, [get = vector.get] { return get().has_value(); });
  auto* label = new QLabel(title, this);
  form.addRow(label, row);
  return label;
}

void SceneForm::add_color(QFormLayout& form, const QString& title, const Color& color,
                          KeyButton* keys) {
  auto* button = named(new ColorButton(this), color.name);
  connect(button, &ColorButton::edited, this, color.set);
  on_refresh([button, get = color.get] {
    const std::optional<glm::dvec3> value = get();
    button->setEnabled(value.has_value());
    button->show_color(value.value_or(glm::dvec3(0.0)));
  });
  auto* row = new QHBoxLayout;
  row->addWidget(button);
  add_keys(*row, keys, [get = color.get] { return get().has_value(); });
  form.addRow(title, row);
}

QWidget* SceneForm::add_toggle(QFormLayout& form, const QString& title, const Toggle& toggle) {
  auto* box = named(new QCheckBox(title, this), toggle.name);
  connect(box, &QCheckBox::clicked, this, [set = toggle.set](bool is_on) { set(is_on, no_merge); });
  on_refresh([box, get = toggle.get] {
    const std::optional<bool> value = get();
    box->setEnabled(value.has_value());
    box->setChecked(value.value_or(false));
  });
  form.addRow({}, box);
  return box;
}

QString fields_text(const char* text) {
  return QCoreApplication::translate("Fields", text);
}

QString field_label(const FieldInfo& info) {
  return fields_text(info.label);
}

QString object_label(const QString& object, const QString& label) {
  return object.isEmpty() ? label : object + ' ' + in_sentence(label);
}

QString at_birth(const QString& label) {
  return SceneForm::tr("%1 at birth").arg(label);
}

QString at_death() {
  return SceneForm::tr("at death");
}

}  // namespace brume
