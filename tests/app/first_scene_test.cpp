// A new scene shows something at once: painted fog and imported meshes are lit, without a step that
// the user has not asked for.

#include <fstream>
#include <glm/geometric.hpp>
#include <numbers>

#include "app/commands/scene_part_command.h"
#include "app/document/paths.h"
#include "app/export/frame_export.h"
#include "app/frames/headlight.h"
#include "app/import/scene_import.h"
#include "app/view/camera/bounds.h"
#include "app/viewport/legend.h"
#include "app/viewport/viewport.h"
#include "app/window/file_jobs.h"
#include "app/window/frame_output.h"
#include "tests/app/test_window.h"

using namespace brume;

namespace {

namespace fs = std::filesystem;

const fs::path bunny = BRUME_RESOURCES "/meshes/bunny.obj";

// The share of a picture that is neither black nor nearly so.
double bright_share_of(const QImage& picture) {
  int bright = 0;
  for (int y = 0; y < picture.height(); ++y) {
    for (int x = 0; x < picture.width(); ++x) bright += qGray(picture.pixel(x, y)) > 50 ? 1 : 0;
  }
  return static_cast<double>(bright) / (picture.width() * picture.height());
}

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
    (*this)->file_jobs().import().import_files(files);
    BackgroundJob* job = &(*this)->file_jobs().job();
    QTRY_VERIFY(!job->is_running());
  }

  double bright_share() {
    return settle() ? bright_share_of((*this)->viewport().frames().shown()->picture) : -1.0;
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
    QVERIFY(window.scene().lights == new_scene().lights);
  }

  void an_imported_mesh_is_framed_and_lit_in_one_step() {
    NewScene window;
    window.import({bunny});
    const Scene imported = window.scene();
    QCOMPARE(step_count(window.document()), 1);
    QCOMPARE(last_step(window.document()), "Import bunny.obj");
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
    QVERIFY(window.scene() == new_scene());
    QVERIFY(!window.document().is_modified());
    window.document().undo_stack().redo();
    QVERIFY(window.scene() == imported);
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
    QCOMPARE(window.scene().surfaces.size(), 2u);
    QVERIFY(std::abs(window.scene().camera.target.x) < 1e-9);
    QCOMPARE(step_count(window.document()), 1);
    window.document().undo_stack().undo();
    QVERIFY(window.scene() == new_scene());
  }

  void a_mesh_after_an_undone_one_is_framed() {
    NewScene window;
    std::ofstream(window.file("far.obj")) << "v 90 0 0\nv 91 0 0\nv 90 1 0\nf 1 2 3\n";
    window.import({window.file("far.obj")});
    window.document().undo_stack().undo();
    window.import({bunny});
    QVERIFY(window->viewport().camera() == window.scene().camera);
    QVERIFY(window.bright_share() > 0.05);
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
      QVERIFY(window->viewport().camera() != view);  // what is imported is framed
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

    QVERIFY(document.scene() == new_scene());
    window.import({bunny, BRUME_RESOURCES "/environments/sunset.exr"});
    QVERIFY(document.scene().lights == new_scene().lights);
    QVERIFY(document.scene().camera == new_scene().camera);
  }

  void what_nothing_lights_is_shown_by_a_headlight() {
    NewScene window;
    Document& document = window.document();
    window.import({bunny});
    const auto* legend = window->viewport().findChild<Legend*>();
    const auto says_so = [&] {
      return legend->isVisible() && legend->scale().title.contains("shown by a headlight");
    };
    QVERIFY(window.bright_share() > 0.05);
    QVERIFY(!says_so());

    Lights lights = document.scene().lights;
    lights[0].on = false;
    set_scene_part(document, lights, "Turn off");
    QVERIFY(window.bright_share() > 0.05);
    QVERIFY(says_so());
    QVERIFY(document.scene().lights == lights);

    // From behind as well.
    window->viewport().camera_controller().drag(NavigationDrag::orbit, {500.0, 0.0});
    QVERIFY(window.bright_share() > 0.05);
    window->viewport().frames().set_mode(ViewMode::airlight);
    QVERIFY(says_so());
    window->viewport().frames().set_mode(ViewMode::optical_depth);
    QVERIFY(!says_so());
    window->viewport().frames().set_mode(ViewMode::final);
    invoke(window, "airlight_paper");
    QCOMPARE(window.bright_share(), 0.0);
    QVERIFY(!says_so());
    invoke(window, "airlight_auto");
    QVERIFY(window.settle());
    QVERIFY(says_so());

    QSignalSpy exported(window->findChild<FrameExport*>(), &FrameExport::finished);
    type(window, "output_file", to_qstring(window.file("dark.png")));
    window.key(Qt::Key_F12);
    QTRY_COMPARE(exported.count(), 1);
    QCOMPARE(bright_share_of(QImage(to_qstring(window.file("dark.png")))), 0.0);
    document.undo_stack().undo();

    document.undo_stack().undo();
    QVERIFY(window.settle());
    QVERIFY(!says_so());
  }

  void light_from_anywhere_turns_the_headlight_off() {
    Scene scene = small_scene();
    QVERIFY(!is_unlit(scene));
    scene.lights[0].on = false;
    QVERIFY(is_unlit(scene));
    const auto lit_by = [&](auto change) {
      Scene lit = scene;
      change(lit);
      return !is_unlit(lit);
    };
    QVERIFY(lit_by([](Scene& s) { s.environment.emplace(); }));
    QVERIFY(lit_by([](Scene& s) { s.emitters.emplace_back(); }));
    QVERIFY(lit_by([](Scene& s) { s.sequences.emplace_back(); }));
    QVERIFY(lit_by([](Scene& s) {
      s.medium.append({glm::dvec3(0.0), 1.0, 1.0, {{}, glm::dvec3(1.0)}});
    }));
    QVERIFY(!lit_by([](Scene& s) { s.lights.clear(); }));
    QVERIFY(!is_unlit(Scene()));  // nothing to see
  }
};

BRUME_APP_SUITE("first_scene", FirstSceneTest)
#include "first_scene_test.moc"
