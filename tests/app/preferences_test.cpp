// Preferences: choices that apply at once and last.

#include <QColorDialog>
#include <QComboBox>
#include <QDockWidget>
#include <QInputDialog>
#include <QKeySequenceEdit>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QPushButton>
#include <QSettings>
#include <QSpinBox>
#include <QTreeWidget>

#include "app/commands/gaussians/operation_numbers.h"
#include "app/document/autosave.h"
#include "app/view/drawing/overlay.h"
#include "app/viewport/viewport.h"
#include "app/widgets/application.h"
#include "app/widgets/color_button.h"
#include "app/widgets/interface_settings.h"
#include "app/widgets/keys.h"
#include "app/widgets/number_field.h"
#include "app/widgets/value_field.h"
#include "app/window/dialogs/preferences.h"
#include "tests/app/test_window.h"

using namespace brume;

namespace {

class PreferencesWindow : public TestWindow {
 public:
  PreferencesWindow() {
    key(Qt::Key_Comma, Qt::ControlModifier);
    preferences = (*this)->findChild<Preferences*>();
    if (!preferences) qFatal("no preferences");
  }
  template <class T>
  T& part(const char* name) {
    return *preferences->findChild<T*>(name);
  }
  void choose_command(const QString& title) {
    auto& list = part<QTreeWidget>("key_list");
    list.setCurrentItem(list.findItems(title, Qt::MatchExactly).at(0));
  }
  QAction& action(const char* name) { return *(*this)->findChild<QAction*>(name); }

  Preferences* preferences = nullptr;
};

}  // namespace

class PreferencesTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void cleanup() { QSettings().clear(); }

  void keys_work_on_a_keyboard_of_another_script() {
    TestWindow window;
    constexpr int place_of_b = 56;
    QKeyEvent press(QEvent::KeyPress, 0x0418, Qt::NoModifier, place_of_b, 0, 0,
                    QString(QChar(0x0438)));
    QApplication::sendEvent(&window->viewport(), &press);
    QVERIFY(window->findChild<QAction*>("tool.paintbrush")->isChecked());
    constexpr int place_of_z = 52;
    window->document().undo_stack().push(new QUndoCommand("nothing"));
    QKeyEvent undo(QEvent::KeyPress, 0x042f, Qt::ControlModifier, place_of_z, 0, 0);
    QApplication::sendEvent(&window->viewport(), &undo);
    QCOMPARE(window->document().undo_stack().index(), 0);
  }

  void keys_are_set_taken_and_given_back() {
    {
      PreferencesWindow window;
      window.choose_command("Tool › Paintbrush");
      auto& edit = window.part<QKeySequenceEdit>("key_edit");
      QTest::keyClick(&edit, Qt::Key_F8);
      window.part<QPushButton>("key_set").click();
      QCOMPARE(window.action("tool.paintbrush").shortcut(), QKeySequence(Qt::Key_F8));
      window.key(Qt::Key_F8);
      QVERIFY(window.action("tool.paintbrush").isChecked());
      // E is the eraser's.
      window.choose_command("Tool › Lasso");
      QTest::keyClick(&edit, Qt::Key_E);
      window.part<QPushButton>("key_set").click();
      QCOMPARE(window.part<QLabel>("key_note").text(), "Taken from Tool › Eraser.");
      QVERIFY(window.action("tool.eraser").shortcuts().isEmpty());
      window.key(Qt::Key_E);
      QVERIFY(window.action("tool.lasso").isChecked());
    }
    PreferencesWindow later;
    QCOMPARE(later.action("tool.paintbrush").shortcut(), QKeySequence(Qt::Key_F8));
    QVERIFY(later.action("tool.eraser").shortcuts().isEmpty());
    later.choose_command("Tool › Paintbrush");
    later.part<QPushButton>("key_default").click();
    QCOMPARE(later.action("tool.paintbrush").shortcut(), QKeySequence(Qt::Key_B));
    later.part<QPushButton>("keys_default").click();
    QCOMPARE(later.action("tool.eraser").shortcut(), QKeySequence(Qt::Key_E));
    for (const KeyEntry& entry : key_table()) {
      QVERIFY(!QSettings().contains(QString("keys/") + entry.action));
    }
  }

  void commands_are_filtered() {
    PreferencesWindow window;
    auto& list = window.part<QTreeWidget>("key_list");
    QTest::keyClicks(&window.part<QLineEdit>("key_filter"), "ctrl+z");
    int shown = 0;
    for (int k = 0; k < list.topLevelItemCount(); ++k) shown += !list.topLevelItem(k)->isHidden();
    QCOMPARE(shown, 1);
  }

  void choices_apply_at_once() {
    PreferencesWindow window;
    const auto choose = [&](const char* name, int index) {
      auto& box = window.part<QComboBox>(name);
      box.setFocus();
      while (box.currentIndex() > index) QTest::keyClick(&box, Qt::Key_Up);
      while (box.currentIndex() < index) QTest::keyClick(&box, Qt::Key_Down);
    };
    choose("theme", 1);
    QVERIFY(theme() == Theme::light);
    choose("theme", 0);
    QVERIFY(theme() == Theme::dark);
    choose("airlight", 3);
    QVERIFY(window->viewport().frames().quality().airlight() == AirlightMethod::paper);
    // The menu and the box agree.
    window.action("airlight_auto").trigger();
    QCOMPARE(window.part<QComboBox>("airlight").currentIndex(), 0);
    window.part<QSpinBox>("autosave_seconds").setValue(60);
    QCOMPARE(window->autosave().interval(), 60);
    window.part<QSpinBox>("threads").setValue(1);
    QVERIFY(window.settle());  // still renders
    window.part<QSpinBox>("threads").setValue(0);
  }

  void lengths_have_the_unit_that_is_chosen() {
    {
      PreferencesWindow window;
      window->document().select({window->document().medium().ids()[0]});
      auto* radius = window->findChild<QLineEdit*>("radius");
      auto* density = window->findChild<QLineEdit*>("density");
      const QString plain = radius->text();
      QVERIFY(!plain.contains(' '));
      auto& unit = window.part<QComboBox>("length_unit");
      unit.setFocus();
      unit.lineEdit()->selectAll();
      QTest::keyClicks(&unit, "cm");
      QCOMPARE(radius->text(), plain + " cm");
      QVERIFY(!density->text().contains("cm"));
      // Numbers are taken as they are, with the unit and without.
      radius->setFocus();
      radius->selectAll();
      QTest::keyClicks(radius, "0.5 cm");
      QTest::keyClick(radius, Qt::Key_Return);
      QCOMPARE(window->document().medium().radii()[0], 0.5);
      QCOMPARE(radius->text(), "0.5 cm");
    }
    PreferencesWindow later;
    QCOMPARE(later.part<QComboBox>("length_unit").currentText(), "cm");
  }

  void colours_have_the_numbers_that_are_chosen() {
    PreferencesWindow window;
    auto* albedo = window->findChild<ColorButton*>("gaussian_albedo");
    albedo->show_color(glm::dvec3(0.5, 0.25, 0.0));
    QCOMPARE(albedo->toolTip(), "sRGB 188, 137, 0");
    auto& numbers = window.part<QComboBox>("color_numbers");
    numbers.setFocus();
    QTest::keyClick(&numbers, Qt::Key_Down);
    QCOMPARE(albedo->toolTip(), "linear 0.5, 0.25, 0");
    // The colour dialog has fields of such numbers then.
    QSignalSpy edited(albedo, &ColorButton::edited);
    albedo->setEnabled(true);
    albedo->click();
    auto* dialog = albedo->findChild<QColorDialog*>();
    QVERIFY(dialog);
    auto* green = dialog->findChild<ValueField*>("linear_g");
    QVERIFY(green);
    green->number().selectAll();
    QTest::keyClicks(&green->number(), "0.125");
    QTest::keyClick(&green->number(), Qt::Key_Return);
    QVERIFY(!edited.isEmpty());
    QCOMPARE(edited.back()[0].value<glm::dvec3>(), glm::dvec3(0.5, 0.125, 0.0));
    dialog->close();
  }

  void handles_grow_and_are_picked_from_farther() {
    PreferencesWindow window;
    Viewport& view = window->viewport();
    view.raise();
    const QPoint beside = window.handle(0) + QPoint(14, 0);
    const auto picked = [&] {
      return view.shown_handles().handles().pick(beside) == std::optional<std::size_t>(0);
    };
    QVERIFY(!picked());
    const float line = Overlay::line_width();
    auto& scale = window.part<QComboBox>("handle_scale");
    scale.setFocus();
    while (scale.currentData().toDouble() != 2.0) QTest::keyClick(&scale, Qt::Key_Down);
    QVERIFY(picked());
    QCOMPARE(Overlay::line_width(), 2.0F * line);
    QCOMPARE(handle_scale(), 2.0);
    QCOMPARE(handle_scale_of(96.0), 1.0);
    QCOMPARE(handle_scale_of(192.0), 2.0);
    QCOMPARE(handle_scale_of(1000.0), 3.0);
    scale.setFocus();
    while (scale.currentIndex() > 0) QTest::keyClick(&scale, Qt::Key_Up);
    QCOMPARE(handle_scale(), 1.0);
  }

  void layouts_are_saved_restored_and_deleted() {
    const auto trigger = [](TestWindow& window, const QString& text) {
      auto* menu = window->findChild<QMenu*>("layouts");
      Q_EMIT menu->aboutToShow();
      for (QMenu* shown : {menu, menu->findChild<QMenu*>("layout_delete")}) {
        for (QAction* action : shown->actions()) {
          if (action->text().remove('&') == text && !action->menu()) return action->trigger();
        }
      }
      qFatal("no such layout");
    };
    const auto is_open = [](TestWindow& window, const char* dock) {
      return !window->findChild<QDockWidget*>(dock)->isHidden();
    };
    {
      TestWindow window;
      window->findChild<QDockWidget*>("outliner")->close();
      window->findChild<QDockWidget*>("timeline")->close();
      trigger(window, "Save Current As…");
      auto* dialog = window->findChild<QInputDialog*>("layout_name");
      QVERIFY(dialog);
      QTest::keyClicks(dialog->findChild<QLineEdit*>(), "Paint & look");
      QTest::keyClick(dialog->findChild<QLineEdit*>(), Qt::Key_Return);
      trigger(window, "Reset to Default");
      QVERIFY(is_open(window, "outliner") && is_open(window, "timeline"));
    }
    TestWindow later;
    QVERIFY(is_open(later, "outliner"));
    auto* menu = later->findChild<QMenu*>("layouts");
    Q_EMIT menu->aboutToShow();
    QCOMPARE(menu->actions().front()->text(), "Paint && look");
    menu->actions().front()->trigger();
    QVERIFY(!is_open(later, "outliner") && !is_open(later, "timeline"));
    trigger(later, "Reset to Default");
    Q_EMIT menu->aboutToShow();
    menu->findChild<QMenu*>("layout_delete")->actions().front()->trigger();
    Q_EMIT menu->aboutToShow();
    QVERIFY(menu->actions().front()->text() != "Paint && look");
    QVERIFY(QSettings().value("window/layouts").toMap().isEmpty());
  }

  void limits_apply_and_last() {
    {
      PreferencesWindow window;
      auto& steps = window.part<QSpinBox>("undo_limit");
      QCOMPARE(steps.text(), "all");
      steps.setFocus();
      steps.selectAll();
      QTest::keyClicks(&steps, "12");
      QCOMPARE(InterfaceSettings::instance().undo_limit(), 0);
      QTest::keyClick(&steps, Qt::Key_Return);
      window.part<QSpinBox>("frame_memory").setValue(64);
      window.document().create();
      QCOMPARE(window.document().undo_stack().undoLimit(), 12);
      for (int k = 0; k < 20; ++k) window.document().undo_stack().push(new QUndoCommand("step"));
      QCOMPARE(window.document().undo_stack().count(), 12);
    }
    PreferencesWindow later;
    QCOMPARE(later.part<QSpinBox>("undo_limit").value(), 12);
    QCOMPARE(later.part<QSpinBox>("frame_memory").value(), 64);
  }

  void operations_are_adjusted_with_a_full_history() {
    PreferencesWindow window;
    window.part<QSpinBox>("undo_limit").setValue(10);
    Document& document = window.document();
    document.create();
    for (int k = 0; k < 12; ++k) document.undo_stack().push(new QUndoCommand("step"));
    invoke(*window, "fog.haze");
    QVERIFY(document.last_operation().operation());
    QCOMPARE(last_step(document), "Add haze");
    const double density = document.medium().homogeneous_density();
    std::any numbers = document.last_operation().operation()->numbers;
    std::any_cast<EvenFog&>(numbers).density *= 2.0;
    document.last_operation().adjust(numbers);
    QCOMPARE(document.undo_stack().count(), 10);
    QVERIFY(document.medium().homogeneous_density() > 1.5 * density);
    document.undo_stack().undo();
    QCOMPARE(document.medium().homogeneous_density(), 0.0);
  }

  void language_and_scale_are_kept_for_the_next_start() {
    {
      PreferencesWindow window;
      for (const char* name : {"language", "interface_scale"}) {
        auto& box = window.part<QComboBox>(name);
        QCOMPARE(box.currentIndex(), 0);
        box.setFocus();
        QTest::keyClick(&box, Qt::Key_Down);
      }
    }
    InterfaceSettings& settings = InterfaceSettings::instance();
    settings.load();
    QCOMPARE(settings.language(), Language::english);
    QCOMPARE(settings.interface_scale(), 0.75);
    prepare_application();
    QCOMPARE(qgetenv("QT_SCALE_FACTOR"), "0.75");
    qunsetenv("QT_SCALE_FACTOR");
  }

  void bad_settings_are_the_nearest_good_ones() {
    InterfaceSettings& settings = InterfaceSettings::instance();
    const auto read = [&](const char* key, const QVariant& value) {
      QSettings().setValue(QString("interface/") + key, value);
      settings.load();
    };
    for (const auto& [value, scale] : {std::pair<QVariant, double>("nan", 0.0),
                                       {"1e300", 3.0},
                                       {"-5", 0.5},
                                       {"large", 0.0},
                                       {0.1, 0.5}}) {
      read("scale", value);
      QCOMPARE(settings.interface_scale(), scale);
    }
    read("language", "tlh");
    QCOMPARE(settings.language(), Language::system);
    read("undo_limit", "-7");
    QCOMPARE(settings.undo_limit(), InterfaceSettings::min_undo_limit);
    read("undo_limit", "9e99");
    QCOMPARE(settings.undo_limit(), InterfaceSettings::max_undo_limit);
    read("frame_memory_mb", "inf");
    QCOMPARE(settings.frame_memory(), InterfaceSettings::min_frame_memory);
    QSettings().clear();
    settings.load();
  }

  void handles_can_be_hidden() {
    PreferencesWindow window;
    QVERIFY(window.action("view.overlays").isChecked());
    window.key(Qt::Key_O, Qt::ShiftModifier);
    QVERIFY(!window.action("view.overlays").isChecked());
    window.key(Qt::Key_O, Qt::ShiftModifier);
    QVERIFY(window.action("view.overlays").isChecked());
  }
};

BRUME_APP_SUITE("preferences", PreferencesTest)

#include "preferences_test.moc"
