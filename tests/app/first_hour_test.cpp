// A designer's first hour, by mouse and keys, from the start page to a film: a room, a model, two
// lights, a sky, ground fog, a hole in it, steam from a pot, keyframes, frames on disk. Nothing
// outside the window is needed but files to drop. With BRUME_PICTURES=FOLDER a picture of the
// window is kept after each step.

#include <QComboBox>
#include <QDropEvent>
#include <QLineEdit>
#include <QMimeData>
#include <QToolButton>
#include <QTreeWidget>
#include <QUrl>

#include "app/commands/objects/edit_objects.h"
#include "app/document/document.h"
#include "app/document/paths.h"
#include "app/document/time/timeline.h"
#include "app/export/render_queue.h"
#include "app/import/scene_import.h"
#include "app/view/camera/object_box.h"
#include "app/view/surface_picker.h"
#include "app/viewport/viewport.h"
#include "app/window/pages/start_page.h"
#include "core/io/scene/scene_file.h"
#include "core/scene/animation/animation.h"
#include "tests/app/file_jobs.h"
#include "tests/app/test_window.h"

using namespace brume;

namespace {

class Hour : public TestWindow {
 public:
  Hour() : TestWindow(small_scene(), {900, 700}) {}

  const Scene& scene() { return document().scene(); }

  // Keeps a picture of the window as it is at rest, if asked to.
  void picture(const QString& name) {
    const QString folder = qEnvironmentVariable("BRUME_PICTURES");
    if (folder.isEmpty()) return;
    QVERIFY(settle());
    QTest::qWait(100);  // the start page lays itself out twice
    QVERIFY((*this)->grab().save(
        QString("%1/%2_%3.png").arg(folder).arg(++step_, 2, 10, QChar('0')).arg(name)));
  }
  void command(const QString& words) {
    key(Qt::Key_F3);
    auto* line = (*this)->findChild<QLineEdit*>("command_words");
    QVERIFY(line);
    QTest::keyClicks(line, words);
    QTest::keyClick(line, Qt::Key_Return);
    QTRY_VERIFY(!(*this)->findChild<QLineEdit*>("command_words"));
    QCoreApplication::processEvents();
  }
  QPoint on_film(const glm::dvec3& point) { return film_position(view(), point); }
  // Drags an arrow of the handles of the selected object by some pixels.
  void drag_arrow(const glm::dvec3& axis, QPoint by) {
    const glm::dvec3 center = object_center(scene(), *document().object(), view().rays());
    // Beyond the ring in the middle, wherever the handles are.
    const QPointF middle = on_film(center);
    const QPointF along = QPointF(on_film(center + 0.2 * axis)) - middle;
    const double length = std::hypot(along.x(), along.y());
    const QPoint start = (middle + 45.0 * along / length).toPoint();
    QTest::mouseMove(&view(), start);
    drag(start, start + by);
  }

 private:
  int step_ = 0;
};

}  // namespace

class FirstHourTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void from_the_start_page_to_a_film() {
    Hour hour;
    // A room.
    hour->findChild<QAction*>("file.start_page")->trigger();
    hour.picture("start_page");
    auto* page = hour->findChild<StartPage*>();
    click(*page, "template_room");
    QTRY_VERIFY(page->isHidden());
    QVERIFY(!hour.scene().surfaces.empty());
    const auto saved_text = [&] {
      return document_to_json(hour.document().document_to_save(), "/");
    };
    const std::string before_all = saved_text();
    const std::size_t surfaces = hour.scene().surfaces.size();
    const std::size_t lights = hour.scene().lights.size();
    hour.picture("room");

    // A model, made smaller by a number and moved by its handles.
    drop(hour, {BRUME_RESOURCES "/meshes/teapot.obj"});
    QTRY_COMPARE(hour.scene().surfaces.size(), surfaces + 1);
    const ObjectRef pot{ObjectRef::Kind::surface, surfaces};
    auto* tree = hour->findChild<QTreeWidget*>("outliner_tree");
    QTreeWidgetItem* row =
        tree->findItems("teapot.obj", Qt::MatchExactly | Qt::MatchRecursive).at(0);
    tree->scrollToItem(row);
    QTest::mouseClick(tree->viewport(), Qt::LeftButton, {}, tree->visualItemRect(row).center());
    QVERIFY(hour.document().object() == pot);
    enter(hour, "surface_scale", "/30");
    QCOMPARE(hour.scene().surfaces.back().scale, 1.0 / 30.0);
    // On the table.
    enter(hour, "surface_position_x", "0.2");
    enter(hour, "surface_position_y", "0.75");
    enter(hour, "surface_position_z", "-0.9");
    hour.key(Qt::Key_G);
    hour.drag_arrow({1.0, 0.0, 0.0}, {12, 3});
    QVERIFY(hour.scene().surfaces.back().translate.x > 0.2);
    hour.key(Qt::Key_F2);
    QVERIFY(tree->findChild<QLineEdit*>("row_name"));
    tree->findChild<QLineEdit*>("row_name")->setText("pot");
    QTest::keyClick(tree->findChild<QLineEdit*>("row_name"), Qt::Key_Return);
    QTRY_COMPARE(hour.scene().surfaces.back().name, std::string("pot"));
    hour.picture("model");

