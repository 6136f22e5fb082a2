// View > Color: views of OpenColorIO's configurations.

#include <QAction>
#include <QMenu>
#include <QSettings>
#include <algorithm>

#include "app/document/paths.h"
#include "app/viewport/view_grid.h"
#include "brume/error.h"
#include "tests/app/test_window.h"
#include "tests/render/display/halving_config.h"

using namespace brume;

namespace {

QMenu& menu(TestWindow& window) {
  auto* found = window->findChild<QMenu*>("color_menu");
  if (!found) qFatal("no menu");
  Q_EMIT found->aboutToShow();
  return *found;
}

QAction* entry(TestWindow& window, const QString& title) {
  for (QAction* action : menu(window).actions()) {
    if (action->text().remove('&') == title) return action;
  }
  return nullptr;
}

QImage shown(TestWindow& window) {
  const FrameScheduler& frames = window->viewport().frames();
  return to_picture(frames.shown()->frame, frames.display(), ViewMode::final);
}

}  // namespace

class ColorViewTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void init() { qunsetenv("OCIO"); }
  void cleanup() {
    qunsetenv("OCIO");
    QSettings().remove("color");
  }

  void aces_is_built_in_and_remembered() {
    TestWindow window;
    const QImage neutral = shown(window);
    QVERIFY(entry(window, "Neutral")->isChecked());
    entry(window, "ACES 1.0 SDR")->trigger();
    QVERIFY(shown(window) != neutral);
    QVERIFY(entry(window, "ACES 1.0 SDR")->isChecked());
    QVERIFY(!entry(window, "Neutral")->isChecked());
    {
      const ColorManagement again;
      QVERIFY(again.view());
      QCOMPARE(again.view()->choice().view, std::string("ACES 1.0 SDR"));
    }
    // The screen shows the picture, with OpenGL in motion too.
    QVERIFY(window.settle());
    const QImage grabbed = window->viewport().grab().toImage();
    entry(window, "Neutral")->trigger();
    QVERIFY(window.settle());
    QVERIFY(window->viewport().grab().toImage() != grabbed);
    QVERIFY(shown(window) == neutral);
    QVERIFY(!ColorManagement().view());
    QVERIFY(!window->document().undo_stack().canUndo());  // nothing of the scene
  }

  // The search for commands looks for them where the menu is closed.
  void entries_outlive_that_the_menu_is_open() {
    TestWindow window;
    QMenu& closed = menu(window);
    Q_EMIT closed.aboutToHide();
    QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
    QVERIFY(std::ranges::any_of(closed.actions(), [](const QAction* action) {
      return action->text().remove('&') == "Neutral";
    }));
  }

  void a_configuration_of_the_environment_is_offered() {
    TestWindow window;
    const std::filesystem::path config = window.file("studio.ocio");
    write_text(config, halving_config);
    qputenv("OCIO", config.c_str());
    QVERIFY(entry(window, "plain") && entry(window, "half"));
    QVERIFY(entry(window, "ACES 1.0"));  // beside it
    entry(window, "plain")->trigger();
    const QImage plain = shown(window);
    entry(window, "half")->trigger();
    const QImage half = shown(window);
    for (int y = 0; y < plain.height(); y += 7) {
      for (int x = 0; x < plain.width(); x += 7) {
        const int expected = qGreen(plain.pixel(x, y));
        if (expected == 255) continue;  // clipped
        QVERIFY(std::abs(2 * qGreen(half.pixel(x, y)) - expected) <= 2);
      }
    }
    // A configuration that is gone leaves the view that all have.
    std::filesystem::remove(config);
    const ColorManagement next;
    QVERIFY(!next.view());
  }

  void a_broken_configuration_says_so() {
    TestWindow window;
    const std::filesystem::path config = window.file("broken.ocio");
    write_text(config, "{{{");
    qputenv("OCIO", config.c_str());
    QAction* told = entry(window, "The configuration cannot be read");
    QVERIFY(told && !told->isEnabled());
    QVERIFY(told->toolTip().contains("broken.ocio"));
    const QImage before = shown(window);
    bool refused = false;
    try {
      window->views().color().set_config(config.string());
    } catch (const InputError&) {
      refused = true;
    }
    QVERIFY(refused);
    QVERIFY(shown(window) == before);
    QVERIFY(entry(window, "Neutral")->isChecked());
  }
};

BRUME_APP_SUITE("color_view", ColorViewTest)
#include "color_view_test.moc"
