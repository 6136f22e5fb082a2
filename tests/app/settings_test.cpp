// Settings of taste and what is remembered: theme, navigation, recent scenes; and how
// numbers may be typed.

#include <QAction>
#include <QMenu>
#include <glm/geometric.hpp>

#include "app/document/gaussian_attribute.h"
#include "app/document/text/arithmetic.h"
#include "app/files/scene_files.h"
#include "app/viewport/view_grid.h"
#include "app/widgets/application.h"
#include "app/widgets/number_field.h"
#include "tests/app/desk.h"
#include "tests/app/test_window.h"

using namespace brume;

namespace {

void trigger(MainWindow& window, const char* action) {
  window.findChild<QAction*>(action)->trigger();
}

}  // namespace

class SettingsTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void numbers_may_be_arithmetic() {
    const std::pair<const char*, double> good[]{
        {"0.5*3", 1.5},    {"1/4", 0.25},  {"2 + 3 * 4", 14.0}, {"(2+3)*4", 20.0},
        {"-(1 - 3)", 2.0}, {"8/2/2", 2.0}, {"1-2-3", -4.0},     {"--2", 2.0},
        {"1e-3*2", 0.002}, {".5+.5", 1.0}, {"2*-3", -6.0}};
    for (const auto& [text, value] : good) {
      QVERIFY2(evaluate(text) == value, text);
      QVERIFY2(parse_number(text) == value, text);
    }
    for (const char* bad : {"", "2*", "*2", "(1", "1)", "two", "1 2+", "1 2", "1\t2\t3", "inf",
                            "nan*1", "0x10", "2**3", "1+e"}) {
      QVERIFY2(!evaluate(bad), bad);
    }
    QVERIFY(!evaluate(QString(100000, '(')));
    QVERIFY(!evaluate(QString(100000, '-') + "1"));
    QCOMPARE(parse_number("0,5"), 0.5);  // as before
    Desk desk;
    desk.document().select({1});
    auto* radius = desk.findChild<NumberField*>("radius");
    for (const char* typed : {"0.5*3", "1/0"}) {
      radius->selectAll();
      QTest::keyClicks(radius, typed);
      QTest::keyClick(radius, Qt::Key_Return);
      QCOMPARE(desk.document().medium().radii()[0], 1.5);
    }
  }

  void the_theme_is_light_or_dark_and_remembered() {
    const QColor dark = qApp->palette().color(QPalette::Window);
    {
      TestWindow window;
      const QIcon icon = window->findChild<QAction*>("tool.paintbrush")->icon();
      const QImage drawn = icon.pixmap(24).toImage();
      trigger(*window, "theme_light");
      QTRY_VERIFY(window->palette().color(QPalette::Window).lightness() > 200);
      QVERIFY(window->palette().color(QPalette::WindowText).lightness() < 60);
      QTRY_VERIFY(window->findChild<QAction*>("tool.paintbrush")->icon().pixmap(24).toImage() !=
                  drawn);
      QVERIFY(theme() == Theme::light);
    }
    TestWindow window;
    QVERIFY(window->findChild<QAction*>("theme_light")->isChecked());
    trigger(*window, "theme_dark");
    QTRY_COMPARE(window->palette().color(QPalette::Window), dark);
  }

  void presets_of_navigation() {
    using Drag = NavigationDrag;
    const auto is = [](NavigationPreset preset, Qt::MouseButton button,
                       Qt::KeyboardModifiers modifiers, std::optional<Drag> drag) {
      return navigation_drag(preset, button, modifiers) == drag;
    };
    for (const NavigationPreset preset : navigation_presets) {
      QVERIFY(is(preset, Qt::LeftButton, {}, std::nullopt));
      QVERIFY(is(preset, Qt::LeftButton, Qt::AltModifier, Drag::orbit));
    }
    QVERIFY(is(NavigationPreset::blender, Qt::MiddleButton, {}, Drag::orbit));
    QVERIFY(is(NavigationPreset::blender, Qt::MiddleButton, Qt::ShiftModifier, Drag::pan));
    QVERIFY(is(NavigationPreset::blender, Qt::MiddleButton, Qt::ControlModifier, Drag::zoom));
    QVERIFY(is(NavigationPreset::maya, Qt::MiddleButton, {}, std::nullopt));
    QVERIFY(is(NavigationPreset::maya, Qt::MiddleButton, Qt::AltModifier, Drag::pan));
    QVERIFY(is(NavigationPreset::maya, Qt::RightButton, Qt::AltModifier, Drag::zoom));
    QVERIFY(is(NavigationPreset::brume, Qt::MiddleButton, Qt::ShiftModifier, Drag::pan));
  }

  void navigation_is_chosen_in_the_menu_and_remembered() {
    const auto eye_after = [](TestWindow& window, Qt::MouseButton button,
                              Qt::KeyboardModifiers modifiers) {
      const QPoint middle = window->viewport().rect().center();
      window.drag(middle, middle + QPoint(50, 0), button, modifiers);
      return window->viewport().camera().eye;
    };
    {
      TestWindow window;
      trigger(*window, "navigation_maya");
      const glm::dvec3 eye = window->viewport().camera().eye;
      QVERIFY(eye_after(window, Qt::MiddleButton, {}) == eye);
      // Alt is the view's, even where a brush would take it.
      window.key(Qt::Key_B);
      QVERIFY(eye_after(window, Qt::LeftButton, Qt::AltModifier) != eye);
      QVERIFY(!window->document().is_modified());
    }
    TestWindow window;
    QVERIFY(window->findChild<QAction*>("navigation_maya")->isChecked());
    window->views().show_four(true);
    QVERIFY(window->views().panes()[2]->camera_controller().navigation() == NavigationPreset::maya);
    trigger(*window, "navigation_brume");
    const glm::dvec3 eye = window->viewport().camera().eye;
    QVERIFY(eye_after(window, Qt::MiddleButton, {}) != eye);
  }

  void recent_scenes_have_pictures() {
    TestWindow window;
    QMenu menu;
    window->files().fill_recent_menu(menu);
    const QIcon icon = menu.actions().first()->icon();
    QVERIFY(!icon.isNull());
    // It shows the scene, not something black.
    const QImage picture = icon.pixmap(QSize(96, 64)).toImage();
    int brightest = 0;
    for (int y = 0; y < picture.height(); ++y) {
      for (int x = 0; x < picture.width(); ++x) {
        brightest = std::max(brightest, qGray(picture.pixel(x, y)));
      }
    }
    QVERIFY2(brightest > 20, qPrintable(QString::number(brightest)));
    // Unsaved edits are in no picture.
    window->document().select({1, 2, 3, 4, 5});
    window.key(Qt::Key_Delete);
    QVERIFY(window.settle());
    window->files().fill_recent_menu(menu);
    QCOMPARE(menu.actions().first()->icon().pixmap(QSize(96, 64)).toImage(), picture);
  }
};

BRUME_APP_SUITE("settings", SettingsTest)
#include "settings_test.moc"