    // Two lights, the second moved by its handle, and a sky.
    hour.key(Qt::Key_1, Qt::ControlModifier);
    hour.command("add spot");
    QCOMPARE(hour.scene().lights.size(), lights + 2);
    hour.key(Qt::Key_V);
    const glm::dvec3 old_place = hour.scene().lights.back().position;
    const QPoint sun = hour.on_film(old_place);
    if (hour.view().rect().contains(sun)) {
      QTest::mouseMove(&hour.view(), sun);
      hour.drag(sun, sun + QPoint(40, 10));
      QVERIFY(hour.scene().lights.back().position != old_place);
    }
    drop(hour, {BRUME_RESOURCES "/environments/sunset.exr"});
    QTRY_VERIFY(hour.scene().environment.has_value());
    hour.picture("lights_and_sky");

    // Fog on the ground, and a hole in it. Nothing compares fast pictures with the reference, which
    // would take most of this test.
    hour->findChild<QAction*>("airlight_fast")->trigger();
    hour.command("fog ground mist");
    QVERIFY(hour.document().medium().size() > 10);
    const auto density = [&] {
      double sum = 0.0;
      for (std::size_t i = 0; i < hour.document().medium().size(); ++i) {
        sum += hour.document().medium().gaussian(i).density;
      }
      return sum;
    };
    const double dense = density();
    hour.picture("ground_fog");
    hour.key(Qt::Key_E);
    const QPoint middle = hour.view().rect().center() + QPoint(0, 60);
    QTest::mouseMove(&hour.view(), middle);
    hour.drag(middle, middle + QPoint(80, 20));
    QVERIFY(density() < dense);
    hour.picture("hole");

    // Steam from the pot: an emitter, put in its place by numbers.
    hour.command("add emitter");
    QCOMPARE(hour.document().object()->kind, ObjectRef::Kind::emitter);
    const glm::dvec3 top = object_center(hour.scene(), pot, hour.view().rays());
    enter(hour, "emitter_position_y", QString::number(top.y));
    QVERIFY(std::abs(hour.scene().emitters.back().position.y - top.y) < 1e-3);

    // Keyframes of the spot: it brightens.
    hour.document().set_object(ObjectRef{ObjectRef::Kind::light, hour.scene().lights.size() - 1});
    hour->document().set_active_light(hour.scene().lights.size() - 1);
    auto* key = hour->findChild<QToolButton*>("light_intensity_key");
    key->click();
    hour->timeline().set_frame(6);
    key->click();
    QVERIFY(has_keys(hour.scene()));
    QVERIFY(!hour.scene().lights.back().keys.intensity.empty());
    hour.key(Qt::Key_Space);  // plays
    QVERIFY(hour->timeline().is_playing());
    QTRY_VERIFY(hour->timeline().frame() != 6);
    hour.key(Qt::Key_Space);
    hour.picture("steam_and_keys");

    // A film, small here.
    hour.document().save(hour.file("hour.brume"));
    enter(hour, "film_width", "48");
    enter(hour, "film_height", "32");
    enter(hour, "output_first", "0");
    enter(hour, "output_last", "2");
    auto* file = hour->findChild<QLineEdit*>("output_file");
    file->setFocus();
    file->selectAll();
    QTest::keyClicks(file, "film/hour.png");
    QTest::keyClick(file, Qt::Key_Return);
    hour.key(Qt::Key_F12, Qt::ControlModifier);
    auto& queue = *hour->findChild<RenderQueue*>();
    QVERIFY(QTest::qWaitFor(
        [&] {
          return !queue.items().empty() && queue.items().back().state == RenderQueue::State::done;
        },
        patience));
    for (const char* name : {"film/hour_0000.png", "film/hour_0002.png"}) {
      const QImage frame(to_qstring(hour.file(name)));
      QCOMPARE(frame.size(), QSize(48, 32));
      int brightest = 0;
      for (int x = 0; x < 48; ++x) brightest = std::max(brightest, qGray(frame.pixel(x, 16)));
      QVERIFY2(brightest > 20, name);
    }
    hour.picture("film");
    const Scene saved = load_scene(hour.file("hour.brume"));
    QCOMPARE(saved.surfaces.back().name, std::string("pot"));
    // All of it is one history.
    hour.document().undo_stack().setIndex(0);
    hour->timeline().set_frame(0);
    QCOMPARE(saved_text(), before_all);
  }
};

BRUME_APP_SUITE("first_hour", FirstHourTest)

#include "first_hour_test.moc"
