// Curves of animated values: their keys are moved in time and value with the mouse.

#include <QContextMenuEvent>
#include <QDockWidget>
#include <QMenu>
#include <QToolButton>
#include <QTreeWidget>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "app/commands/objects/edit_lights.h"
#include "app/commands/objects/edit_objects.h"
#include "app/document/time/timeline.h"
#include "app/panels/time/curve_panel.h"
#include "app/panels/time/dope_sheet.h"
#include "app/panels/time/time_ruler.h"
#include "app/widgets/mnemonics.h"
#include "tests/app/desk.h"
#include "tests/app/test_window.h"

using namespace brume;

namespace {

Scene animated_scene() {
  Scene scene = small_scene();
  Light& light = scene.lights.at(0);
  light.keys.intensity = {{.time = 1.0, .value = glm::dvec3(10.0, 20.0, 40.0)},
                          {.time = 3.0, .value = glm::dvec3(30.0, 25.0, 60.0)}};
  light.keys.position = {{.time = 0.0, .value = glm::dvec3(1.0, 2.0, 3.0)}};
  return scene;
}

// The curves of a track, the light's intensity if none is named.
class Curves {
 public:
  explicit Curves(const Scene& scene = animated_scene(), const char* track = "Light 1 intensity")
      : desk(scene) {
    show({track});
    QCoreApplication::processEvents();
  }
  void show(std::initializer_list<const char*> titles) {
    std::vector<Track> tracks;
    for (const char* title : titles) tracks.push_back(find_track(desk.scene(), title));
    desk.findChild<CurvePanel*>()->show_tracks(tracks);
  }
  CurveEditor& editor() { return *desk.findChild<CurveEditor*>("curves"); }
  const Keys<glm::dvec3>& keys() { return desk.scene().lights.at(0).keys.intensity; }
  QPoint at(double time, double value) { return editor().position(time, value).toPoint(); }
  void drag(QPoint from, QPoint to, Qt::MouseButton button = Qt::LeftButton,
            Qt::KeyboardModifiers modifiers = {}) {
    drag_mouse(editor(), from, to, button, modifiers);
  }
  // Calls visit(action) for the menu that a right click opens.
  void with_menu(QPoint at, const auto& visit) {
    QContextMenuEvent event(QContextMenuEvent::Mouse, at, editor().mapToGlobal(at));
    QApplication::sendEvent(&editor(), &event);
    auto* menu = editor().findChild<QMenu*>();
    QVERIFY(menu);
    for (QAction* action : menu->actions()) visit(*action);
    menu->close();
    QCoreApplication::sendPostedEvents(menu, QEvent::DeferredDelete);
  }
  void choose(QPoint at, const QString& text) {
    int chosen = 0;
    with_menu(at, [&](QAction& action) {
      if (without_mnemonic(action.text()) != text) return;
      ++chosen;
      action.trigger();
    });
    QCOMPARE(chosen, 1);
  }
  QStringList menu_texts(QPoint at) {
    QStringList texts;
    with_menu(at, [&](const QAction& action) { texts << without_mnemonic(action.text()); });
    return texts;
  }
  QStringList checked(QPoint at) {
    QStringList texts;
    with_menu(at, [&](const QAction& action) {
      if (action.isChecked()) texts << without_mnemonic(action.text());
    });
    return texts;
  }

  Desk desk;
};

}  // namespace

class CurvesTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void the_dock_opens_and_an_empty_one_teaches() {
    TestWindow window;
    auto* dock = window->findChild<QDockWidget*>("curves_dock");
    QVERIFY(!dock->isVisible());
    auto* button = window->findChild<QToolButton*>("curve");
    QTest::mouseClick(button, Qt::LeftButton);
    QVERIFY(dock->isVisible());
    auto* editor = window->findChild<CurveEditor*>("curves");
    QVERIFY(editor->curves().empty());
    QCOMPARE(window->findChild<QTreeWidget*>("curve_list")->topLevelItemCount(), 0);
    editor->grab();
    QTest::mouseClick(editor, Qt::LeftButton, {}, QPoint(50, 50));
    QTest::mouseClick(button, Qt::LeftButton);
    QVERIFY(!dock->isVisible());
  }

  void a_track_has_a_curve_for_each_number() {
    Curves curves;
    const std::vector<Curve>& shown = curves.editor().curves();
    QCOMPARE(shown.size(), 3u);
    QCOMPARE(shown[2].component, 2);
    QVERIFY(shown[1].title.endsWith(" g"));
    QCOMPARE(shown[0].at(0.0), 10.0);
    QCOMPARE(shown[0].at(2.0), 20.0);
    QCOMPARE(shown[2].points().back().value, 60.0);
    curves.show({"Light 1 position"});
    QVERIFY(curves.editor().curves()[0].title.endsWith(" x"));
  }

  void values_have_axes_of_their_own_and_move_together() {
    Curves curves;
    curves.show({"Light 1 position", "Light 1 intensity"});
    CurveEditor& editor = curves.editor();
    QCOMPARE(editor.curves().size(), 6u);
    // 60 W/sr and 3 u both fill the height.
    const double bright = editor.position(3.0, 60.0, 1).y();
    const double far = editor.position(0.0, 3.0, 0).y();
    for (const double top : {bright, far}) QVERIFY(top > 0.0 && top < 0.2 * editor.height());
    const Scene before = curves.desk.scene();
    QTest::keyClick(&editor, Qt::Key_A, Qt::ControlModifier);
    const QPoint from = editor.position(1.0, 10.0, 1).toPoint();
    curves.drag(from, QPoint(editor.position(1.5, 0.0, 0).toPoint().x(), from.y()));
    QCOMPARE(last_step(curves.desk.document()), "Move keyframes of 2 values");
    QVERIFY(std::abs(curves.keys()[0].time - 1.5) < 0.04);
    QVERIFY(std::abs(curves.desk.scene().lights[0].keys.position[0].time - 0.5) < 0.04);
    QVERIFY(is_undone(curves.desk.document(), before));
  }

  void curves_are_hidden_and_isolated_and_follow_the_sheet() {
    Scene scene = animated_scene();
    scene.lights[0].name = "key";
    TestWindow window(scene, {1000, 900});  // the list has room
    auto& sheet = *window->findChild<DopeSheet*>("keys");
    auto& editor = *window->findChild<CurveEditor*>("curves");
    auto& list = *window->findChild<QTreeWidget*>("curve_list");
    QTest::mouseClick(&sheet, Qt::LeftButton, {}, sheet.name_position(0));  // all of "key"
    QTest::mouseClick(window->findChild<QToolButton*>("curve"), Qt::LeftButton);
    QCOMPARE(editor.curves().size(), 6u);
    QTest::mouseClick(&sheet, Qt::LeftButton, {}, sheet.name_position(2));
    QCOMPARE(editor.curves().size(), 3u);
    QTreeWidgetItem* intensity = list.topLevelItem(1);
    QCOMPARE(intensity->text(0), "key intensity");
    QCOMPARE(intensity->checkState(0), Qt::Checked);
    intensity->child(1)->setCheckState(0, Qt::Unchecked);
    QCOMPARE(editor.curves().size(), 2u);
    QCOMPARE(intensity->checkState(0), Qt::PartiallyChecked);
    const QPoint blue = cell_position(list, intensity->child(2));
    QTest::mouseClick(list.viewport(), Qt::LeftButton, {}, blue);
    QTest::mouseDClick(list.viewport(), Qt::LeftButton, {}, blue);
    QCOMPARE(editor.curves().size(), 1u);
    QCOMPARE(editor.curves()[0].component, 2);
    QTest::mouseClick(window->findChild<QToolButton*>("all_curves"), Qt::LeftButton);
    QCOMPARE(editor.curves().size(), 6u);
    // A keyframe elsewhere leaves what is shown.
    set_key(window->document(), "Homogeneous density");
    QCOMPARE(editor.curves().size(), 6u);
    QCOMPARE(list.topLevelItemCount(), 3);
  }

  void a_drag_moves_a_key_in_time_and_value_in_one_step() {
    Curves curves;
    Document& document = curves.desk.document();
    const Scene before = document.scene();
    const QPoint to = curves.at(2.0, 25.0);
    curves.drag(curves.at(1.0, 10.0), to);
    QCOMPARE(step_count(document), 1);
    QCOMPARE(last_step(document), "Move keyframe of light 1 intensity");
    QCOMPARE(curves.keys().size(), 2u);
    QVERIFY(std::abs(curves.keys()[0].time - 2.0) < 0.07);
    QVERIFY(std::abs(curves.keys()[0].value.x - 25.0) < 1.0);
    QCOMPARE(curves.keys()[0].value.y, 20.0);
    // On frames.
    const double frame = curves.desk.timeline().frame_of(curves.keys()[0].time);
    QVERIFY(std::abs(frame - std::round(frame)) < 1e-9);
    document.undo_stack().undo();
    QVERIFY(document.scene() == before);
    // Not below what is allowed.
    curves.drag(curves.at(1.0, 10.0), curves.at(1.0, 10.0) + QPoint(0, 2000));
    QCOMPARE(curves.keys()[0].time, 1.0);
    QCOMPARE(curves.keys()[0].value.x, 0.0);
    document.undo_stack().undo();
    QVERIFY(document.scene() == before);
  }

  void keys_are_added_and_deleted() {
    Curves curves;
    Document& document = curves.desk.document();
    const Scene before = document.scene();
    QTest::mouseDClick(&curves.editor(), Qt::LeftButton, {}, curves.at(2.0, 55.0));
    QCOMPARE(curves.keys().size(), 3u);
    QVERIFY(std::abs(curves.keys()[1].time - 2.0) < 0.04);
    QVERIFY(std::abs(curves.keys()[1].value.x - 20.0) < 1.0);  // on the curve
    document.undo_stack().undo();
    QTest::mouseClick(&curves.editor(), Qt::LeftButton, {}, curves.at(3.0, 60.0));
    QTest::keyClick(&curves.editor(), Qt::Key_Delete);
    QCOMPARE(curves.keys().size(), 1u);
    QCOMPARE(document.medium().size(), before.medium.size());
    document.undo_stack().undo();
    QCOMPARE(curves.keys().size(), 2u);
  }

  void the_view_zooms_pans_fits_and_scrubs() {
    Curves curves;
    CurveEditor& editor = curves.editor();
    const QPointF first = editor.position(1.0, 10.0);
    const QPointF last = editor.position(3.0, 60.0);
    QVERIFY(editor.rect().contains(first.toPoint()) && editor.rect().contains(last.toPoint()));
    turn_wheel(editor, first, 240);
    QVERIFY(QLineF(editor.position(1.0, 10.0), first).length() < 1e-6);
    QVERIFY(editor.position(3.0, 60.0).x() > last.x());
    QVERIFY(editor.position(3.0, 60.0).y() < last.y());
    const double x = editor.position(3.0, 60.0).x();
    turn_wheel(editor, first, 240, Qt::ControlModifier);
    QCOMPARE(editor.position(3.0, 60.0).x(), x);
    curves.drag(QPoint(100, 50), QPoint(130, 40), Qt::MiddleButton);
    QVERIFY(QLineF(editor.position(1.0, 10.0), first + QPointF(30, -10)).length() < 1e-6);
    QTest::keyClick(&editor, Qt::Key_Home);
    QVERIFY(QLineF(editor.position(1.0, 10.0), first).length() < 1e-6);
    auto* ruler = curves.desk.findChild<CurvePanel*>()->findChild<TimeRuler*>();
    QTest::mouseClick(ruler, Qt::LeftButton, {}, QPoint(curves.at(2.0, 0.0).x(), 6));
    QVERIFY(std::abs(curves.desk.timeline().frame() - 60) <= 1);
    // The playhead is dragged, too.
    curves.drag(curves.at(curves.desk.timeline().time(), 50.0), curves.at(1.0, 52.0));
    QVERIFY(std::abs(curves.desk.timeline().frame() - 30) <= 1);
    QCOMPARE(step_count(curves.desk.document()), 0);
  }

  void shift_and_rectangles_select_keys() {
    Curves curves;
    CurveEditor& editor = curves.editor();
    const auto count = [&] { return editor.selection().marks().size(); };
    QTest::mouseClick(&editor, Qt::LeftButton, {}, curves.at(1.0, 10.0));
    QCOMPARE(count(), 1u);
    QTest::mouseClick(&editor, Qt::LeftButton, Qt::ShiftModifier, curves.at(3.0, 60.0));
    QCOMPARE(count(), 2u);
    QTest::mouseClick(&editor, Qt::LeftButton, Qt::ShiftModifier, curves.at(1.0, 10.0));
    QCOMPARE(count(), 1u);
    QVERIFY(editor.selection().contains({2, 3.0}));
    // Around the two keys of 1 s below 30, then the others with Shift.
    const int frame = curves.desk.timeline().frame();
    curves.drag(curves.at(0.6, 30.0), curves.at(1.4, 5.0));
    QCOMPARE(count(), 2u);
    QVERIFY(editor.selection().contains({0, 1.0}) && editor.selection().contains({1, 1.0}));
    curves.drag(curves.at(0.6, 62.0), curves.at(3.4, 28.0), Qt::LeftButton, Qt::ShiftModifier);
    QCOMPARE(count(), 5u);
    QVERIFY(!editor.selection().contains({1, 3.0}));
    // Beside the keys a click selects nothing, and looks at no other moment.
    QTest::mouseClick(&editor, Qt::LeftButton, {}, curves.at(2.0, 15.0));
    QCOMPARE(count(), 0u);
    QCOMPARE(curves.desk.timeline().frame(), frame);
    QTest::keyClick(&editor, Qt::Key_A, Qt::ControlModifier);
    QCOMPARE(count(), 6u);
    QVERIFY(curves.desk.document().selection().empty());
    QCOMPARE(step_count(curves.desk.document()), 0);
  }

  void selected_keys_move_together_in_one_step() {
    Curves curves;
    Document& document = curves.desk.document();
    const Scene before = document.scene();
    // Both ends of red, and the end of blue.
    QTest::mouseClick(&curves.editor(), Qt::LeftButton, {}, curves.at(1.0, 10.0));
    QTest::mouseClick(&curves.editor(), Qt::LeftButton, Qt::ShiftModifier, curves.at(3.0, 30.0));
    QTest::mouseClick(&curves.editor(), Qt::LeftButton, Qt::ShiftModifier, curves.at(3.0, 60.0));
    const QPoint from = curves.at(3.0, 30.0);
    curves.drag(from, curves.at(3.5, 40.0));
    QCOMPARE(step_count(document), 1);
    QCOMPARE(last_step(document), "Move keyframes of light 1 intensity");
    QCOMPARE(curves.keys().size(), 2u);
    const Key<glm::dvec3>& first = curves.keys()[0];
    const Key<glm::dvec3>& last = curves.keys()[1];
    QVERIFY(std::abs(first.time - 1.5) < 0.07 && std::abs(last.time - first.time - 2.0) < 1e-9);
    const double raised = first.value.x - 10.0;
    QVERIFY(std::abs(raised - 10.0) < 1.0);
    QVERIFY(glm::length(last.value - glm::dvec3(30.0 + raised, 25.0, 60.0 + raised)) < 1e-9);
    QCOMPARE(first.value.y, 20.0);
    // They stay selected, and go no further than the start of time.
    QCOMPARE(curves.editor().selection().marks().size(), 3u);
    curves.drag(curves.at(last.time, last.value.x), curves.at(0.2, last.value.x));
    QCOMPARE(curves.keys()[0].time, 0.0);
    QVERIFY(std::abs(curves.keys()[1].time - 2.0) < 1e-9);
    QVERIFY(is_undone(document, before));
    // A click on one of several selects it alone.
    curves.editor().fit();
    QTest::keyClick(&curves.editor(), Qt::Key_A, Qt::ControlModifier);
    QTest::mouseClick(&curves.editor(), Qt::LeftButton, {}, curves.at(3.0, 60.0));
    QCOMPARE(curves.editor().selection().marks().size(), 1u);
    QVERIFY(document.scene() == before);
  }

  void several_keys_are_aligned_and_deleted() {
    Curves curves;
    Document& document = curves.desk.document();
    const Scene before = document.scene();
    QTest::mouseClick(&curves.editor(), Qt::LeftButton, {}, curves.at(1.0, 10.0));
    QTest::mouseClick(&curves.editor(), Qt::LeftButton, Qt::ShiftModifier, curves.at(3.0, 30.0));
    curves.choose(curves.at(3.0, 30.0), "Same Value");
    QCOMPARE(curves.keys()[0].value, glm::dvec3(30.0, 20.0, 40.0));
    QCOMPARE(curves.keys()[1].value, glm::dvec3(30.0, 25.0, 60.0));
    QCOMPARE(step_count(document), 1);
    document.undo_stack().undo();
    QVERIFY(document.scene() == before);
    curves.desk.timeline().set_frame(60);
    curves.choose(curves.at(1.0, 40.0), "Align to Playhead");  // that key alone
    QCOMPARE(curves.keys()[0].time, 2.0);
    QCOMPARE(curves.keys()[0].value, glm::dvec3(10.0, 20.0, 40.0));
    QCOMPARE(curves.keys().size(), 2u);
    document.undo_stack().undo();
    curves.desk.timeline().set_frame(0);
    QVERIFY(document.scene() == before);
    QTest::keyClick(&curves.editor(), Qt::Key_A, Qt::ControlModifier);
    QTest::keyClick(&curves.editor(), Qt::Key_Delete);
    QVERIFY(curves.keys().empty());
    QCOMPARE(last_step(document), "Delete keyframes of light 1 intensity");
    document.undo_stack().undo();
    QVERIFY(document.scene() == before);
  }

  void tangents_are_dragged_with_the_mouse() {
    Curves curves;
    Document& document = curves.desk.document();
    QTest::mouseDClick(&curves.editor(), Qt::LeftButton, {}, curves.at(2.0, 55.0));
    const Scene before = document.scene();
    const auto key = [&]() -> const Key<glm::dvec3>& { return curves.keys()[1]; };
    const double time = key().time;
    QVERIFY(curves.editor().handles().empty());
    QTest::mouseClick(&curves.editor(), Qt::LeftButton, {}, curves.at(time, key().value.x));
    std::vector<TangentHandle> handles = curves.editor().handles();
    QCOMPARE(handles.size(), 2u);
    QVERIFY(handles[0].is_automatic && handles[0].tip.x() < handles[0].key.x());
    const Slopes<glm::dvec3> automatic = slopes_at(curves.keys(), 1);

    // Half a second on, and down by 10: a slope of -20 on both sides, of red alone.
    const QPoint steep = curves.at(time + 0.5, key().value.x - 10.0);
    curves.drag(handles[1].tip.toPoint(), steep);
    QCOMPARE(last_step(document), "Set tangent of light 1 intensity");
    QVERIFY(key().in && key().out && key().aligned);
    QVERIFY(std::abs(key().out->x + 20.0) < 2.0);
    QCOMPARE(*key().in, *key().out);
    QVERIFY(std::abs(key().out->y - automatic.out.y) < 1e-9);
    QCOMPARE(key().value, before.lights[0].keys.intensity[1].value);
    QCOMPARE(step_count(document), 2);  // one drag
    // The curve goes through the handle's slope: it falls after the key.
    QVERIFY(curves.editor().curves()[0].at(time + 0.1) < key().value.x - 1.0);

    // The other end moves both; with Alt it is alone.
    handles = curves.editor().handles();
    curves.drag(handles[0].tip.toPoint(), curves.at(time - 0.5, key().value.x));
    QVERIFY(std::abs(key().in->x) < 2.0 && *key().in == *key().out);
    handles = curves.editor().handles();
    curves.drag(handles[0].tip.toPoint(), curves.at(time - 0.5, key().value.x - 10.0),
                Qt::LeftButton, Qt::AltModifier);
    QVERIFY(std::abs(key().in->x - 20.0) < 2.0 && std::abs(key().out->x) < 2.0);
    QVERIFY(!key().aligned);
    const glm::dvec3 out = *key().out;
    handles = curves.editor().handles();
    curves.drag(handles[0].tip.toPoint(), curves.at(time - 0.5, key().value.x));
    QCOMPARE(*key().out, out);
    // Never to the other side of the key: as steep as a pixel lets it be.
    handles = curves.editor().handles();
    curves.drag(handles[1].tip.toPoint(), curves.at(time - 0.5, key().value.x + 5.0));
    QVERIFY(key().out->x > 100.0 && std::isfinite(key().out->x));

    // A key keeps its tangents when it is moved, and when its value is set anew.
    const Key<glm::dvec3> shaped = key();
    change_light(document, 0, "Set intensity of %1", no_merge,
                 [](Light& light) { light.intensity = glm::dvec3(1.0); });
    QCOMPARE(key().value, glm::dvec3(1.0));
    QVERIFY(key().in == shaped.in && key().out == shaped.out);
    document.undo_stack().setIndex(1);
    QVERIFY(document.scene() == before);
  }

  void the_menu_chooses_interpolation_and_tangents() {
    Curves curves;
    Document& document = curves.desk.document();
    const Scene before = document.scene();
    const auto first = [&]() -> const Key<glm::dvec3>& { return curves.keys()[0]; };
    const QPoint at = curves.at(1.0, 10.0);
    curves.choose(at, "Constant");
    QCOMPARE(first().interpolation, Interpolation::constant);
    QCOMPARE(curves.editor().curves()[0].at(2.9), 10.0);
    QVERIFY(curves.editor().handles().empty());
    curves.choose(at, "Linear");
    QCOMPARE(first().interpolation, Interpolation::linear);
    QCOMPARE(curves.editor().curves()[0].at(2.0), 20.0);
    curves.choose(at, "Free Tangents");
    QCOMPARE(first().interpolation, Interpolation::smooth);
    QVERIFY(first().out == glm::dvec3(0.0) && !first().aligned);
    QCOMPARE(curves.checked(at), (QStringList{"Smooth", "Free Tangents"}));
    // A free one is moved alone.
    curves.drag(curves.editor().handles()[0].tip.toPoint(), curves.at(1.5, 30.0));
    QVERIFY(first().out->x > 30.0 && first().in == glm::dvec3(0.0));
    const double out = first().out->x;
    curves.choose(at, "Aligned Tangents");
    QVERIFY(first().aligned && first().in == first().out);
    QCOMPARE(first().out->x, 0.5 * out);
    curves.choose(at, "Automatic Tangents");
    QVERIFY(document.scene() == before);
    QCOMPARE(last_step(document), "Make tangents of light 1 intensity automatic");
    // Acts on all that are selected.
    QTest::keyClick(&curves.editor(), Qt::Key_A, Qt::ControlModifier);
    curves.choose(at, "Aligned Tangents");
    QVERIFY(curves.keys()[0].aligned && curves.keys()[1].aligned);
    curves.editor().grab();
    QVERIFY(is_undone(document, before));
  }

  void a_rotation_is_one_curve_of_its_angle() {
    Scene scene = small_scene();
    scene.surfaces.push_back({.primitive = Primitive{}, .mesh = mesh_of(Primitive{})});
    const auto about_y = [](double degrees) {
      return glm::angleAxis(glm::radians(degrees), glm::dvec3(0, 1, 0));
    };
    scene.surfaces.back().keys.rotate = {{.time = 0.0, .value = about_y(0)},
                                         {.time = 2.0, .value = about_y(90)},
                                         {.time = 3.0, .value = about_y(30)}};
    Curves curves(scene, "Box rotation");
    Document& document = curves.desk.document();
    const Scene before = document.scene();
    const auto keys = [&]() -> const Keys<glm::dquat>& {
      return document.scene().surfaces.back().keys.rotate;
    };
    QCOMPARE(curves.editor().curves().size(), 1u);
    const double turned = curves.editor().curves()[0].points().back().value;
    QVERIFY(std::abs(turned - 150.0) < 1e-9);
    // It moves in time only, and has no tangents.
    const glm::dquat value = keys()[1].value;
    curves.drag(curves.at(2.0, 90.0), curves.at(1.0, 20.0));
    QVERIFY(std::abs(keys()[1].time - 1.0) < 0.07);
    QCOMPARE(keys()[1].value, value);
    QVERIFY(curves.editor().handles().empty());
    QVERIFY(!curves.menu_texts(curves.at(0.0, 0.0)).contains("Free Tangents"));
    document.undo_stack().undo();
    QVERIFY(document.scene() == before);
  }

  void the_list_has_the_numbers_that_an_undo_leaves() {
    Scene scene = small_scene();
    scene.camera_keys.eye = {{.time = 0.0, .value = scene.camera.eye}};
    Curves curves(scene, "Camera");
    auto& list = *curves.desk.findChild<QTreeWidget*>("curve_list");
    QCOMPARE(list.topLevelItem(0)->childCount(), 3);
    set_key(curves.desk.document(), "Camera");
    QVERIFY(list.topLevelItem(0)->childCount() > 3);
    curves.show({"Camera"});
    curves.desk.document().undo_stack().undo();
    QCOMPARE(list.topLevelItem(0)->childCount(), 3);
    QTreeWidgetItem* top = list.topLevelItem(0);
    top->child(2)->setCheckState(0, Qt::Unchecked);
    QCOMPARE(curves.editor().curves().size(), 2u);
  }

  void a_double_click_adds_a_key_to_the_curve_that_is_nearest() {
    Curves curves;
    curves.show({"Light 1 intensity", "Light 1 position"});
    const CurveEditor& editor = curves.editor();
    // The position comes first, and is the active one until another is clicked.
    std::size_t other = 0;
    while (editor.curves()[other].track == 0) ++other;
    const Curve& curve = editor.curves()[other];
    QTest::mouseDClick(&curves.editor(), Qt::LeftButton, {},
                       editor.position(2.0, curve.at(2.0), curve.track).toPoint());
    QCOMPARE(curves.desk.scene().lights[0].keys.intensity.size(), 3u);
    QCOMPARE(curves.desk.scene().lights[0].keys.position.size(), 1u);
  }
};

BRUME_APP_SUITE("curves", CurvesTest)
#include "curves_test.moc"
