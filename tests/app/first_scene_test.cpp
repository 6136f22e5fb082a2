// What is seen first in a new scene: painted fog and imported meshes are lit, without a step that
// the user has not asked for.

#include <fstream>
#include <glm/geometric.hpp>
#include <numbers>

#include "app/commands/scene_part_command.h"
#include "app/import/scene_import.h"
#include "app/view/bounds.h"
#include "app/viewport/viewport.h"
#include "tests/app/test_window.h"

using namespace brume;

namespace {

namespace fs = std::filesystem;

const fs::path bunny = BRUME_RESOURCES "/meshes/bunny.obj";

// A window with a new scene.
class NewScene : public TestWindow {
 public:
  NewScene() {
    key(Qt::Key_N, Qt::ControlModifier);
    QTRY_VERIFY(document().file().empty());
  }

  Document& document() { return (*this)->document(); }
  const Light& light() { return document().scene().lights.at(0); }

  void import(const std::vector<fs::path>& files) {
    (*this)->import().import_files(files);
    auto* job = (*this)->findChild<BackgroundJob*>();
    QTRY_VERIFY(!job->is_running());
  }

  // The share of the picture that is neither black nor nearly so.
  double bright_share() {
    if (!settle()) return -1.0;
    const QImage picture = (*this)->viewport().frames().shown()->picture;
    int bright = 0;
    for (int y = 0; y < picture.height(); ++y) {
      for (int x = 0; x < picture.width(); ++x) bright += qGray(picture.pixel(x, y)) > 50 ? 1 : 0;
    }
    return static_cast<double>(bright) / (picture.width() * picture.height());
  }
};

}  // namespace

class FirstSceneTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void painted_fog_is_lit() {
    NewScene window;
    QCOMPARE(window.bright_share(), 0.0);
    const QPoint center = window->viewport().rect().center();
    window.key(Qt::Key_B);
    window.drag(center - QPoint(150, 0), center + QPoint(150, 0));
    QVERIFY(window.document().medium().size() > 1);
    QVERIFY(window.bright_share() > 0.02);
    QVERIFY(window.document().scene().lights == new_scene().lights);
  }

  void an_imported_mesh_is_framed_and_lit_in_one_step() {
    NewScene window;
    window.import({bunny});
    const Scene imported = window.document().scene();
    QCOMPARE(window.document().undo_stack().count(), 1);
    QCOMPARE(window.document().undo_stack().undoText(), QString("Import bunny.obj"));
    QVERIFY(window.bright_share() > 0.05);
    QVERIFY(window->viewport().camera() == imported.camera);

    const Sphere sphere = *bounding_sphere(imported);
    QVERIFY(glm::distance(imported.camera.target, sphere.center) < 1e-9);
    QVERIFY(glm::distance(imported.camera.eye, sphere.center) > sphere.radius);
    // White at the center would have a radiance of 1.
    const double distance = glm::distance(window.light().position, sphere.center);
    QVERIFY(distance > sphere.radius);
    const double radiance = window.light().intensity.x / (std::numbers::pi * distance * distance);
    QVERIFY(std::abs(radiance - 1.0) < 1e-9);

    window.key(Qt::Key_Z, Qt::ControlModifier);
    QVERIFY(window.document().scene() == new_scene());
    QVERIFY(!window.document().is_modified());
    window.document().undo_stack().redo();
    QVERIFY(window.document().scene() == imported);
    QVERIFY(window.bright_share() > 0.05);
  }

  void meshes_of_any_size_are_equally_bright() {
    NewScene window;
    std::vector<double> shares;
    for (const char* scale : {"0.001", "1", "1000"}) {
      const std::string s(scale);
      std::ofstream(window.file("wedge.obj"))
          << "v 0 0 0\nv " << s << " 0 0\nv 0 " << s << " 0\nf 1 2 3\n";
      window.import({window.file("wedge.obj")});
      shares.push_back(window.bright_share());
      window.document().create();
    }
    QVERIFY(shares[0] > 0.1);
    for (const double share : shares) QVERIFY(std::abs(share - shares[0]) < 0.01);
  }

  void meshes_of_one_step_are_framed_together() {
    NewScene window;
    std::ofstream(window.file("left.obj")) << "v -9 0 0\nv -8 0 0\nv -9 1 0\nf 1 2 3\n";
    std::ofstream(window.file("right.obj")) << "v 9 0 0\nv 8 0 0\nv 9 1 0\nf 1 3 2\n";
    window.import({window.file("left.obj"), window.file("right.obj")});
    QCOMPARE(window.document().scene().surfaces.size(), std::size_t{2});
    QVERIFY(std::abs(window.document().scene().camera.target.x) < 1e-9);
    QCOMPARE(window.document().undo_stack().count(), 1);
    window.document().undo_stack().undo();
    QVERIFY(window.document().scene() == new_scene());
  }

  void what_the_user_has_changed_stays() {
    NewScene window;
    Document& document = window.document();
    const auto import_leaves = [&](bool light, bool camera) {
      const Scene before = document.scene();
      const Camera view = window->viewport().camera();
      window.import({bunny});
      QCOMPARE(document.scene().lights == before.lights, light);
      QCOMPARE(document.scene().camera == before.camera, camera);
      QCOMPARE(window->viewport().camera() == view, camera);
      document.create();
    };
    import_leaves(false, false);

    Lights lights = document.scene().lights;
    lights[0].intensity *= 2.0;
    set_scene_part(document, lights, "Brighten");
    import_leaves(true, true);

    set_scene_part(document, Lights{}, "Delete light");
    import_leaves(true, true);

    window->viewport().camera_controller().drag(NavigationDrag::orbit, {100.0, 30.0});
    import_leaves(false, true);

    Camera camera;
    camera.eye.z = 7.0;
    set_scene_part(document, KeyedCamera{camera, {}}, "Set camera");
    window->viewport().camera_controller().reset();
    import_leaves(false, true);

    window.import({BRUME_RESOURCES "/environments/sunset.exr"});
    import_leaves(true, true);

    window.import({bunny, BRUME_RESOURCES "/environments/sunset.exr"});
    QVERIFY(document.scene().lights == new_scene().lights);
    QVERIFY(document.scene().camera == Camera());
  }
};

BRUME_APP_SUITE("first_scene", FirstSceneTest)
#include "first_scene_test.moc"
