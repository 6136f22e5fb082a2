// Imported things are shown at their size; those far too large or small are offered to be
// changed.

#include <QPushButton>
#include <fstream>

#include "app/import/scene_import.h"
#include "app/view/camera/bounds.h"
#include "app/view/surface_picker.h"
#include "app/viewport/viewport.h"
#include "app/window/pages/message_bar.h"
#include "brume/mesh_arrays.h"
#include "tests/app/file_jobs.h"

using namespace brume;

namespace {

// A floor 8 wide at a height of -1, which the view looks at from 5 away.
Scene scene_with_floor() {
  Scene scene = tiny_scene();
  Surface floor;
  floor.primitive = Primitive{Primitive::Shape::plane, glm::dvec3(8.0)};
  floor.mesh = mesh_of(*floor.primitive);
  floor.translate = {0.0, -1.0, 0.0};
  floor.name = "floor";
  scene.surfaces.push_back(floor);
  scene.camera.eye = {0.0, 1.0, 5.0};
  scene.camera.target = {0.0, 0.0, 0.0};
  return scene;
}

// A wedge that is as high as wide, above the ground.
void import_wedge(TestWindow& window, double size) {
  std::ofstream(window.file("wedge.obj")) << "v 0 " << size << " 0\nv " << size << " " << size
                                          << " 0\nv 0 " << 2 * size << " 1e-6\nf 1 2 3\n";
  window->file_jobs().import().import_file(window.file("wedge.obj"));
  QCOMPARE(wait(window), "");
}

bool picks(TestWindow& window) {
  return QTest::qWaitFor([&] { return window.view().surfaces().is_ready(); }, patience);
}

}  // namespace

class ImportSizeTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void what_suits_is_selected_and_framed() {
    TestWindow window(scene_with_floor());
    import_wedge(window, 1.0);
    QVERIFY(window.document().object() == ObjectRef(ObjectRef::Kind::surface, 1));
    const Sphere sphere = *bounding_sphere(std::span(window.scene().surfaces).subspan(1));
    QVERIFY(glm::distance(window.view().camera().target, sphere.center) < 1e-9);
    QVERIFY(bar(window).isHidden());
  }

  void what_is_too_large_is_offered_other_units_and_to_fit() {
    TestWindow window(scene_with_floor());
    Document& document = window.document();
    const Scene first_scene = window.scene();
    import_wedge(window, 300.0);
    QVERIFY(bar(window).isVisible());
    QVERIFY(bar(window).message().contains("300 × 300"));
    QVERIFY(picks(window));

    click(*window, "import_cm");
    QCOMPARE(last_step(document), "Read wedge.obj in cm");
    QCOMPARE(window.scene().surfaces[1].scale, 0.01);
    QVERIFY(bar(window).message().contains("3 × 3"));
    click(*window, "import_inch");
    QCOMPARE(window.scene().surfaces[1].scale, 0.0254);
    QVERIFY(picks(window));
    click(*window, "import_drop");
    QCOMPARE(last_step(document), "Drop wedge.obj on the floor");
    QVERIFY(std::abs(world_box(window.scene().surfaces[1]).low.y + 1.0) < 1e-6);
    QVERIFY(picks(window));
    click(*window, "import_fit");
    const MeshBox box = world_box(window.scene().surfaces[1]);
    QVERIFY(std::abs(box.low.y + 1.0) < 1e-6);
    QVERIFY(std::abs(box.low.x + box.high.x) < 1e-6);
    QVERIFY(box.high.x - box.low.x > 0.5 && box.high.x - box.low.x < 2.5);
    QCOMPARE(step_count(document), 5);
    QVERIFY(is_undone(document, first_scene));
    QVERIFY(bar(window).isHidden());
  }

  void what_is_too_small_is_offered_the_same() {
    TestWindow window(scene_with_floor());
    import_wedge(window, 0.001);
    QVERIFY(bar(window).isVisible());
    click(*window, "import_fit");
    const MeshBox box = world_box(window.scene().surfaces[1]);
    QVERIFY(box.high.x - box.low.x > 0.5);
  }

  void a_selected_surface_drops_on_the_floor() {
    TestWindow window(scene_with_floor());
    import_wedge(window, 1.0);
    QVERIFY(picks(window));
    window.key(Qt::Key_End);
    QVERIFY(std::abs(world_box(window.scene().surfaces[1]).low.y + 1.0) < 1e-6);
    QCOMPARE(step_count(window.document()), 2);
  }

 private:
  static MessageBar& bar(TestWindow& window) { return *window->findChild<MessageBar*>(); }
};

BRUME_APP_SUITE("import_size", ImportSizeTest)
#include "import_size_test.moc"
