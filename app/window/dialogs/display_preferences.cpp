#include "app/window/dialogs/display_preferences.h"

#include <QComboBox>
#include <QFormLayout>
#include <QLineEdit>

#include "app/document/number_text.h"
#include "app/widgets/interface_settings.h"

namespace brume {

DisplayPreferences::DisplayPreferences(QWidget* parent) : QWidget(parent) {
  auto* form = new QFormLayout(this);
  add_unit(*form);
  add_colors(*form);
  add_handles(*form);
}

void DisplayPreferences::add_unit(QFormLayout& form) {
  auto* unit = new QComboBox(this);
  unit->setObjectName("length_unit");
  unit->setEditable(true);
  unit->addItems({"", "u", "mm", "cm", "m", "km", "in", "ft"});
  unit->lineEdit()->setMaxLength(InterfaceSettings::max_unit_length);
  unit->lineEdit()->setPlaceholderText(tr("none"));
  unit->setCurrentText(InterfaceSettings::instance().length_unit());
  unit->setToolTip(
      tr("The name shown behind lengths and positions. Numbers stay as they are: nothing is "
         "converted"));
  connect(unit, &QComboBox::currentTextChanged, this,
          [](const QString& text) { InterfaceSettings::instance().set_length_unit(text); });
  form.addRow(tr("Unit of lengths"), unit);
}

void DisplayPreferences::add_colors(QFormLayout& form) {
  using Numbers = InterfaceSettings::ColorNumbers;
  auto* colors = new QComboBox(this);
  colors->setObjectName("color_numbers");
  colors->addItem(tr("sRGB, 0 to 255"), static_cast<int>(Numbers::srgb));
  colors->addItem(tr("Linear, 0 to 1"), static_cast<int>(Numbers::linear));
  colors->setCurrentIndex(
      colors->findData(static_cast<int>(InterfaceSettings::instance().color_numbers())));
  colors->setToolTip(
      tr("How the numbers of a colour are shown and entered: as in most programs, or as light adds "
         "up and scene files have them"));
  connect(colors, &QComboBox::activated, this, [colors] {
    InterfaceSettings::instance().set_color_numbers(
        static_cast<Numbers>(colors->currentData().toInt()));
  });
  form.addRow(tr("Numbers of colours"), colors);
}

void DisplayPreferences::add_handles(QFormLayout& form) {
  auto* handles = new QComboBox(this);
  handles->setObjectName("handle_scale");
  handles->addItem(tr("By the screen"), 0.0);
  for (const double scale : {1.0, 1.25, 1.5, 2.0, 2.5, 3.0}) {
    handles->addItem(QString("%1 ×").arg(number_text(scale)), scale);
  }
  handles->setCurrentIndex(
      std::max(0, handles->findData(InterfaceSettings::instance().chosen_handle_scale())));
  handles->setToolTip(
      tr("Size of handles and outlines in the views, and how near the mouse has to be to them"));
  connect(handles, &QComboBox::activated, this, [handles] {
    InterfaceSettings::instance().set_handle_scale(handles->currentData().toDouble());
  });
  form.addRow(tr("Size of handles"), handles);
}

}  // namespace brume
