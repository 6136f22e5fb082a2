// Moving things: emitters, the timeline, and the airbrush.

#include <QCheckBox>
#include <QDockWidget>
#include <QLabel>
#include <QPushButton>
#include <QSpinBox>
#include <QStatusBar>
#include <QToolButton>
#include <glm/geometric.hpp>

#include "app/commands/gaussians/edit_medium.h"
#include "app/commands/objects/edit_emitters.h"
#include "app/document/time/timeline.h"
#include "app/files/scene_files.h"
#include "app/panels/forms/key_button.h"
#include "app/tools/brushes/airbrush_tool.h"
#include "app/tools/emitter_tool.h"
#include "app/tools/tool_box.h"
#include "app/view/drawing/overlay.h"
#include "app/viewport/viewport.h"
#include "app/widgets/number_field.h"
#include "app/widgets/value_field.h"
#include "app/window/pages/message_bar.h"
#include "brume/at_time.h"
#include "brume/limits.h"
#include "brume/mesh_arrays.h"
#include "core/io/scene/scene_file.h"
#include "core/scene/animation/particles.h"
#include "tests/app/desk.h"
#include "tests/app/test_window.h"

using namespace brume;

namespace {

std::size_t shown_gaussians(TestWindow& window) {
  return window.shown().request.scene->medium.size();
}

// Holds the left button down at a place until the medium has more than some Gaussians.
void hold(Desk& desk, QPoint at, std::size_t count) {
  desk.press(at);
  QTRY_VERIFY(desk.document().medium().size() > count);
  desk.release(at);
}

}  // namespace

class AnimationTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void an_emitter_is_placed_moved_and_deleted() {
    Desk desk;
    Document& document = desk.document();
    desk.key(Qt::Key_P);
    const QPoint at(200, 300);
    desk.click(at);
    QCOMPARE(last_step(document), "Add emitter 1");
    const glm::dvec3 on_film = desk.view().rays().project(document.scene().emitters.at(0).position);
    QVERIFY(std::hypot(on_film.x - at.x(), on_film.y - at.y()) < 1.0);
    QCOMPARE(desk.view().shown_scene()->medium.size(), 6u);  // one is born at time 0
    desk.drag(at, at + QPoint(40, -10));
    QCOMPARE(last_step(document), "Move emitter 1");
    QCOMPARE(step_count(document), 2);
    const Emitter moved = document.scene().emitters[0];
    const glm::dvec3 moved_to = desk.view().rays().project(moved.position);
    QVERIFY(std::hypot(moved_to.x - on_film.x - 40.0, moved_to.y - on_film.y + 10.0) < 1.0);
    QVERIFY(is_cancelled_by_escape(desk.view(), document, at + QPoint(40, -10), at));
    enter(desk, "emitter_rate", "50");
    enter(desk, "emitter_lifetime", "1.5");
    enter(desk, "emitter_seed", "42");
    enter(desk, "emitter_density_birth", "-1");  // refused
    QCOMPARE(document.scene().emitters[0].rate, 50.0);
    QCOMPARE(document.scene().emitters[0].seed, std::int64_t{42});
    QCOMPARE(step_count(document), 5);
    click(desk, "delete_emitter");
    QVERIFY(document.scene().emitters.empty());
  }

  void gaussians_beyond_the_limit_are_refused() {
    Scene scene = small_scene();
    const Emitter full{.rate = 1e9, .lifetime = 1e3};
    scene.emitters.assign(99, full);
    scene.emitters.push_back({.rate = 99'989.0, .lifetime = 1.0});
    QCOMPARE(gaussian_count(scene), limits::gaussians - 5);
    TestWindow window(scene);
    Document& document = window->document();
    const Scene before = document.scene();
    const auto* bar = window->findChild<MessageBar*>();
    const std::vector<Gaussian> gaussians(6);
    add_gaussians(document, gaussians, "Paste");
    QVERIFY2(bar->message().contains("10,000,001 Gaussians"), qUtf8Printable(bar->message()));
    QVERIFY(document.scene() == before);
    add_gaussians(document, std::span(gaussians).first(5), "Paste");
    QCOMPARE(step_count(document), 1);

    document.set_active_emitter(99);
    window.key(Qt::Key_P);
    enter(window, "emitter_rate", "100000");
    QVERIFY(bar->message().contains("10,000,010 Gaussians"));
    QCOMPARE(document.scene().emitters[99].rate, 99'989.0);
    auto* rate = window->findChild<ValueField*>("emitter_rate")->findChild<NumberField*>();
    QCOMPARE(rate->text().toDouble(), 99'989.0);
    enter(window, "emitter_rate", "1000");
    QCOMPARE(document.scene().emitters[99].rate, 1000.0);
    QCOMPARE(step_count(document), 2);
    QVERIFY(is_undone(document, before));
  }

  void an_emitter_of_the_menu_is_chosen_previewed_and_counts_as_fog() {
    Scene scene = small_scene();
    scene.medium = {};
    TestWindow window(scene);
    const auto hint = [&] {
      for (const QLabel* label : window->statusBar()->findChildren<QLabel*>()) {
        if (label->text().startsWith("No fog yet")) return true;
      }
      return false;
    };
    QVERIFY(hint());
    set_homogeneous_density(window->document(), 0.1, no_merge);
    QVERIFY(!hint());
    window->document().undo_stack().undo();
    QVERIFY(hint());
    auto* panel = window->findChild<QDockWidget*>("emitters_dock");
    panel->hide();
    invoke(window, "add.emitter");
    QVERIFY(!hint());
    QCOMPARE(window->document().object(), (ObjectRef{ObjectRef::Kind::emitter, 0}));
    QVERIFY(panel->isVisible());
    // Outlines show particles while there are hardly any.
    const auto lines = [&] {
      Overlay overlay;
      window->tools().tool().draw(overlay, window->viewport().rays());
      return overlay.lines.size();
    };
    const std::size_t previewed = lines();
    window->timeline().set_frame(60);
    const std::size_t running = lines();
    QVERIFY(previewed > running + 100);
    // Neither its rate, which is 0 now, nor the time hides what it will emit.
    enter(window, "emitter_start", "5");
    QVERIFY(lines() > running + 100);
    enter(window, "emitter_start", "1");
    QVERIFY(lines() < running + 100);
  }

  void an_emitter_starts_and_ends_by_keyframes_of_its_rate() {
    Scene scene = small_scene();
    scene.emitters.push_back({.rate = 30.0, .lifetime = 0.5});
    Desk desk(scene);
    Document& document = desk.document();
    const auto emitter = [&]() -> const Emitter& { return document.scene().emitters[0]; };
    const auto born_by = [&](double time) { return particles_at(emitter(), time).size(); };
    enter(desk, "emitter_start", "1");
    QCOMPARE(last_step(document), "Set start of emitter 1");
    QVERIFY(born_by(0.9) <= 1 && born_by(1.4) > 10);
    QCOMPARE(value(desk, "emitter_start"), "1");
    click(desk, "emitter_ends");
    enter(desk, "emitter_end", "2");
    QVERIFY(born_by(1.9) > 10);
    QCOMPARE(born_by(2.6), 0u);
    enter(desk, "emitter_start", "0.5");
    QVERIFY(born_by(0.9) > 10);
    QCOMPARE(value(desk, "emitter_end"), "2");
    click(desk, "emitter_ends");
    QVERIFY(born_by(2.6) > 10);
    enter(desk, "emitter_start", "0");
    QVERIFY(emitter() == scene.emitters[0]);
  }

  void start_and_end_leave_a_rate_with_other_keyframes() {
    Scene scene = small_scene();
    const auto add = [&scene](const Keys<double>& rate) {
      scene.emitters.emplace_back().keys.rate = rate;
    };
    const Interpolation held = Interpolation::constant;
    add({{1.0, 10.0}, {1.5, 20.0}, {3.0, 30.0}});
    add({{0.0, 0.0}, {2.0, 100.0}, {4.0, 0.0}});
    add({{0.0, 10.0, held}, {1.0, 100.0, held}, {2.0, 40.0, held}, {8.0, 70.0, held}});
    add({{0.0, 0.0, held}, {1.0, 100.0, held}, {2.0, 0.0}});
    add({});
    scene.emitters.back().rate = 0.0;
    Desk desk(scene);
    const Emitters before = desk.scene().emitters;
    for (std::size_t k = 0; k < before.size(); ++k) {
      desk.document().set_active_emitter(k);
      auto* ends = desk.findChild<QCheckBox*>("emitter_ends");
      QVERIFY(!ends->isEnabled());
      QVERIFY(ends->toolTip().contains("dope sheet"));
      QTest::mouseClick(ends, Qt::LeftButton);
      enter(desk, "emitter_start", "5");
      enter(desk, "emitter_end", "0.5");
      auto* title = desk.findChild<QLabel*>("emitter_start_title");
      QVERIFY(title->toolTip().contains("dope sheet"));
      drag_mouse(*title, {1, 1}, {251, 1});
      QVERIFY(desk.scene().emitters[k] == before[k]);
    }
    QCOMPARE(step_count(desk.document()), 0);
  }

  void a_start_that_passes_the_end_returns_it() {
    Scene scene = small_scene();
    scene.emitters.push_back({.rate = 30.0});
    Desk desk(scene);
    enter(desk, "emitter_start", "1");
    click(desk, "emitter_ends");
    enter(desk, "emitter_end", "5");
    const Emitter before = desk.scene().emitters[0];
    auto* title = desk.findChild<QLabel*>("emitter_start_title");
    QTest::mousePress(title, Qt::LeftButton, {}, {1, 1});
    move_mouse(*title, {301, 1});
    QCOMPARE(value(desk, "emitter_start"), "7");
    QVERIFY(desk.scene().emitters[0].keys.rate.back().time > 7.0);
    move_mouse(*title, {51, 1});
    QCOMPARE(value(desk, "emitter_start"), "2");
    QCOMPARE(value(desk, "emitter_end"), "5");
    move_mouse(*title, {1, 1});
    QTest::mouseRelease(title, Qt::LeftButton);
    QVERIFY(desk.scene().emitters[0] == before);
  }

  void starts_and_ends_are_times_that_files_have() {
    Scene scene = small_scene();
    scene.emitters.push_back({.rate = 30.0});
    Desk desk(scene);
    enter(desk, "emitter_start", "5e9");
    QVERIFY(desk.scene().emitters[0] == scene.emitters[0]);
    enter(desk, "emitter_start", "999999999");
    click(desk, "emitter_ends");
    QCOMPARE(desk.scene().emitters[0].keys.rate.back().time, 1e9);
    enter(desk, "emitter_end", "5e9");
    QCOMPARE(desk.scene().emitters[0].keys.rate.back().time, 1e9);
    // The fields know their keyframes again in the file.
    desk.document().save(desk.file("late.brume"));
    desk.open("late.brume");
    QCOMPARE(value(desk, "emitter_start"), "999999999");
    QVERIFY(desk.findChild<QCheckBox*>("emitter_ends")->isChecked());
  }

  void noise_moves_with_the_wind() {
    Scene scene = small_scene();
    scene.optics.noise = {.amplitude = 0.5, .velocity = {1, 0, 0}};
    TestWindow window(scene);
    QVERIFY(window.settle());
    const std::vector<float> before = window.shown().frame.beauty;
    window->timeline().set_frame(15);
    QVERIFY(window.settle());
    QCOMPARE(window.shown().frame.time, 0.5);
    QVERIFY(window.shown().frame.beauty != before);
    QVERIFY(!window->document().is_modified());
  }

  void the_picture_follows_the_timeline() {
    Scene scene = small_scene();
    scene.emitters.push_back({.rate = 30.0, .lifetime = 1.0});
    TestWindow window(scene);
    QVERIFY(window.settle());
    QCOMPARE(shown_gaussians(window), 6u);
    window->timeline().set_frame(15);
    QVERIFY(window.settle());
    QCOMPARE(window.shown().request.scene->time, 0.5);
    QCOMPARE(shown_gaussians(window), 5 + particles_at(window.scene().emitters[0], 0.5).size());
    QVERIFY(!window->document().is_modified());
    window.key(Qt::Key_Period);
    QCOMPARE(window->timeline().frame(), 16);
    window.key(Qt::Key_Comma);
    window.key(Qt::Key_Comma);
    QCOMPARE(window->timeline().frame(), 14);
    // The particles shown can be baked.
    trigger(window, "Bake");
    const auto particles = particles_at(scene.emitters[0], 14 / 30.0);
    QCOMPARE(last_step(window->document()), QString("Bake %1 Gaussians").arg(particles.size()));
    QVERIFY(window->document().medium().gaussian(5) == particles[0]);
  }

  // The same key is not found again and again.
  void a_key_between_frames_is_passed() {
    TestWindow window;
    Timeline& timeline = window->timeline();
    timeline.set_frames_per_second(25.0);
    auto* button = window->findChild<KeyButton*>("camera_roll_key");
    timeline.set_frame(20);
    Q_EMIT button->time_asked_for(0.5);
    QCOMPARE(timeline.frame(), 12);
    timeline.set_frame(13);
    Q_EMIT button->time_asked_for(0.5);
    QCOMPARE(timeline.frame(), 12);
    Q_EMIT button->time_asked_for(0.5);
    QCOMPARE(timeline.frame(), 13);
    Q_EMIT button->time_asked_for(1.16);
    QCOMPARE(timeline.frame(), 29);
  }

  void it_plays_loops_and_stops() {
    TestWindow window;
    Timeline& timeline = window->timeline();
    timeline.set_range(10, 16);
    window.key(Qt::Key_Space);
    QVERIFY(timeline.is_playing());
    QVERIFY(timeline.frame() >= 10);
    QTRY_VERIFY(timeline.frame() > 12);
    QTRY_VERIFY(timeline.frame() < 12);  // from the first again
    window.key(Qt::Key_Space);
    QVERIFY(!timeline.is_playing());
    window->findChild<QCheckBox*>("loop")->setChecked(false);
    click(window, "play");
    QTRY_VERIFY(!timeline.is_playing());
    QCOMPARE(timeline.frame(), 16);
    window->document().undo_stack().undo();
    timeline.set_range(5, 2);
    QCOMPARE(timeline.last(), 5);
    window->files().create();
    QCOMPARE(timeline.frame(), 0);
  }

  void range_and_loop_are_of_the_scene() {
    Desk desk;
    Document& document = desk.document();
    Timeline& timeline = desk.timeline();
    desk.findChild<QSpinBox*>("last_frame_of_range")->setValue(48);
    desk.findChild<QSpinBox*>("first_frame_of_range")->setValue(12);
    desk.findChild<QCheckBox*>("loop")->setChecked(false);
    QCOMPARE(step_count(document), 3);
    QVERIFY(document.scene().playback == (Playback{12, 48, false}));
    QVERIFY(document.is_modified());
    document.save(desk.file("range.brume"));
    document.undo_stack().undo();
    QVERIFY(timeline.loops());
    document.undo_stack().setIndex(0);
    QCOMPARE(timeline.first(), 0);
    QCOMPARE(timeline.last(), 120);
    document.undo_stack().setIndex(3);
    QVERIFY(!document.is_modified());
    desk.open("range.brume");
    QCOMPARE(timeline.first(), 12);
    QCOMPARE(timeline.last(), 48);
    QVERIFY(!timeline.loops());
    QCOMPARE(desk.findChild<QSpinBox*>("first_frame_of_range")->value(), 12);
    desk.findChild<QSpinBox*>("last_frame_of_range")
        ->setValue(5);  // no range ends before it begins
    QCOMPARE(timeline.first(), 5);
  }

  void the_airbrush_sprays_in_one_step() {
    Desk desk;
    Document& document = desk.document();
    const Scene before = document.scene();
    desk.key(Qt::Key_A);
    hold(desk, QPoint(200, 250), 8);
    QCOMPARE(step_count(document), 1);
    const std::size_t sprayed = document.medium().size() - 5;
    QVERIFY2(sprayed > 3, qPrintable(QString::number(sprayed)));
    QCOMPARE(last_step(document), sprayed == 1 ? QString("Spray 1 Gaussian")
                                               : QString("Spray %1 Gaussians").arg(sprayed));
    const Scene after = document.scene();
    QTest::qWait(200);  // it has stopped
    QVERIFY(document.scene() == after);
    desk.key(Qt::Key_Z, Qt::ControlModifier);
    QVERIFY(document.scene() == before);
    desk.key(Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
    QVERIFY(document.scene() == after);
    desk.press(QPoint(200, 250));
    QTRY_VERIFY(document.medium().size() > after.medium.size());
    QTest::keyClick(&desk.view(), Qt::Key_Escape);
    QTest::qWait(150);
    desk.release(QPoint(200, 250));
    QVERIFY(document.scene() == after);
    // Undo while it sprays ends it.
    desk.press(QPoint(200, 250));
    QTRY_VERIFY(document.medium().size() > after.medium.size());
    document.undo_stack().setIndex(0);
    QTest::qWait(150);
    desk.release(QPoint(200, 250));
    QVERIFY(document.scene() == before);
  }

  void the_airbrush_fills_a_closed_mesh() {
    Desk desk;
    Document& document = desk.document();
    Scene scene = load_scene(BRUME_RESOURCES "/scenes/bunny_fog.brume");
    scene.medium = {};
    // A box of 2 u around the origin, closed, in place of what is there.
    scene.surfaces = {scene.surfaces.front()};
    scene.surfaces[0].mesh = box();
    scene.surfaces[0].scale = 1.0;
    scene.surfaces[0].translate = {};
    scene.surfaces[0].rotate = {1, 0, 0, 0};
    scene.camera = {{0, 0, 6}, {0, 0, 0}, {0, 1, 0}, 45.0};
    document.open(std::move(scene), {});
    desk.key(Qt::Key_A);
    auto& tool = dynamic_cast<AirbrushTool&>(desk.tools().tool());
    tool.set_plane(PaintPlane::surface);
    tool.set_inside(true);
    Airbrush airbrush = tool.airbrush();
    airbrush.rate = 600.0;
    airbrush.speed = 4.0;
    tool.set_airbrush(airbrush);
    QVERIFY(desk.picks());
    hold(desk, desk.view().rect().center(), 400);
    const Medium& medium = document.medium();
    double deepest = 1.0;
    for (const glm::dvec3& center : medium.centers()) {
      QVERIFY(std::abs(center.x) < 1.0 && std::abs(center.y) < 1.0 && std::abs(center.z) < 1.0);
      deepest = std::min(deepest, center.z);
    }
    QVERIFY(deepest < 0.0);
  }

 private:
  static std::shared_ptr<const TriangleMesh> box() {
    MeshArrays mesh;
    for (int k = 0; k < 8; ++k) {
      mesh.points.emplace_back(k & 1 ? 1.0F : -1.0F, k & 2 ? 1.0F : -1.0F, k & 4 ? 1.0F : -1.0F);
      mesh.normals.push_back(glm::normalize(mesh.points.back()));
    }
    const unsigned sides[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4},
                                  {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
    for (const auto& side : sides) {
      mesh.triangles.emplace_back(side[0], side[1], side[2]);
      mesh.triangles.emplace_back(side[0], side[2], side[3]);
    }
    return to_mesh(mesh);
  }
};

BRUME_APP_SUITE("animation", AnimationTest)
#include "animation_test.moc"
