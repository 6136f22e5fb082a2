// A window begins with the start page, the view one had left, the grid of an empty scene.

#include <QCheckBox>
#include <QDockWidget>
#include <QFile>
#include <QLabel>
#include <QSettings>
#include <QStatusBar>
#include <QToolButton>

#include "app/commands/gaussians/edit_medium.h"
#include "app/document/paths.h"
#include "app/files/recent_pictures.h"
#include "app/files/scene_files.h"
#include "app/frames/headlight.h"
#include "app/view/drawing/ground_grid.h"
#include "app/viewport/view_grid.h"
#include "app/window/pages/message_bar.h"
#include "app/window/pages/start_page.h"
#include "tests/app/question.h"
#include "tests/app/test_window.h"

using namespace brume;

namespace {

StartPage& page_of(TestWindow& window) {
  return window->start_page();
}

// Presses a tile and waits until the page is gone.
bool choose(TestWindow& window, const QString& name) {
  auto* tile = page_of(window).findChild<QToolButton*>(name);
  if (!tile || !tile->isVisible()) return false;
  tile->click();
  return QTest::qWaitFor([&] { return page_of(window).isHidden(); }, patience);
}

// Whether nothing of a widget is seen beside the page.
bool covers(TestWindow& window, const QWidget& widget) {
  const StartPage& page = page_of(window);
  // Panels behind others in tabs are outside of the window.
  const QRect place = QRect(widget.mapTo(&*window, QPoint()), widget.size()) & window->rect();
  const QRegion mask = page.mask().translated(page.pos());
  return page.isVisible() && QRegion(place).subtracted(mask).isEmpty();
}

bool has_picture(const QToolButton& tile) {
  const QImage image = tile.icon().pixmap(tile.iconSize()).toImage();
  QSet<QRgb> colors;
  for (int y = 0; y < image.height(); y += 3) {
    for (int x = 0; x < image.width(); x += 3) colors.insert(image.pixel(x, y));
  }
  return colors.size() > 50;
}

}  // namespace

class StartPageTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void a_window_of_a_scene_has_none() {
    TestWindow window;
    QVERIFY(page_of(window).isHidden());
    invoke(window, "file.start_page");
    QVERIFY(page_of(window).isVisible());
    QVERIFY(covers(window, window->views()));
    QTest::keyClick(&page_of(window), Qt::Key_Escape);
    QVERIFY(page_of(window).isHidden());
    QVERIFY(window->viewport().hasFocus());
  }

  void templates_are_new_scenes_that_are_lit() {
    TestWindow window;
    for (const char* name : {"room", "landscape", "stage", "street"}) {
      page_of(window).open();
      const QString tile = QString("template_") + name;
      QVERIFY2(has_picture(*page_of(window).findChild<QToolButton*>(tile)), name);
      QVERIFY2(choose(window, tile), name);
      Document& document = window->document();
      QVERIFY(document.file().empty());
      QVERIFY(!document.is_modified());
      QVERIFY(!document.scene().surfaces.empty());
      QVERIFY(document.medium().size() > 10);
      QVERIFY(!document.scene().lights.empty());
      QVERIFY(!is_unlit(document.scene()));
      // Looked at through the scene's camera.
      QVERIFY(window->viewport().camera() == document.scene().camera);
    }
    QVERIFY(!SceneFiles::recent().join(' ').contains("templates"));
    // Saved elsewhere it finds its meshes.
    QVERIFY(window->files().save_to(window.file("street.brume")));
    QVERIFY(window.open("street.brume"));
    QCOMPARE(window.scene().surfaces.size(), 2u);
  }

  void empty_is_a_new_scene() {
    TestWindow window;
    page_of(window).open();
    QVERIFY(choose(window, "template_empty"));
    QVERIFY(window.scene() == new_scene());
    QVERIFY(window->document().file().empty());
  }

  void samples_open_as_copies() {
    TestWindow window;
    page_of(window).open();
    for (const auto* tile : page_of(window).findChildren<QToolButton*>()) {
      if (!tile->objectName().startsWith("sample_")) continue;
      QVERIFY2(has_picture(*tile), qPrintable(tile->objectName()));
      QVERIFY2(QFile::exists(QString(BRUME_SCENES "/%1.brume").arg(tile->objectName().mid(7))),
               qPrintable(tile->objectName()));
    }
    QVERIFY(choose(window, "sample_candle"));
    QVERIFY(window->document().file().empty());
    QVERIFY(!window->document().medium().empty());
  }

  void recent_scenes_have_their_pictures() {
    TestWindow window;
    QTRY_VERIFY(!recent_picture(window.file("scene.brume")).isNull());
    QVERIFY(window->files().create());
    page_of(window).open();
    auto* tile = page_of(window).findChild<QToolButton*>("recent_0");
    QVERIFY(tile && tile->isVisible());
    QCOMPARE(tile->accessibleName(), "scene");
    QVERIFY(has_picture(*tile));
    QVERIFY(choose(window, "recent_0"));
    QVERIFY(window->document().file() == window.file("scene.brume"));
  }

  void unsaved_work_is_asked_about() {
    TestWindow window;
    add_gaussian(window->document(), {});
    page_of(window).open();
    answer(QMessageBox::Cancel);
    page_of(window).findChild<QToolButton*>("template_room")->click();
    QVERIFY(page_of(window).isVisible());
    QVERIFY(!window->files().loading().is_running());
    QVERIFY(window->document().is_modified());
  }

  void an_edit_closes_it() {
    TestWindow window;
    page_of(window).open();
    add_gaussian(window->document(), {});
    QVERIFY(page_of(window).isHidden());
  }

  // It hides all that belongs to the scene behind; messages and the status line, which shows jobs,
  // stay.
  void it_covers_the_window_of_any_size() {
    TestWindow window;
    page_of(window).open();
    window->resize(1280, 800);
    QTRY_VERIFY(page_of(window).width() == window->width());
    for (const auto* dock : window->findChildren<QDockWidget*>()) {
      QVERIFY2(!dock->isVisible() || covers(window, *dock), qPrintable(dock->objectName()));
    }
    for (const char* name : {"tool_options", "tools"}) {
      QVERIFY2(covers(window, *window->findChild<QWidget*>(name)), name);
    }
    const auto* error = window->findChild<QLabel*>("error");
    QVERIFY(window->statusBar()->isVisible() && !error->isVisible());
    auto* bar = window->findChild<MessageBar*>();
    bar->show_error("a message");
    QTRY_VERIFY(bar->isVisible() && !covers(window, *bar));
    QVERIFY(covers(window, window->views()));
    bar->hide();
    // No tile is cut off to the right.
    for (const auto* tile : page_of(window).findChildren<QToolButton*>()) {
      QVERIFY(tile->geometry().right() <= tile->parentWidget()->width());
    }
    QTest::keyClick(&page_of(window), Qt::Key_Escape);
    QVERIFY(error->isVisible());
  }

  void a_scene_opens_where_one_looked_last() {
    TestWindow window;
    const auto bytes = [&] {
      QFile file(to_qstring(window.file("scene.brume")));
      return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
    };
    const QByteArray before = bytes();
    CameraController& controller = window->viewport().camera_controller();
    Camera rolled = controller.camera();
    rolled.roll = 10.0;
    controller.set_camera(rolled);
    controller.drag(NavigationDrag::orbit, {80.0, 20.0});
    const Camera left = controller.camera();
    QVERIFY(window->files().create());
    QVERIFY(controller.camera() != left);
    QVERIFY(window.open("scene.brume"));
    QVERIFY(controller.camera() == left);
    QVERIFY(!window->document().is_modified());
    QVERIFY(bytes() == before);

    // A copy is looked at as the original was, from then on by itself.
    QVERIFY(window->files().save_to(window.file("copy.brume")));
    controller.drag(NavigationDrag::pan, {10.0, 5.0});
    const Camera of_copy = controller.camera();
    QVERIFY(window.open("scene.brume"));
    QVERIFY(controller.camera() == left);
    QVERIFY(window.open("copy.brume"));
    QVERIFY(controller.camera() == of_copy);

    // Reloading stays where one is; the scene's camera is no other view.
    controller.drag(NavigationDrag::pan, {30.0, 5.0});
    const Camera present = controller.camera();
    QVERIFY(window.open("copy.brume"));
    QVERIFY(controller.camera() == present);
    window.key(Qt::Key_0);
    QVERIFY(window->files().create());
    QVERIFY(window.open("copy.brume"));
    QVERIFY(controller.camera() == window.scene().camera);
  }

  void broken_saved_views_are_ignored() {
    TestWindow window;
    const QString name = to_qstring(window.file("scene.brume"));
    for (const QString text :
         {"", "[0, 0, 9]", R"({"eye": [0, 0, 9]} x)", R"({"eye": [0, 0, 0]})",
          R"({"eye": [0, 0, 9], "vertical_fov": 720})", R"({"eye": [0, 0, "9"]})"}) {
      QVERIFY(window->files().create());
      QSettings().setValue("saved_views",
                           QVariantList{QVariantMap{{"file", name}, {"camera", text}}});
      QVERIFY(window.open("scene.brume"));
      QVERIFY(window->viewport().camera() == window.scene().camera);
    }
  }

  void an_empty_scene_has_a_ground_grid() {
    TestWindow window;
    auto* grid = window->findChild<QAction*>("view.ground_grid");
    QVERIFY(!grid->isChecked());
    grid->trigger();
    QVERIFY(window->views().shows_ground_grid());
    QVERIFY(window.open("scene.brume"));
    QVERIFY(!window->views().shows_ground_grid());
    QVERIFY(window->files().create());
    QVERIFY(grid->isChecked() && window->views().shows_ground_grid());
    window->views().show_four(true);
    QCOMPARE(window->views().panes().size(), 4u);
  }

  void the_grid_suits_the_distance_and_hides_behind_surfaces() {
    QCOMPARE(ground_grid_step(10.0), 1.0);
    QCOMPARE(ground_grid_step(30.0), 2.0);
    QCOMPARE(ground_grid_step(0.07), 0.005);
    const Camera camera{{0.0, 3.0, 8.0}, {0.0, 0.0, 0.0}};
    const Film film{100, 80};
    const auto alpha_of = [&](const std::optional<GridDepth>& depth) {
      Overlay overlay;
      add_ground_grid(overlay, camera, film, 8.5, depth);
      double sum = 0.0;
      for (const Overlay::Vertex& vertex : overlay.lines) sum += qAlpha(vertex.color);
      return sum;
    };
    const double open = alpha_of({});
    QVERIFY(open > 1000.0);
    Frame frame;
    frame.film = film;
    frame.depth.assign(100 * 80, 1.0F);
    QVERIFY(alpha_of(GridDepth{frame, camera}) < 0.6 * open);
    Camera moved = camera;
    moved.eye.x = 1.0;
    QCOMPARE(alpha_of(GridDepth{frame, moved}), open);
    frame.depth.assign(100 * 80, 1e9F);
    QCOMPARE(alpha_of(GridDepth{frame, camera}), open);
    // Far lines that run into each other are left out, seen from low above the ground.
    Overlay low;
    add_ground_grid(low, {{0.0, 0.5, 8.0}, {0.0, 0.5, 0.0}}, film, 8.0, {});
    QVERIFY(!low.lines.empty());
    for (const Overlay::Vertex& vertex : low.lines) {
      QVERIFY2(vertex.y > 41.0F, qPrintable(QString::number(vertex.y)));  // the horizon: 40
    }
    // Edge-on it would be one line.
    Overlay overlay;
    add_ground_grid(overlay, {{0.0, 0.0, 8.0}, {0.0, 0.0, 0.0}}, film, 8.0, {});
    QVERIFY(overlay.lines.empty());
  }

  void whether_it_shows_at_start_is_remembered() {
    TestWindow window;
    QVERIFY(StartPage::is_wanted());
    page_of(window).open();
    auto* box = page_of(window).findChild<QCheckBox*>("start_page_at_start");
    box->click();
    QVERIFY(!StartPage::is_wanted());
    box->click();
    QVERIFY(StartPage::is_wanted());
  }
};

BRUME_APP_SUITE("start_page", StartPageTest)
#include "start_page_test.moc"
