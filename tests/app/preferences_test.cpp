// Preferences: choices that apply at once and last.

#include <QComboBox>
#include <QKeySequenceEdit>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSettings>
#include <QSpinBox>
#include <QTreeWidget>

#include "app/document/autosave.h"
#include "app/viewport/viewport.h"
#include "app/widgets/application.h"
#include "app/widgets/keys.h"
#include "app/window/preferences.h"
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

  void keys_are_set_taken_and_given_back() {
    {
      PreferencesWindow window;
      window.choose_command("Paintbrush");
      auto& edit = window.part<QKeySequenceEdit>("key_edit");
      QTest::keyClick(&edit, Qt::Key_F8);
      window.part<QPushButton>("key_set").click();
      QCOMPARE(window.action("tool.paintbrush").shortcut(), QKeySequence(Qt::Key_F8));
      window.key(Qt::Key_F8);
      QVERIFY(window.action("tool.paintbrush").isChecked());
      // E is the eraser's.
      window.choose_command("Lasso");
      QTest::keyClick(&edit, Qt::Key_E);
      window.part<QPushButton>("key_set").click();
      QCOMPARE(window.part<QLabel>("key_note").text(), QString("Taken from Eraser."));
      QVERIFY(window.action("tool.eraser").shortcuts().isEmpty());
      window.key(Qt::Key_E);
      QVERIFY(window.action("tool.lasso").isChecked());
    }
    PreferencesWindow later;
    QCOMPARE(later.action("tool.paintbrush").shortcut(), QKeySequence(Qt::Key_F8));
    QVERIFY(later.action("tool.eraser").shortcuts().isEmpty());
    later.choose_command("Paintbrush");
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
    choose("airlight", 2);
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
