#include "app/tools/option_widgets.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>

#include "app/widgets/number_field.h"
#include "app/widgets/rows.h"

namespace brume {

ValueField* add_number(QHBoxLayout& row, Tool& tool, const NumberOption& option,
                       const std::function<double()>& get, const std::function<void(double)>& set) {
  auto* field = new ValueField(option.title, option.domain, option.scale, option.step);
  field->setObjectName(option.name);
  field->setMaximumWidth(130);
  row.addWidget(field);
  field->show_value(get());
  QObject::connect(field, &ValueField::edited, field, [set](double value) { set(value); });
  QObject::connect(field, &ValueField::refused, &tool, &Tool::refused);
  QObject::connect(&tool, &Tool::options_changed, field,
                   [field, get] { field->show_value(get()); });
  return field;
}

void add_choice(QHBoxLayout& row, Tool& tool, const ChoiceOption& option,
                const QStringList& choices, const std::function<int()>& get,
                const std::function<void(int)>& set) {
  auto* box = named(new QComboBox, option.name);
  box->addItems(choices);
  box->setCurrentIndex(get());
  row.addWidget(new QLabel(option.title));
  row.addWidget(box);
  QObject::connect(box, &QComboBox::activated, box, set);
  QObject::connect(&tool, &Tool::options_changed, box, [box, get] { box->setCurrentIndex(get()); });
}

void add_target(QHBoxLayout& row, Tool& tool, const QString& prefix,
                const std::function<PaintTarget()>& get,
                const std::function<void(const PaintTarget&)>& set) {
  add_choice(
      row, tool, {Tool::tr("On"), prefix + "_plane"},
      {Tool::tr("Under mouse"), Tool::tr("View plane"), Tool::tr("Ground, y"), Tool::tr("Wall, x"),
       Tool::tr("Wall, z"), Tool::tr("Surfaces")},
      [get] { return static_cast<int>(get().plane); },
      [get, set](int index) {
        PaintTarget target = get();
        target.plane = static_cast<PaintPlane>(index);
        set(target);
      });
  ValueField* field = add_number(
      row, tool,
      {Tool::tr("at"), prefix + "_position", domain::coordinate, ValueField::Scale::linear, 0.01},
      [get] { return get().position; },
      [get, set](double value) {
        PaintTarget target = get();
        target.position = value;
        set(target);
      });
  field->number().show_length_unit();
  const auto show = [field, get] { field->setVisible(get().has_position()); };
  QObject::connect(&tool, &Tool::options_changed, field, show);
  show();
}

}  // namespace brume
