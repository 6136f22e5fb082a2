// The dope sheet and its ruler: rows by object, and keyframes of several values edited together.

#include <QLineEdit>
#include <QWheelEvent>

#include "app/commands/objects/edit_cameras.h"
#include "app/commands/objects/edit_objects.h"
#include "app/document/time/timeline.h"
#include "app/panels/time/dope_sheet.h"
#include "app/panels/time/timeline_bar.h"
#include "tests/app/desk.h"
#include "tests/app/test_window.h"

using namespace brume;

namespace {

// A light with a name, keyed at frames 0, 30 and 60, and one without.
Scene two_keyed_lights() {
  Scene scene = small_scene();
  Light& light = scene.lights.at(0);
  light.name = "key";
  light.keys.position = {{.time = 0.0, .value = light.position},
                         {.time = 2.0, .value = light.position + glm::dvec3(1.0)}};
  light.keys.intensity = {{.time = 0.0, .value = glm::dvec3(10.0)},
                          {.time = 1.0, .value = glm::dvec3(30.0)}};
  Light other = light;
  other.name.clear();
  other.keys = {};
  other.keys.intensity = {{.time = 1.0, .value = glm::dvec3(5.0)}};
  scene.lights.push_back(other);
  return scene;
}

}  // namespace

class DopeSheetTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void the_sheet_names_objects_as_the_outliner_and_has_a_filter() {
    Scene scene = two_keyed_lights();
    Desk desk(scene);
    DopeSheet& sheet = *desk.findChild<DopeSheet*>("keys");
    const auto texts = [&] {
      QStringList rows;
      for (const DopeRow& row : sheet.rows()) rows << row.text;
      return rows;
    };
    QCOMPARE(texts(), (QStringList{"key", "Position", "Intensity", "Light 2", "Intensity"}));
    QCOMPARE(sheet.rows()[0].keys.size(), 3u);  // of both values
    type(desk, "dope_filter", "intens");
    QCOMPARE(texts(), (QStringList{"key", "Intensity", "Light 2", "Intensity"}));
    type(desk, "dope_filter", "KEY pos");
    QCOMPARE(texts(), (QStringList{"key", "Position"}));
    desk.findChild<QLineEdit*>("dope_filter")->clear();
    // The triangle folds an object's values.
    QTest::mouseClick(&sheet, Qt::LeftButton, {}, QPoint(8, sheet.name_position(0).y()));
    QCOMPARE(texts(), (QStringList{"key", "Light 2", "Intensity"}));
    QTest::mouseClick(&sheet, Qt::LeftButton, {}, QPoint(8, sheet.name_position(0).y()));
    QCOMPARE(texts().size(), 5);
    // Names are chosen, an object's with all its values, and keyed together.
    QTest::mouseClick(&sheet, Qt::LeftButton, {}, sheet.name_position(0));
    QCOMPARE(sheet.chosen().size(), 2u);
    QTest::mouseClick(&sheet, Qt::LeftButton, Qt::ControlModifier, sheet.name_position(1));
    QCOMPARE(sheet.chosen().size(), 1u);
    QTest::mouseClick(&sheet, Qt::LeftButton, Qt::ControlModifier, sheet.name_position(4));
    desk.timeline().set_frame(15);
    desk.findChild<TimelineBar*>()->set_key();
    QCOMPARE(desk.scene().lights[0].keys.intensity.size(), 3u);
    QCOMPARE(desk.scene().lights[1].keys.intensity.size(), 2u);
    QCOMPARE(step_count(desk.document()), 1);
  }

  void a_rectangle_selects_keys_which_move_together_onto_frames_in_one_step() {
    Desk desk(two_keyed_lights());
    Document& document = desk.document();
    const Scene before = document.scene();
    DopeSheet& sheet = *desk.findChild<DopeSheet*>("keys");
    const auto count = [&] {
      std::size_t keys = 0;
      for (const TrackKeys& track : sheet.selection().keys()) keys += track.times.size();
      return keys;
    };
    // Around the keys of 30 to 60 of all rows.
    drag_mouse(sheet, sheet.position(0, 20) - QPoint(0, 8), sheet.position(4, 70) + QPoint(0, 8));
    QCOMPARE(count(), 3u);
    QCOMPARE(step_count(document), 0);
    drag_mouse(sheet, sheet.position(2, 30), sheet.position(2, 40) + QPoint(2, 0));
    QCOMPARE(step_count(document), 1);
    QCOMPARE(last_step(document), "Move keyframes of 3 values");
    const auto frame_of = [&](const auto& key) { return key.time * default_frame_rate; };
    const Light& key = document.scene().lights[0];
    QCOMPARE(frame_of(key.keys.intensity[1]), 40.0);
    QCOMPARE(frame_of(key.keys.position[1]), 70.0);
    QCOMPARE(frame_of(key.keys.position[0]), 0.0);
    QCOMPARE(frame_of(document.scene().lights[1].keys.intensity[0]), 40.0);
    QCOMPARE(count(), 3u);
    // They go no further than the start of time; Escape takes them back.
    QTest::mousePress(&sheet, Qt::LeftButton, {}, sheet.position(2, 40));
    move_mouse(sheet, sheet.position(2, 0) - QPoint(30, 0));
    QCOMPARE(frame_of(document.scene().lights[0].keys.position[1]), 30.0);
    QTest::keyClick(&sheet, Qt::Key_Escape);
    QTest::mouseRelease(&sheet, Qt::LeftButton, {}, sheet.position(2, 0));
    QCOMPARE(frame_of(document.scene().lights[0].keys.position[1]), 70.0);
    QTest::keyClick(&sheet, Qt::Key_Delete);
    QCOMPARE(last_step(document), "Delete keyframes of 3 values");
    QCOMPARE(document.scene().lights[0].keys.position.size(), 1u);
    QCOMPARE(document.medium().size(), 5u);
    QVERIFY(is_undone(document, before));
    // Shift adds keys and takes them away; a click on one of several leaves it alone.
    QTest::keyClick(&sheet, Qt::Key_A, Qt::ControlModifier);
    QCOMPARE(count(), 5u);
    QTest::mouseClick(&sheet, Qt::LeftButton, Qt::ShiftModifier, sheet.position(0, 0));
    QCOMPARE(count(), 3u);
    QTest::mouseClick(&sheet, Qt::LeftButton, {}, sheet.position(4, 30));
    QCOMPARE(count(), 1u);
    QVERIFY(document.scene() == before);
  }

  void keys_are_copied_to_the_present_frame_and_to_other_values() {
    Desk desk(two_keyed_lights());
    Document& document = desk.document();
    const Scene before = document.scene();
    DopeSheet& sheet = *desk.findChild<DopeSheet*>("keys");
    // Both keys of the first light's intensity, from frame 0, to frame 90 and on.
    drag_mouse(sheet, sheet.position(2, 0) - QPoint(9, 7), sheet.position(2, 35) + QPoint(0, 7));
    QTest::keyClick(&sheet, Qt::Key_C, Qt::ControlModifier);
    desk.timeline().set_frame(90);
    QTest::keyClick(&sheet, Qt::Key_V, Qt::ControlModifier);
    QCOMPARE(last_step(document), "Paste keyframes of key intensity");
    QCOMPARE(step_count(document), 1);
    const Keys<glm::dvec3>& keys = document.scene().lights[0].keys.intensity;
    QCOMPARE(keys.size(), 4u);
    QCOMPARE(keys[2].time, 3.0);
    QCOMPARE(keys[2].value, keys[0].value);
    QCOMPARE(keys[3].time, 4.0);
    QCOMPARE(keys[3].value, keys[1].value);
    QCOMPARE(sheet.selection().keys().at(0).times.size(), 2u);
    // Into the other light's, whose name is chosen.
    QTest::mouseClick(&sheet, Qt::LeftButton, {}, sheet.name_position(4));
    QTest::keyClick(&sheet, Qt::Key_V, Qt::ControlModifier);
    QCOMPARE(document.scene().lights[1].keys.intensity.size(), 3u);
    QCOMPARE(document.scene().lights[1].keys.intensity[2].value, keys[1].value);
    QCOMPARE(document.medium().size(), 5u);
    desk.timeline().set_frame(0);
    QVERIFY(is_undone(document, before));
  }

  void pasted_keys_are_brought_into_the_domain_of_the_value() {
    Scene scene = two_keyed_lights();
    scene.lights[0].keys.position = {
        {.time = 0.0, .value = {-3.0, 2.0, 5.0}, .out = glm::dvec3(1.0)}};
    Desk desk(scene);
    DopeSheet& sheet = *desk.findChild<DopeSheet*>("keys");
    QTest::mouseClick(&sheet, Qt::LeftButton, {}, sheet.position(1, 0));
    QTest::keyClick(&sheet, Qt::Key_C, Qt::ControlModifier);
    QTest::mouseClick(&sheet, Qt::LeftButton, {}, sheet.name_position(4));
    desk.timeline().set_frame(90);
    QTest::keyClick(&sheet, Qt::Key_V, Qt::ControlModifier);
    // The desk reads what it saves: no intensity is negative.
    const Keys<glm::dvec3>& keys = desk.scene().lights[1].keys.intensity;
    QCOMPARE(keys.size(), 2u);
    QCOMPARE(keys[1].value, glm::dvec3(0.0, 2.0, 5.0));
    QVERIFY(!keys[1].out);
  }

  void escape_in_playback_takes_back_what_was_dragged_and_sets_no_keys() {
    Desk desk(two_keyed_lights());
    Document& document = desk.document();
    DopeSheet& sheet = *desk.findChild<DopeSheet*>("keys");
    const LightKeys before = desk.scene().lights[0].keys;
    QTest::mousePress(&sheet, Qt::LeftButton, {}, sheet.position(2, 30));
    desk.timeline().set_frame(20);
    QTest::keyClick(&sheet, Qt::Key_Escape);
    QTest::mouseRelease(&sheet, Qt::LeftButton, {}, sheet.position(2, 30));
    QCOMPARE(step_count(document), 0);
    QVERIFY(desk.scene().lights[0].keys == before);
    QTest::mousePress(&sheet, Qt::LeftButton, {}, sheet.position(2, 30));
    move_mouse(sheet, sheet.position(2, 40));
    QVERIFY(desk.scene().lights[0].keys != before);
    desk.timeline().set_frame(25);
    QTest::keyClick(&sheet, Qt::Key_Escape);
    QTest::mouseRelease(&sheet, Qt::LeftButton, {}, sheet.position(2, 40));
    QVERIFY(desk.scene().lights[0].keys == before);
    QCOMPARE(step_count(document), 0);
    desk.timeline().set_frame(0);
  }

  void keys_stay_those_of_their_light_when_others_go_and_come() {
    Scene scene = two_keyed_lights();
    scene.lights[0].name.clear();
    scene.lights[0].keys = {};
    scene.lights[0].keys.intensity = {{.time = 1.0, .value = glm::dvec3(7.0)}};
    Desk desk(scene);
    Document& document = desk.document();
    DopeSheet& sheet = *desk.findChild<DopeSheet*>("keys");
    // The selected keys of a light that is deleted do not pass to the next one.
    const auto choose_key = [&](std::size_t row) {
      QTest::mouseClick(&sheet, Qt::LeftButton, {}, sheet.name_position(row));
      QTest::mouseClick(&sheet, Qt::LeftButton, {}, sheet.position(row, 30));
    };
    choose_key(1);
    delete_object(document, {ObjectRef::Kind::light, 0});
    QVERIFY(sheet.selection().empty());
    QVERIFY(sheet.chosen().empty());
    document.undo_stack().undo();
    // Those of the next one stay selected, under another name too.
    choose_key(3);
    rename_object(document, {ObjectRef::Kind::light, 1}, "rim");
    delete_object(document, {ObjectRef::Kind::light, 0});
    QCOMPARE(sheet.chosen().size(), 1u);
    QCOMPARE(sheet.selection().keys().size(), 1u);
    document.undo_stack().undo();
    QCOMPARE(sheet.selection().keys().size(), 1u);
    QTest::keyClick(&sheet, Qt::Key_Delete);
    QCOMPARE(document.scene().lights[0].keys.intensity.size(), 1u);
    QVERIFY(document.scene().lights[1].keys.intensity.empty());
  }

  void keys_stay_with_their_camera_when_another_one_is_used() {
    Scene scene = small_scene();
    scene.camera_keys.roll = {{.time = 0.0, .value = 5.0}};
    scene.cameras = {{"aside", scene.camera, scene.camera_keys}};
    Desk desk(scene);
    Document& document = desk.document();
    DopeSheet& sheet = *desk.findChild<DopeSheet*>("keys");
    const auto choose_key = [&](std::size_t row) {
      QTest::mouseClick(&sheet, Qt::LeftButton, {}, sheet.name_position(row));
      QTest::mouseClick(&sheet, Qt::LeftButton, {}, sheet.position(row, 0));
    };
    choose_key(3);
    QCOMPARE(sheet.selection().keys().size(), 1u);
    rename_camera(document, "aside", "front");
    QCOMPARE(sheet.selection().keys().size(), 1u);
    use_camera(document, "front");
    QCOMPARE(sheet.rows()[0].text, "front");
    QCOMPARE(sheet.rows()[2].text, "Camera");
    QVERIFY(sheet.selection().empty() && sheet.chosen().empty());
    QTest::keyClick(&sheet, Qt::Key_Delete);
    QCOMPARE(document.scene().camera_keys.roll.size(), 1u);
    QCOMPARE(document.scene().cameras[0].keys.roll.size(), 1u);
    choose_key(1);
    QCOMPARE(sheet.selection().keys().size(), 1u);
    delete_camera(document, "front");
    QVERIFY(sheet.selection().empty());
  }

  void lights_of_one_name_are_two_objects() {
    Scene scene = two_keyed_lights();
    scene.lights[1].name = "key";
    Desk desk(scene);
    DopeSheet& sheet = *desk.findChild<DopeSheet*>("keys");
    QCOMPARE(sheet.rows().size(), 5u);
    QCOMPARE(sheet.rows()[3].text, "key");
    QTest::mouseClick(&sheet, Qt::LeftButton, {}, sheet.name_position(0));
    QCOMPARE(sheet.chosen().size(), 2u);
    QTest::mouseClick(&sheet, Qt::LeftButton, {}, QPoint(8, sheet.name_position(0).y()));
    QCOMPARE(sheet.rows().size(), 3u);
    QCOMPARE(sheet.rows()[2].text, "Intensity");
  }

  void a_drag_of_the_last_key_goes_as_far_as_the_mouse() {
    Scene scene = two_keyed_lights();
    scene.lights[0].keys.intensity[1].time = 200.0 / default_frame_rate;
    Desk desk(scene);
    QCOMPARE(desk.timeline().last(), 200);
    DopeSheet& sheet = *desk.findChild<DopeSheet*>("keys");
    drag_mouse(sheet, sheet.position(2, 200), sheet.position(2, 100));
    QCOMPARE(desk.scene().lights[0].keys.intensity[1].time * default_frame_rate, 100.0);
  }

  void keys_before_the_start_of_time_are_moved_as_far_as_others() {
    Scene scene = two_keyed_lights();
    scene.lights[0].keys.position[0].time = -1.0;
    Desk desk(scene);
    DopeSheet& sheet = *desk.findChild<DopeSheet*>("keys");
    QTest::mouseClick(&sheet, Qt::LeftButton, {}, sheet.position(2, 30));
    QTest::keyClick(&sheet, Qt::Key_A, Qt::ControlModifier);
    drag_mouse(sheet, sheet.position(2, 30), sheet.position(2, 35));
    QCOMPARE(desk.scene().lights[0].keys.intensity[1].time * default_frame_rate, 35.0);
    QVERIFY(std::abs(desk.scene().lights[0].keys.position[0].time + 25.0 / 30.0) < 1e-9);
  }

  void rulers_zoom_pan_and_fit() {
    Desk desk(two_keyed_lights());
    auto& ruler = *desk.findChild<TimeRuler*>("frame_ruler");
    const QPointF mouse(ruler.scale().x_of(60), 8.0);
    turn_wheel(ruler, mouse, 480);
    QVERIFY(desk.timeline().shown().first > 10.0 && desk.timeline().shown().last < 110.0);
    QVERIFY(std::abs(ruler.scale().x_of(60) - mouse.x()) < 1e-6);
    drag_mouse(ruler, {100, 8}, {130, 8}, Qt::MiddleButton);
    QVERIFY(std::abs(ruler.scale().x_of(60) - mouse.x() - 30.0) < 1e-6);
    QTest::keyClick(desk.findChild<DopeSheet*>("keys"), Qt::Key_Home);
    QCOMPARE(desk.timeline().shown().first, 0.0);
    QCOMPARE(desk.timeline().shown().last, 120.0);
    QCOMPARE(step_count(desk.document()), 0);
  }
};

BRUME_APP_SUITE("dope_sheet", DopeSheetTest)
#include "dope_sheet_test.moc"
