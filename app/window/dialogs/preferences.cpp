#include "app/window/dialogs/preferences.h"

#include <tbb/global_control.h>

#include <QActionGroup>
#include <QComboBox>
#include <QCoreApplication>
#include <QFormLayout>
#include <QLineEdit>
#include <QSettings>
#include <QSpinBox>
#include <QTabWidget>
#include <QVBoxLayout>
#include <optional>
#include <thread>

#include "app/document/autosave.h"
#include "app/document/text/number_text.h"
#include "app/widgets/interface_settings.h"
#include "app/widgets/mnemonics.h"
#include "app/widgets/rows.h"
#include "app/window/dialogs/key_preferences.h"

namespace brume {
namespace {

constexpr const char* threads_key = "render/threads";

QString text(const char* source) {
  return QCoreApplication::translate("DisplayPreferences", source);
}

void add_unit(QFormLayout& form) {
  auto* unit = named(new QComboBox, "length_unit");
  unit->setEditable(true);
  unit->addItems({"", "u", "mm", "cm", "m", "km", "in", "ft"});
  unit->lineEdit()->setMaxLength(InterfaceSettings::max_unit_length);
  unit->lineEdit()->setPlaceholderText(text("none"));
  unit->setCurrentText(InterfaceSettings::instance().length_unit());
  unit->setToolTip(
      text("The name shown behind lengths and positions. Numbers stay as they are: nothing is "
           "converted"));
  QObject::connect(unit, &QComboBox::currentTextChanged, [](const QString& name) {
    InterfaceSettings::instance().set_length_unit(name);
  });
  form.addRow(text("Unit of lengths"), unit);
}

void add_colors(QFormLayout& form) {
  using Numbers = InterfaceSettings::ColorNumbers;
  auto* colors = named(new QComboBox, "color_numbers");
  colors->addItem(text("sRGB, 0 to 255"), static_cast<int>(Numbers::srgb));
  colors->addItem(text("Linear, 0 to 1"), static_cast<int>(Numbers::linear));
  colors->setCurrentIndex(
      colors->findData(static_cast<int>(InterfaceSettings::instance().color_numbers())));
  colors->setToolTip(text(
      "How the numbers of a colour are shown and entered: as in most programs, or as light adds "
      "up and scene files have them"));
  QObject::connect(colors, &QComboBox::activated, [colors] {
    InterfaceSettings::instance().set_color_numbers(
        static_cast<Numbers>(colors->currentData().toInt()));
  });
  form.addRow(text("Numbers of colours"), colors);
}

void add_handles(QFormLayout& form) {
  auto* handles = named(new QComboBox, "handle_scale");
  handles->addItem(text("By the screen"), 0.0);
  for (const double scale : {1.0, 1.25, 1.5, 2.0, 2.5, 3.0}) {
    handles->addItem(QString("%1 ×").arg(number_text(scale)), scale);
  }
  handles->setCurrentIndex(
      std::max(0, handles->findData(InterfaceSettings::instance().chosen_handle_scale())));
  handles->setToolTip(
      text("Size of handles and outlines in the views, and how near the mouse has to be to them"));
  QObject::connect(handles, &QComboBox::activated, [handles] {
    InterfaceSettings::instance().set_handle_scale(handles->currentData().toDouble());
  });
  form.addRow(text("Size of handles"), handles);
}

void add_language(QFormLayout& form) {
  auto* languages = named(new QComboBox, "language", text("From the next start on"));
  // Languages are called by their own names.
  for (const auto& [title, language] : {std::pair{text("As the system"), Language::system},
                                        std::pair{QString("English"), Language::english},
                                        std::pair{QString("Deutsch"), Language::german}}) {
    languages->addItem(title, static_cast<int>(language));
  }
  auto& settings = InterfaceSettings::instance();
  languages->setCurrentIndex(languages->findData(static_cast<int>(settings.language())));
  QObject::connect(languages, &QComboBox::activated, languages, [languages, &settings] {
    settings.set_language(static_cast<Language>(languages->currentData().toInt()));
  });
  form.addRow(text("Language"), languages);
}

void add_scale(QFormLayout& form) {
  auto* scales = named(new QComboBox, "interface_scale",
                       text("Size of letters, buttons and panels. From the next start on"));
  scales->addItem(text("By the screen"), 0.0);
  for (const double scale : {0.75, 0.9, 1.0, 1.1, 1.25, 1.5, 1.75, 2.0, 2.5, 3.0}) {
    scales->addItem(QString("%1 %").arg(number_text(100.0 * scale)), scale);
  }
  auto& settings = InterfaceSettings::instance();
  const double chosen = settings.interface_scale();
  if (scales->findData(chosen) < 0) {
    scales->addItem(QString("%1 %").arg(number_text(100.0 * chosen)), chosen);
  }
  scales->setCurrentIndex(scales->findData(chosen));
  QObject::connect(scales, &QComboBox::activated, scales, [scales, &settings] {
    settings.set_interface_scale(scales->currentData().toDouble());
  });
  form.addRow(text("Scale of the interface"), scales);
}

// The page about how the editor and its scenes are shown.
QWidget* display_page() {
  auto* page = new QWidget;
  auto* form = new QFormLayout(page);
  add_language(*form);
  add_scale(*form);
  add_unit(*form);
  add_colors(*form);
  add_handles(*form);
  return page;
}

}  // namespace

void apply_chosen_threads() {
  static std::optional<tbb::global_control> limit;  // the last one made counts
  limit.reset();
  const int threads = QSettings().value(threads_key).toInt();
  if (threads > 0) {
    limit.emplace(tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(threads));
  }
}

Preferences::Preferences(Autosave& autosave, QWidget* window) : QDialog(window) {
  setObjectName("preferences");
  setWindowTitle(tr("Preferences"));
  setAttribute(Qt::WA_DeleteOnClose);
  auto* general = new QWidget(this);
  form_ = new QFormLayout(general);
  add_autosave(autosave);
  add_threads();
  add_limits();
  auto* tabs = new QTabWidget(this);
  tabs->addTab(general, tr("General"));
  tabs->addTab(display_page(), tr("Display"));
  tabs->addTab(new KeyPreferences(*window), tr("Keys"));
  auto* layout = new QVBoxLayout(this);
  layout->addWidget(tabs);
  resize(520, 460);
}

void Preferences::add_choice(const QString& title, const QString& name, QActionGroup& group) {
  auto* box = named(new QComboBox(this), name);
  const QList<QAction*> actions = group.actions();
  for (int k = 0; k < actions.size(); ++k) {
    const QAction* action = actions.at(k);
    box->addItem(without_mnemonic(action->text()));
    box->setItemData(k, action->toolTip(), Qt::ToolTipRole);
    if (action->isChecked()) box->setCurrentIndex(k);
    // Checked in the menu, or by what the view shows.
    connect(action, &QAction::changed, box, [box, action, k] {
      box->setItemText(k, without_mnemonic(action->text()));
      if (action->isChecked()) box->setCurrentIndex(k);
    });
  }
  connect(box, &QComboBox::activated, &group, [actions](int k) { actions.at(k)->trigger(); });
  form_->insertRow(choices_++, title, box);
}

void Preferences::add_autosave(Autosave& autosave) {
  auto* seconds = named(new QSpinBox(this), "autosave_seconds");
  seconds->setRange(5, 3600);
  seconds->setSuffix(tr(" s"));
  seconds->setValue(autosave.interval());
  seconds->setToolTip(tr("How often a copy of unsaved work is kept, from 5 seconds to an hour"));
  connect(seconds, &QSpinBox::valueChanged, &autosave, &Autosave::set_interval);
  form_->addRow(tr("Keep unsaved work every"), seconds);
}

void Preferences::add_threads() {
  auto* threads = named(new QSpinBox(this), "threads");
  threads->setRange(0, static_cast<int>(std::max(1U, std::thread::hardware_concurrency())));
  threads->setSpecialValueText(tr("all cores"));
  threads->setValue(QSettings().value(threads_key).toInt());
  threads->setToolTip(tr("How many processor threads render at most, to leave some to others"));
  connect(threads, &QSpinBox::valueChanged, this, [](int count) {
    QSettings().setValue(threads_key, count);
    apply_chosen_threads();
  });
  form_->addRow(tr("Threads"), threads);
}

void Preferences::add_limits() {
  auto& settings = InterfaceSettings::instance();
  auto* steps = named(new QSpinBox(this), "undo_limit",
                      tr("How many steps of the history are kept: fewer take less memory. From the "
                         "next scene on"));
  // Below the smallest limit is none.
  steps->setRange(InterfaceSettings::min_undo_limit - 1, InterfaceSettings::max_undo_limit);
  steps->setSpecialValueText(tr("all"));
  steps->setKeyboardTracking(false);
  steps->setValue(settings.undo_limit());
  connect(steps, &QSpinBox::valueChanged, this, [&settings, steps](int count) {
    settings.set_undo_limit(count == steps->minimum() ? 0 : count);
  });
  form_->addRow(tr("Steps that can be undone"), steps);
  auto* memory =
      named(new QSpinBox(this), "frame_memory",
            tr("Memory for the frames of an animation that have been shown, to play them "
               "without rendering"));
  memory->setRange(InterfaceSettings::min_frame_memory, InterfaceSettings::max_frame_memory);
  memory->setSuffix(tr(" MB"));
  memory->setKeyboardTracking(false);
  memory->setValue(settings.frame_memory());
  connect(memory, &QSpinBox::valueChanged, this,
          [&settings](int megabytes) { settings.set_frame_memory(megabytes); });
  form_->addRow(tr("Memory for played frames"), memory);
}

}  // namespace brume
