// The last operation is adjusted, and stays one step.

#include <QFrame>
#include <QStatusBar>
#include <QToolButton>

#include "app/commands/gaussians/add_fog.h"
#include "app/commands/gaussians/select_command.h"
#include "app/commands/objects/edit_emitters.h"
#include "app/import/scene_import.h"
#include "app/panels/forms/adjust_panel.h"
#include "app/view/surface_picker.h"
#include "app/viewport/viewport.h"
#include "app/widgets/value_field.h"
#include "app/window/dialogs/simplify_dialog.h"
#include "brume/mesh_arrays.h"
#include "core/math/random_source.h"
#include "tests/app/file_jobs.h"

using namespace brume;

namespace {

class OperationWindow : public TestWindow {
 public:
  using TestWindow::TestWindow;

  AdjustPanel& panel() { return *(*this)->findChild<AdjustPanel*>(); }
  void choose(const char* name) { (*this)->findChild<QAction*>(name)->trigger(); }
  std::size_t count() { return document().medium().size(); }
  void simplify() {
    choose("edit.simplify");
    enter(*this, "simplify_error", "2");
    brume::click(*(*this)->findChild<SimplifyDialog*>(), "simplify_now");
  }
  // The error is in percent.
  void adjust_error(double error) {
    LastOperation& last = document().last_operation();
    auto numbers = std::any_cast<SimplifyNumbers>(last.operation()->numbers);
    numbers.max_error = error;
    last.adjust(numbers);
  }
};

// 300 Gaussians that overlap.
Scene crowded_scene() {
  Scene scene = small_scene();
  scene.medium = {};
  RandomSource random(3);
  for (int i = 0; i < 300; ++i) scene.medium.append({0.4 * random.in_ball(), 0.15, 0.2});
  return scene;
}

}  // namespace

class LastOperationTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void ready_made_fog_is_adjusted_as_one_step() {
    OperationWindow window;
    Document& document = window.document();
    const Scene first_scene = window.scene();
    QVERIFY(window.panel().isHidden());
    window.choose("fog.ground_mist");
    QVERIFY(window.panel().isVisible());
    QCOMPARE(label_text(window, "adjust_title"), "Ground Mist");
    const std::size_t coarse = window.count();
    const double spacing = value(window, "adjust_spacing").toDouble();
    enter(window, "adjust_spacing", QString::number(0.7 * spacing));
    QVERIFY(window.count() > coarse);
    QCOMPARE(step_count(document), 1);
    QCOMPARE(last_step(document), "Add ground mist");
    QCOMPARE(document.selection().size(), window.count() - first_scene.medium.size());
    const double density = document.medium().densities().back();
    enter(window, "adjust_density", "*2");
    QVERIFY(std::abs(document.medium().densities().back() / density - 2.0) < 0.01);
    const std::size_t fine = window.count();
    const QString kept_spacing = value(window, "adjust_spacing");
    enter(window, "adjust_spacing", "1e-6");  // too many: refused, and what was made stays
    QCOMPARE(window.count(), fine);
    QCOMPARE(value(window, "adjust_spacing"), kept_spacing);
    QVERIFY(window.panel().isVisible());
    enter(window, "adjust_spacing", QString::number(spacing));
    QCOMPARE(window.count(), coarse);
    QCOMPARE(step_count(document), 1);
    document.undo_stack().undo();
    QVERIFY(window.scene() == first_scene);
    QVERIFY(window.panel().isHidden());
  }

  void a_drag_of_a_number_is_live_and_one_step() {
    OperationWindow window;
    window.choose("fog.haze");
    const double first_value = window.document().medium().homogeneous_density();
    drag_title(window, "adjust_density", 40);
    QVERIFY(window.document().medium().homogeneous_density() > first_value);
    QCOMPARE(step_count(window.document()), 1);
    QVERIFY(window.panel().isVisible());
  }

  void something_else_that_is_done_takes_the_panel_away() {
    OperationWindow window;
    window.choose("fog.steam");
    QVERIFY(window.panel().isVisible());
    select_gaussians(window.document(), {1});
    QVERIFY(window.panel().isHidden());
    window.choose("fog.steam");
    QVERIFY(window.panel().isVisible());
    click(window, "adjust_close");
    QVERIFY(window.panel().isHidden());
    QCOMPARE(last_step(window.document()), "Add steam");
  }

  void shapes_and_emitters_have_it_too() {
    OperationWindow window;
    add_fog_shape(window.document(), FogShape{.size = glm::dvec3(0.4)});
    QCOMPARE(label_text(window, "adjust_title"), "Add fog box");
    const std::size_t count = window.count();
    enter(window, "adjust_size_y", "0.8");
    QVERIFY(window.count() > count);

    add_emitter(window.document(), glm::dvec3(0.0), 1.0);
    auto* rate = window->findChild<ValueField*>("adjust_rate");
    QVERIFY(rate->isVisible());
    QVERIFY(window.panel().rect().contains(
        QRect(rate->mapTo(&window.panel(), QPoint(0, 0)), rate->size())));
    enter(window, "adjust_rate", "7");
    QCOMPARE(window.scene().emitters.size(), 1u);
    QCOMPARE(window.scene().emitters[0].rate, 7.0);
    QVERIFY(window.document().object() == ObjectRef(ObjectRef::Kind::emitter, 0));
    QCOMPARE(step_count(window.document()), 2);
  }

  void simplifying_is_done_again_with_another_error() {
    OperationWindow window(crowded_scene());
    window.simplify();
    QTRY_COMPARE(step_count(window.document()), 1);
    const std::size_t exact = window.count();
    QVERIFY(window.panel().isVisible());
    enter(window, "adjust_error", "20");
    QTRY_VERIFY(window.count() < exact);
    QCOMPARE(step_count(window.document()), 1);
    QVERIFY(window.panel().isVisible());
    enter(window, "adjust_error", "2");
    QTRY_COMPARE(window.count(), exact);
  }

  void a_simplification_stays_until_there_is_another() {
    OperationWindow window(crowded_scene());
    window.simplify();
    QTRY_COMPARE(step_count(window.document()), 1);
    const std::size_t few = window.count();
    QVERIFY(few < crowded_scene().medium.size());
    window.adjust_error(1e-6);      // within which nothing can be merged
    QCOMPARE(window.count(), few);  // while it is computed
    QVERIFY(window->file_jobs().adjusting().is_running());
    QTRY_VERIFY(!window->file_jobs().adjusting().is_running());
    const QString message = window->statusBar()->currentMessage();
    QVERIFY2(message.contains("No Gaussians"), qPrintable(message));
    QCOMPARE(window.count(), few);
    QCOMPARE(step_count(window.document()), 1);
    QVERIFY(window.panel().isVisible());
    window.document().create();
    QVERIFY(window.panel().isHidden());
  }

  void a_late_result_is_not_that_of_another_operation() {
    OperationWindow window(crowded_scene());
    window.simplify();
    QTRY_COMPARE(step_count(window.document()), 1);
    const std::size_t few = window.count();
    window.adjust_error(20.0);
    add_emitter(window.document(), glm::dvec3(0.0), 1.0);
    QTRY_VERIFY(!window->file_jobs().adjusting().is_running());
    QCoreApplication::processEvents();
    QCOMPARE(window.count(), few);
    QCOMPARE(step_count(window.document()), 2);
    enter(window, "adjust_rate", "7");
    QCOMPARE(window.scene().emitters.size(), 1u);
    QCOMPARE(step_count(window.document()), 2);
  }

  void an_imported_mesh_is_placed() {
    OperationWindow window;
    window->file_jobs().import().import_file(BRUME_RESOURCES "/meshes/bunny.obj");
    QCOMPARE(wait(window), "");
    enter(window, "adjust_scale", "2");
    enter(window, "adjust_position_y", "1");
    QCOMPARE(window.scene().surfaces.size(), 1u);
    QCOMPARE(window.scene().surfaces[0].scale, 2.0);
    QCOMPARE(window.scene().surfaces[0].translate, glm::dvec3(0, 1, 0));
    QCOMPARE(step_count(window.document()), 1);
    QVERIFY(window.document().object() == ObjectRef(ObjectRef::Kind::surface, 0));
  }

  // Only small handles, until something else is done.
  void what_was_made_is_drawn_quietly() {
    OperationWindow window;
    const auto lines = [&window] {
      Overlay overlay;
      window.view().shown_handles().draw(overlay);
      return overlay.lines.size();
    };
    window.choose("fog.steam");
    QVERIFY(window.document().selection().size() > 10);
    QCOMPARE(lines(), 0u);
    window.view().set_hovered(window.document().selection().front());
    QVERIFY(lines() > 0u);
    window.view().set_hovered(std::nullopt);
    click(window, "adjust_close");
    QVERIFY(lines() > 0u);
  }

  void a_crowd_of_handles_leaves_room() {
    Scene scene = small_scene();
    RandomSource random(3);
    for (int i = 0; i < 5000; ++i) scene.medium.append({0.5 * random.in_ball(), 0.05, 0.01});
    OperationWindow window(scene);
    Overlay overlay;
    window.view().shown_handles().draw(overlay);
    QVERIFY(overlay.dots.size() > 20 && overlay.dots.size() < 1500);
  }
};

BRUME_APP_SUITE("last_operation", LastOperationTest)
#include "last_operation_test.moc"
