// Values that have keys: on the timeline, with the mouse.

#include <QCheckBox>
#include <QToolButton>

#include "app/commands/gaussians/edit_medium.h"
#include "app/commands/objects/edit_lights.h"
#include "app/commands/objects/edit_objects.h"
#include "app/document/time/timeline.h"
#include "app/panels/time/dope_sheet.h"
#include "app/panels/time/time_ruler.h"
#include "app/panels/time/timeline_bar.h"
#include "app/widgets/number_field.h"
#include "app/widgets/value_field.h"
#include "brume/at_time.h"
#include "brume/mesh_arrays.h"
#include "brume/primitive.h"
#include "core/io/scene/scene_file.h"
#include "core/number_domain.h"
#include "core/scene/animation/animation.h"
#include "core/scene/animation/particles.h"
#include "core/scene/imported_scene.h"
#include "tests/app/desk.h"
#include "tests/app/test_window.h"

using namespace brume;

namespace {

constexpr double frame_seconds = 1.0 / default_frame_rate;

DopeSheet& sheet_of(const QWidget& window) {
  return *window.findChild<DopeSheet*>("keys");
}

std::size_t count_values(const QWidget& window) {
  return static_cast<std::size_t>(
      std::ranges::count(sheet_of(window).rows(), false, &DopeRow::is_object));
}

void set_key_at(Desk& desk, int number, const char* track) {
  desk.timeline().set_frame(number);
  set_key(desk.document(), track);
}

void move_light(Desk& desk, const glm::dvec3& to) {
  change_light(desk.document(), 0, "Move %1", no_merge,
               [&to](Light& light) { light.position = to; });
}

const Light& keyed_light(Desk& desk) {
  return desk.scene().lights.at(0);
}

}  // namespace

class KeysTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void a_keyed_light_moves_and_edits_set_its_keys() {
    Desk desk;
    Document& document = desk.document();
    const Scene before = document.scene();
    const QRect place = sheet_of(desk).parentWidget()->geometry();
    QCOMPARE(count_values(desk), 0u);
    set_key_at(desk, 0, "Light 1 position");
    QCOMPARE(last_step(document), "Set keyframe of light 1 position");
    QCOMPARE(count_values(desk), 1u);
    QCoreApplication::processEvents();
    QCOMPARE(sheet_of(desk).parentWidget()->geometry(), place);  // nothing moves
    desk.timeline().set_frame(30);
    move_light(desk, {5, 2, 2});  // sets a key of now
    QCOMPARE(keyed_light(desk).keys.position.size(), 2u);
    QCOMPARE(keyed_light(desk).keys.position[1].time, 1.0);
    QVERIFY(document.is_modified());

    // The document, its panels and the picture show the moment.
    desk.timeline().set_frame(15);
    QCOMPARE(keyed_light(desk).position, glm::dvec3(3, 2, 2));
    auto* field = desk.findChild<ValueField*>("light_position_x")->findChild<NumberField*>();
    QCOMPARE(field->text(), "3");
    const auto shown = desk.view().shown_scene();
    QCOMPARE(shown->lights[0].position, glm::dvec3(3, 2, 2));
    QVERIFY(shown->lights[0].keys == LightKeys{});
    QCOMPARE(step_count(document), 2);  // looking at another moment is no edit

    // The file is the same whatever moment is looked at, and means the same.
    document.save(desk.file("keys.brume"));
    const Scene saved = load_scene(desk.file("keys.brume"));
    QVERIFY(saved.lights[0].keys == keyed_light(desk).keys);
    QCOMPARE(saved.lights[0].position, glm::dvec3(1, 2, 2));
    QCOMPARE(evaluate_at(saved, 0.5).lights, shown->lights);

