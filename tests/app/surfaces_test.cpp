// Surfaces: deleted and duplicated in the outliner, placed by numbers in their panel.

#include <QComboBox>
#include <QTreeWidget>
#include <fstream>
#include <glm/gtc/quaternion.hpp>
#include <random>

#include "app/commands/gaussians/select_command.h"
#include "app/commands/objects/edit_emitters.h"
#include "app/document/document.h"
#include "app/document/euler_angles.h"
#include "app/view/surface_picker.h"
#include "app/viewport/viewport.h"
#include "brume/at_time.h"
#include "brume/medium.h"
#include "brume/mesh_arrays.h"
#include "core/io/scene/scene_file.h"
#include "tests/app/desk.h"

using namespace brume;

namespace {

// A teapot between two planes; all have keys that Brume does not know.
class SurfacesDesk : public Desk {
 public:
  SurfacesDesk() {
    std::ofstream(file("surfaces.brume")) << R"({"format": "brume-scene", "version": 1,
      "film": {"width": 40, "height": 30}, "camera": {"eye": [0, 2, 9], "target": [0, 0, 0]},
      "medium": {"gaussians": [{"center": [0, 1, 0], "radius": 1, "density": 0.2}]},
      "lights": [{"type": "point", "position": [0, 3, 3], "intensity": [20, 20, 20]}],
      "surfaces": [
        {"mesh": ")" BRUME_SCENES R"(/plane.obj", "scale": 3, "owner": "floor"},
        {"mesh": ")" BRUME_RESOURCES R"(/meshes/teapot.obj", "scale": 0.5, "owner": "pot",
         "translate": [0.5, 0, 0], "rotate": [0, 0, 1, 0], "material": {"owner": "glaze"}},
        {"mesh": ")" BRUME_SCENES R"(/plane.obj", "translate": [0, -1, 0], "owner": "ground"}]})";
    open("surfaces.brume");
  }

  const Surfaces& surfaces() { return document().scene().surfaces; }
  std::string saved() { return document_to_json(document().document_to_save(), "/"); }
  QTreeWidget& tree() { return *findChild<QTreeWidget*>("outliner_tree"); }
  // Below the top-level item `group`.
  QTreeWidgetItem* item(int group, int index) { return tree().topLevelItem(group)->child(index); }
  void click(QTreeWidgetItem* item, int column = 0) {
    QTest::mouseClick(tree().viewport(), Qt::LeftButton, {}, cell_position(tree(), item, column));
  }
  // Chooses from the context menu of an item; whether it has that.
  bool choose(QTreeWidgetItem* item, const QString& text) {
    return choose_from_menu(*tree().viewport(), cell_position(tree(), item), text);
  }
};

constexpr int medium_group = 0;
constexpr int light_group = 1;
constexpr int environment_group = 2;
constexpr int surface_group = 3;

bool turns_alike(const glm::dquat& a, const glm::dquat& b) {
  return std::abs(glm::dot(a, b)) > 1.0 - 1e-12;
}

}  // namespace

class SurfacesTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void delete_key() {
    SurfacesDesk desk;
    const std::string before = desk.saved();
    select_all(desk.document());
    desk.click(desk.item(surface_group, 1));
    QTest::keyClick(&desk.tree(), Qt::Key_Delete);
    QCOMPARE(last_step(desk.document()), "Delete teapot.obj");
    QCOMPARE(desk.surfaces().size(), 2u);
    QVERIFY(desk.saved().find("glaze") == std::string::npos);
    QCOMPARE(desk.document().medium().size(), 1u);  // though it is selected
    // The one that takes its place is the next.
    QCOMPARE(desk.tree().currentItem(), desk.item(surface_group, 1));
    QTest::keyClick(&desk.tree(), Qt::Key_Delete);
    QCOMPARE(last_step(desk.document()), "Delete plane.obj (2)");
    QVERIFY(desk.saved().find("floor") != std::string::npos);
    QTest::keyClick(&desk.tree(), Qt::Key_Delete);
    QVERIFY(desk.surfaces().empty());
    for (int k = 0; k < 3; ++k) desk.document().undo_stack().undo();
    QCOMPARE(desk.saved(), before);
  }

  void a_duplicate_stands_beside_its_original() {
    SurfacesDesk desk;
    const std::string before = desk.saved();
    desk.click(desk.item(surface_group, 1));
    QTest::keyClick(&desk.tree(), Qt::Key_D, Qt::ControlModifier);
    QCOMPARE(last_step(desk.document()), "Duplicate teapot.obj");
    QCOMPARE(desk.surfaces().size(), 4u);
    double right = -1e9;
    for (const glm::dvec3& p : world_points(desk.surfaces()[1])) right = std::max(right, p.x);
    for (const glm::dvec3& p : world_points(desk.surfaces()[3])) QVERIFY(p.x > right);
    Surface moved_back = desk.surfaces()[3];
    moved_back.translate = desk.surfaces()[1].translate;
    QVERIFY(moved_back == desk.surfaces()[1]);
    const std::string text = desk.saved();
    QVERIFY(text.find("glaze") != text.rfind("glaze"));
    // The copy is what is edited next.
    QTreeWidgetItem* copy = desk.item(surface_group, 3);
    QCOMPARE(copy->text(0), "teapot.obj (2)");
    QCOMPARE(desk.tree().currentItem(), copy);
    QCOMPARE(desk.findChild<QComboBox*>("surface")->currentText(), copy->text(0));
    desk.document().undo_stack().undo();
    QCOMPARE(desk.saved(), before);
  }

  void the_context_menu() {
    SurfacesDesk desk;
    add_emitter(desk.document(), {}, 1.0);
    const std::string before = desk.saved();
    QVERIFY(desk.choose(desk.item(surface_group, 0), "Duplicate"));
    QCOMPARE(desk.surfaces().size(), 4u);
    QVERIFY(desk.choose(desk.item(surface_group, 1), "Delete"));
    QCOMPARE(last_step(desk.document()), "Delete teapot.obj");
    QVERIFY(desk.choose(desk.item(light_group, 0), "Delete"));
    QVERIFY(desk.scene().lights.empty());
    QVERIFY(desk.choose(desk.item(medium_group, 1), "Delete"));
    QVERIFY(desk.scene().emitters.empty());
    QVERIFY(!desk.choose(desk.item(medium_group, 0), "Delete"));
    QVERIFY(!desk.choose(desk.tree().topLevelItem(surface_group), "Delete"));
    QVERIFY(!desk.choose(desk.tree().topLevelItem(environment_group), "Delete"));
    for (int k = 0; k < 4; ++k) desk.document().undo_stack().undo();
    QCOMPARE(desk.saved(), before);
    QVERIFY(desk.choose(desk.item(light_group, 0), "Duplicate"));
    QCOMPARE(desk.scene().lights.size(), 2u);
    desk.document().undo_stack().undo();
    QCOMPARE(desk.saved(), before);
  }

  void the_eye_hides_and_shows() {
    SurfacesDesk desk;
    const std::string before = desk.saved();
    const auto shown = [&] { return desk.view().shown_scene()->surfaces.size(); };
    const auto hits_teapot = [&] {
      return desk.picks() && desk.view().surfaces().hit({0.5, 0.3, 9.0}, {0.0, 0.0, -1.0});
    };
    QCOMPARE(shown(), 3u);
    QVERIFY(hits_teapot());
    const auto click_eye = [&] { desk.click(desk.item(surface_group, 1), 1); };
    click_eye();
    QCOMPARE(last_step(desk.document()), "Hide teapot.obj");
    QCOMPARE(shown(), 2u);
    QCOMPARE(evaluate_at(desk.scene(), 0.0).surfaces.size(), 2u);
    QVERIFY(!hits_teapot());
    click_eye();
    QCOMPARE(last_step(desk.document()), "Show teapot.obj");
    QCOMPARE(shown(), 3u);
    QCOMPARE(desk.saved(), before);
    desk.document().undo_stack().undo();
    QVERIFY(desk.choose(desk.item(surface_group, 0), "Hide"));
    QVERIFY(!desk.surfaces()[0].visible);
    QVERIFY(desk.choose(desk.item(surface_group, 0), "Show"));
    desk.document().undo_stack().setIndex(0);
    QCOMPARE(desk.saved(), before);
  }

  void surfaces_are_placed_by_numbers() {
    SurfacesDesk desk;
    Document& document = desk.document();
    const std::string before = desk.saved();
    const Surfaces others = desk.surfaces();
    desk.click(desk.item(surface_group, 1));
    const auto surface = [&] { return desk.surfaces()[1]; };
    QCOMPARE(value(desk, "surface_position_x"), "0.5");
    QCOMPARE(value(desk, "surface_scale"), "0.5");
    QVERIFY(turns_alike(from_euler_angles({value(desk, "surface_rotation_x").toDouble(),
                                           value(desk, "surface_rotation_y").toDouble(),
                                           value(desk, "surface_rotation_z").toDouble()}),
                        {0.0, 0.0, 1.0, 0.0}));
    enter(desk, "surface_position_y", "1.25");
    QCOMPARE(surface().translate, glm::dvec3(0.5, 1.25, 0.0));
    QCOMPARE(last_step(document), "Move teapot.obj");
    enter(desk, "surface_scale", "0.75");
    QCOMPARE(surface().scale, 0.75);
    QCOMPARE(last_step(document), "Scale teapot.obj");
    enter(desk, "surface_scale", "0");  // refused
    QCOMPARE(step_count(document), 2);
    QVERIFY(desk.surfaces()[0] == others[0] && desk.surfaces()[2] == others[2]);
    document.undo_stack().setIndex(0);
    QCOMPARE(value(desk, "surface_position_y"), "0");
    QCOMPARE(desk.saved(), before);
  }

  // Beyond +-90 degrees, where a quaternion has other angles, too.
  void angles_stay_as_entered() {
    SurfacesDesk desk;
    desk.click(desk.item(surface_group, 0));
    enter(desk, "surface_rotation_x", "10");
    enter(desk, "surface_rotation_y", "100");
    enter(desk, "surface_rotation_z", "-200");
    QCOMPARE(last_step(desk.document()), "Rotate plane.obj");
    QCOMPARE(value(desk, "surface_rotation_x"), "10");
    QCOMPARE(value(desk, "surface_rotation_y"), "100");
    QCOMPARE(value(desk, "surface_rotation_z"), "-200");
    QVERIFY(desk.surfaces()[0].rotate == from_euler_angles({10.0, 100.0, -200.0}));
    // Those of another surface are its own.
    desk.click(desk.item(surface_group, 2));
    QCOMPARE(value(desk, "surface_rotation_y"), "0");
    desk.document().undo_stack().setIndex(0);
    desk.click(desk.item(surface_group, 0));
    QCOMPARE(value(desk, "surface_rotation_y"), "0");
  }

  void a_drag_is_one_step() {
    SurfacesDesk desk;
    const std::string before = desk.saved();
    desk.click(desk.item(surface_group, 1));
    const auto steps = [&] { return step_count(desk.document()); };
    drag_title(desk, "surface_position_x", 40);
    QCOMPARE(steps(), 1);
    QCOMPARE(desk.surfaces()[1].translate.x, 0.9);
    drag_title(desk, "surface_rotation_y", 40);
    QCOMPARE(steps(), 2);
    drag_title(desk, "surface_scale", -20);
    QCOMPARE(steps(), 3);
    QVERIFY(desk.surfaces()[1].scale < 0.45);
    desk.document().undo_stack().setIndex(0);
    QCOMPARE(desk.saved(), before);
  }

  void euler_angles_turn_about_x_then_y_then_z() {
    const glm::dvec3 turned = from_euler_angles({90.0, 0.0, 90.0}) * glm::dvec3(0.0, 1.0, 0.0);
    QVERIFY(glm::distance(turned, {0.0, 0.0, 1.0}) < 1e-12);
    QCOMPARE(to_euler_angles({1.0, 0.0, 0.0, 0.0}), glm::dvec3(0.0));
    QCOMPARE(to_euler_angles(from_euler_angles({-150.0, 30.0, 170.0})),
             glm::dvec3(-150.0, 30.0, 170.0));
    std::mt19937 random(1);
    for (int k = 0; k < 1000; ++k) {
      // Multiples of 15 degrees, so that y is often +-90.
      const auto angle = [&] { return 15.0 * static_cast<double>(random() % 49) - 360.0; };
      const double x = angle();
      const double y = angle();
      const glm::dquat rotation = from_euler_angles({x, y, angle()});
      QVERIFY(turns_alike(from_euler_angles(to_euler_angles(rotation)), rotation));
    }
  }
};

BRUME_APP_SUITE("surfaces", SurfacesTest)
#include "surfaces_test.moc"