    document.undo_stack().undo();
    QCOMPARE(keyed_light(desk).position, glm::dvec3(1, 2, 2));
    document.undo_stack().undo();
    QVERIFY(document.scene() == before);
    QCOMPARE(count_values(desk), 0u);
    document.undo_stack().redo();
    document.undo_stack().redo();
    QCOMPARE(keyed_light(desk).position, glm::dvec3(3, 2, 2));
  }

  void keys_are_moved_made_and_deleted_with_the_mouse() {
    Desk desk;
    Document& document = desk.document();
    set_key_at(desk, 0, "Light 1 position");
    desk.timeline().set_frame(60);
    move_light(desk, {5, 2, 2});
    const Scene two_keys = document.scene();
    DopeSheet& keys = sheet_of(desk);
    const auto times = [&] {
      std::vector<int> frames;
      for (const auto& key : keyed_light(desk).keys.position)
        frames.push_back(qRound(key.time / frame_seconds));
      return frames;
    };
    drag_mouse(keys, keys.position(1, 60), keys.position(1, 90));
    QCOMPARE(times(), (std::vector{0, 90}));
    QCOMPARE(last_step(document), "Move keyframe of light 1 position");
    QCOMPARE(step_count(document), 3);
    QCOMPARE(desk.timeline().frame(), 60);
    document.undo_stack().undo();
    QVERIFY(document.scene() == two_keys);
    // There and back is no edit.
    QTest::mousePress(&keys, Qt::LeftButton, {}, keys.position(1, 60));
    for (const int to : {80, 60}) move_mouse(keys, keys.position(1, to));
    QTest::mouseRelease(&keys, Qt::LeftButton, {}, keys.position(1, 60));
    QVERIFY(document.scene() == two_keys);
    QCOMPARE(document.undo_stack().index(), 2);

    QTest::mouseDClick(&keys, Qt::LeftButton, {}, keys.position(1, 30));
    QCOMPARE(times(), (std::vector{0, 30, 60}));
    QCOMPARE(keyed_light(desk).position, glm::dvec3(3, 2, 2));  // where it was at that moment
    QTest::mouseClick(&keys, Qt::LeftButton, {}, keys.position(1, 30));
    QTest::keyClick(&keys, Qt::Key_Delete);
    QCOMPARE(times(), (std::vector{0, 60}));
    QCOMPARE(last_step(document), "Delete keyframe of light 1 position");
    QCOMPARE(document.medium().size(), 5u);  // Delete meant the key
    document.undo_stack().undo();
    desk.document().select({1});
    QTest::mouseClick(&keys, Qt::LeftButton, {}, keys.position(1, 30));
    QTest::keyClick(&keys, Qt::Key_X);  // the other key of Delete
    QCOMPARE(times(), (std::vector{0, 60}));
    QCOMPARE(document.medium().size(), 5u);
    document.undo_stack().undo();
    QCOMPARE(times(), (std::vector{0, 30, 60}));

    // On the ruler a drag looks through time, here nothing.
    const auto* ruler = desk.findChild<TimeRuler*>("frame_ruler");
    const auto on_ruler = [&](int frame) { return QPointF(ruler->scale().x_of(frame), 8.0); };
    drag_mouse(*const_cast<TimeRuler*>(ruler), on_ruler(40), on_ruler(45));
    QCOMPARE(desk.timeline().frame(), 45);
    drag_mouse(keys, keys.position(1, 70), keys.position(1, 75));
    QCOMPARE(desk.timeline().frame(), 45);
    QCOMPARE(times(), (std::vector{0, 30, 60}));
  }

  void a_key_becomes_linear_by_its_menu() {
    Desk desk;
    set_key_at(desk, 0, "Light 1 intensity");
    set_key_at(desk, 60, "Light 1 intensity");
    DopeSheet& keys = sheet_of(desk);
    QVERIFY(choose_from_menu(keys, keys.position(1, 0), "Linear"));
    QCOMPARE(keyed_light(desk).keys.intensity[0].interpolation, Interpolation::linear);
    QCOMPARE(last_step(desk.document()), "Make keyframe of light 1 intensity linear");
    // Later keyframes go on like this.
    set_key_at(desk, 30, "Light 1 intensity");
    QCOMPARE(keyed_light(desk).keys.intensity[1].interpolation, Interpolation::linear);
  }

  void the_view_follows_the_camera_until_moved() {
    Desk desk;
    Document& document = desk.document();
    DeskView& view = desk.view();
    desk.findChild<TimelineBar*>()->set_key();
    Camera aside = view.camera();
    aside.eye.x = 4.0;
    desk.timeline().set_frame(60);
    view.camera_controller().set_camera(aside);
    desk.findChild<TimelineBar*>()->set_key();
    QVERIFY(document.scene().camera == aside);
    desk.timeline().set_frame(30);
    QCOMPARE(view.camera().eye.x, 2.0);
    QVERIFY(evaluate_at(document.scene(), 1.0).camera == view.camera());
    view.camera_controller().set_camera(aside);
    desk.timeline().set_frame(0);
    QVERIFY(view.camera() == aside);  // whoever looks from elsewhere stays there
    view.camera_controller().look_through_scene_camera();
    desk.timeline().set_frame(60);
    QCOMPARE(view.camera().eye.x, 4.0);
    desk.timeline().set_frame(0);
    QCOMPARE(view.camera().eye.x, 0.0);
  }

  // The number of a frame, the playhead and a key of that frame are above each other.
  void keys_stand_below_their_frames_on_the_ruler() {
    TestWindow window;
    window->document().set_object(ObjectRef{ObjectRef::Kind::light, 0});
    window->timeline().set_frame(60);
    window.key(Qt::Key_I);  // of the place of the chosen object
    QCOMPARE(last_step(window->document()), "Set keyframe of light 1 position");
    auto* ruler = window->findChild<TimeRuler*>("frame_ruler");
    const DopeSheet& keys = sheet_of(window);
    const auto check = [&](int frame) {
      const double tick = ruler->mapTo(&*window, QPointF(ruler->scale().x_of(frame), 0.0)).x();
      const double key = keys.mapTo(&*window, keys.position(0, frame)).x();
      // Keys are on whole pixels.
      QVERIFY2(std::abs(tick - key) <= 1.0, qPrintable(QString("%1 %2").arg(tick).arg(key)));
    };
    for (const int width : {900, 1300}) {
      window->resize(width, 560);
      QTRY_COMPARE(window->width(), width);
      for (const int last : {120, 1000, 61}) {
        window->timeline().set_range(0, last);
        window->timeline().set_frame(60);
        for (const int frame : {0, 17, 60, last}) check(frame);
      }
    }
    // A press above the key's place looks at its frame.
    window->timeline().set_range(0, 120);
    QTest::mouseClick(ruler, Qt::LeftButton, {},
                      QPoint(static_cast<int>(ruler->scale().x_of(90)), 6));
    QCOMPARE(window->timeline().frame(), 90);
  }

  void density_has_keys_too() {
    Desk desk;
    Document& document = desk.document();
    set_homogeneous_density(document, 0.1, no_merge);
    click(desk, "homogeneous_density_key");
    desk.timeline().set_frame(60);
    set_homogeneous_density(document, 0.3, no_merge);
    QCOMPARE(document.scene().density_keys.size(), 2u);
    desk.timeline().set_frame(30);
    QVERIFY(std::abs(document.medium().homogeneous_density() - 0.2) < 1e-12);
    document.undo_stack().undo();
    document.undo_stack().undo();
    QCOMPARE(document.medium().homogeneous_density(), 0.1);
  }

  void every_number_of_an_emitter_has_keys() {
    Scene scene = small_scene();
    scene.emitters.push_back({.rate = 30.0, .lifetime = 1.0});
    scene.emitters[0].optics = {glm::dvec3(0.5), glm::dvec3(4.0)};
    Desk desk(scene);
    Document& document = desk.document();
    std::size_t count = 0;
    for (const Track& track : tracks(document.scene())) {
      if (track.object != "Emitter 1") continue;
      set_key_at(desk, 0, qPrintable(track.title()));
      ++count;
    }
    const auto emitter = [&]() -> const Emitter& { return document.scene().emitters[0]; };
    QCOMPARE(count, 11u);
    visit_keyed(emitter(),
                [&](const char* name, const auto& value, const auto& keys, const NumberDomain&) {
                  QVERIFY2(keys.size() == 1 && keys[0].value == value, name);
                });
    QCOMPARE(count_values(desk), count);
    // Edits set a keyframe of now.
    desk.timeline().set_frame(60);
    enter(desk, "emitter_rate", "60");
    enter(desk, "emitter_radius_death", "2");
    enter(desk, "emitter_emission", "8");
    QCOMPARE(emitter().keys.rate.size(), 2u);
    QCOMPARE(emitter().keys.radius[1].value, glm::dvec2(0.1, 2.0));
    QCOMPARE(emitter().keys.emission[1].value, glm::dvec3(8.0));
    QCOMPARE(emitter().keys.density.size(), 1u);
    desk.timeline().set_frame(30);
    QCOMPARE(value(desk, "emitter_rate"), "45");
    QCOMPARE(value(desk, "emitter_emission"), "6");
    const Medium& shown = desk.view().shown_scene()->medium;
    QCOMPARE(shown.size(), 5 + particles_at(emitter(), 1.0).size());
    // Without an albedo of its own there are no keyframes of it.
    click(desk, "emitter_has_albedo");
    QVERIFY(emitter().keys.albedo.empty());
    QCOMPARE(count_values(desk), count - 1);
  }

  void letters_over_a_field_set_and_delete_its_key() {
    Desk desk;
    auto* label = desk.findChild<QWidget*>("light_intensity_title");
    for (const Qt::Key letter : {Qt::Key_I, Qt::Key_K}) {
      QTest::mouseMove(label, QPoint(4, 4));
      QTRY_VERIFY(label->underMouse());
      desk.view().setFocus();
      QTest::keyClick(&desk.view(), letter);
      QCOMPARE(keyed_light(desk).keys.intensity.size(), 1u);
      QTest::keyClick(&desk.view(), letter);
      QCOMPARE(keyed_light(desk).keys.intensity.size(), 0u);
      QTest::mouseMove(&desk.view(), QPoint(4, 4));
      QTRY_VERIFY(!label->underMouse());
    }
    QVERIFY(desk.document().locked().empty());
  }

  void a_surface_moves_and_changes_its_material() {
    Scene scene = small_scene();
    scene.surfaces.push_back({.name = "Floor",
                              .primitive = Primitive{.shape = Primitive::Shape::box},
                              .mesh = mesh_of(Primitive{.shape = Primitive::Shape::box})});
    scene.surfaces.back().material.type = Material::Type::phong;
    const std::size_t index = scene.surfaces.size() - 1;
    Desk desk(scene);
    Document& document = desk.document();
    document.set_object(ObjectRef{ObjectRef::Kind::surface, index});
    const auto surface = [&]() -> const Surface& { return document.scene().surfaces[index]; };
    for (const char* key : {"surface_position_key", "surface_rotation_key", "surface_scale_key",
                            "reflectance_key", "specular_key", "exponent_key"}) {
      click(desk, key);
    }
    visit_keyed_surface(
        surface(), [&](const char* name, const auto& value, const auto& keys, const NumberDomain&) {
          QVERIFY2(keys.size() == 1 && keys[0].value == value, name);
        });
    QCOMPARE(count_values(desk), 6u);
    // Edits of the panel set a keyframe of now.
    desk.timeline().set_frame(60);
    enter(desk, "surface_position_x", "4");
    enter(desk, "surface_rotation_y", "90");
    enter(desk, "surface_scale", "3");
    enter(desk, "exponent", "21");
    QCOMPARE(surface().keys.translate.size(), 2u);
    QCOMPARE(surface().keys.rotate.size(), 2u);
    QCOMPARE(surface().keys.exponent[1].value, 21.0);
    QCOMPARE(surface().keys.reflectance.size(), 1u);
    desk.timeline().set_frame(30);
    QCOMPARE(surface().translate.x, 2.0);
    QCOMPARE(value(desk, "surface_position_x"), "2");
    QCOMPARE(value(desk, "surface_rotation_y"), "45");
    QCOMPARE(value(desk, "surface_scale"), "2");
    QCOMPARE(value(desk, "exponent"), "11");
    const Surface& shown = desk.view().shown_scene()->surfaces[index];
    QCOMPARE(shown.translate.x, 2.0);
    QVERIFY(shown.keys == SurfaceKeys{});
    // Without a highlight there are no keyframes of it.
    brume::choose(desk, "material_type", 0);
    QCOMPARE(count_values(desk), 4u);
  }

  void deleting_a_light_leaves_the_keys_of_the_others() {
    Desk desk;
    Document& document = desk.document();
    add_light(document, light::Point(), {{0, 5, 0}});
    set_key_at(desk, 0, "Light 2 position");
    desk.timeline().set_frame(60);
    change_light(document, 1, "Move %1", no_merge, [](Light& light) {
      light.position = {0, 9, 0};
    });
    const Scene both = document.scene();
    delete_object(document, {ObjectRef::Kind::light, 0});
    QCOMPARE(count_values(desk), 1u);
    QCOMPARE(sheet_of(desk).rows()[0].text, "Light 1");
    QCOMPARE(sheet_of(desk).rows()[1].text, "Position");
    QCOMPARE(keyed_light(desk).keys.position.size(), 2u);
    document.undo_stack().undo();
    QVERIFY(document.scene() == both);
  }

  void keys_of_imported_animations_are_shown_and_stay() {
    Desk desk;
    Surfaces surfaces = desk.scene().surfaces;
    auto imported = std::make_shared<ImportedScene>();
    imported->nodes = {{"wheel"}, {"bent"}};
    imported->files = {"car.glb"};
    ImportedPart wheel{0, mesh_of(Primitive{}), {}};
    wheel.keys.translate = {{.time = 0.0}, {.time = 1.0, .value = glm::dvec3(1.0)}};
    wheel.keys.rotate = {{.time = 0.0, .value = {1, 0, 0, 0}}};
    wheel.keys.scale = {{.time = 0.0, .value = 1.0}};
    ImportedPart bent{1, wheel.mesh, {}};
    Deformation deformation{to_arrays(*wheel.mesh)};
    deformation.poses = {{0.0, false, {}, {glm::dmat4(1.0)}}, {2.0, false, {}, {glm::dmat4(2.0)}}};
    bent.deformation = std::make_shared<const Deformation>(deformation);
    imported->parts = {wheel, bent};
    Surface& surface = surfaces.emplace_back();
    surface.name = "Car";
    surface.mesh = wheel.mesh;
    surface.imported = imported;
    set_scene_part(desk.document(), surfaces, "Import");
    DopeSheet& keys = sheet_of(desk);
    const auto frames = [&] {
      std::vector<int> result;
      for (const Keyframe& key : keyframes_of(desk.scene(), keys.rows().at(1).tracks.at(0))) {
        result.push_back(qRound(key.time / frame_seconds));
      }
      return result;
    };
    QCOMPARE(keys.rows().size(), 2u);
    QCOMPARE(keys.rows()[1].tracks.at(0).title(), "Car animation");
    QCOMPARE(frames(), (std::vector{0, 30, 60}));
    drag_mouse(keys, keys.position(1, 30), keys.position(1, 50));
    QTest::mouseDClick(&keys, Qt::LeftButton, {}, keys.position(1, 40));
    QTest::keyClick(&keys, Qt::Key_Delete);
    QCOMPARE(frames(), (std::vector{0, 30, 60}));
    QCOMPARE(step_count(desk.document()), 1);
    desk.document().undo_stack().undo();
    QCOMPARE(keys.rows().size(), 0u);
  }

  void the_range_holds_all_keys_of_a_scene() {
    Scene scene = small_scene();
    scene.density_keys = {{.time = 0.0, .value = 0.0}, {.time = 7.0, .value = 1.0}};
    Desk desk(scene);
    QCOMPARE(desk.timeline().last(), 210);
    desk.document().create();
    QCOMPARE(desk.timeline().last(), 120);
  }
};

BRUME_APP_SUITE("keys", KeysTest)
#include "keys_test.moc"
