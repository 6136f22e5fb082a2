// Surfaces: deleted and duplicated in the outliner, placed by numbers in their panel.

#include <QComboBox>
#include <QMenu>
#include <QTreeWidget>
#include <fstream>
#include <glm/gtc/quaternion.hpp>
#include <random>

#include "app/commands/edit_emitters.h"
#include "app/commands/select_command.h"
#include "app/document/document.h"
#include "app/document/euler_angles.h"
#include "app/view/surface_picker.h"
#include "app/viewport/viewport.h"
#include "brume/at_time.h"
#include "brume/medium.h"
#include "brume/mesh_arrays.h"
#include "core/io/scene/scene_file.h"
#include "tests/app/test_window.h"

using namespace brume;

namespace {

// A window with a teapot between two planes; all have keys that Brume does not know.
class SurfacesWindow : public TestWindow {
 public:
  SurfacesWindow() {
    std::ofstream(file("surfaces.brume")) << R"({"format": "brume-scene", "version": 1,
      "film": {"width": 40, "height": 30}, "camera": {"eye": [0, 2, 9], "target": [0, 0, 0]},
      "medium": {"gaussians": [{"center": [0, 1, 0], "radius": 1, "density": 0.2}]},
      "lights": [{"type": "point", "position": [0, 3, 3], "intensity": [20, 20, 20]}],
      "surfaces": [
        {"mesh": ")" BRUME_SCENES R"(/plane.obj", "scale": 3, "owner": "floor"},
        {"mesh": ")" BRUME_RESOURCES R"(/meshes/teapot.obj", "scale": 0.5, "owner": "pot",
         "translate": [0.5, 0, 0], "rotate": [0, 0, 1, 0], "material": {"owner": "glaze"}},
        {"mesh": ")" BRUME_SCENES R"(/plane.obj", "translate": [0, -1, 0], "owner": "ground"}]})";
    document().open(load_document(file("surfaces.brume")), file("surfaces.brume"));
  }

  Document& document() { return (*this)->document(); }
  const Surfaces& surfaces() { return document().scene().surfaces; }
  std::string saved() { return document_to_json(document().document_to_save(), "/"); }
  QTreeWidget& tree() { return *(*this)->findChild<QTreeWidget*>("outliner_tree"); }
  // Below the top-level item `group`.
  QTreeWidgetItem* item(int group, int index) { return tree().topLevelItem(group)->child(index); }
  QPoint item_position(QTreeWidgetItem* item) {
    tree().scrollToItem(item);
    return tree().visualItemRect(item).center();
  }
  void click(QTreeWidgetItem* item) {
    QTest::mouseClick(tree().viewport(), Qt::LeftButton, {}, item_position(item));
  }
  // Chooses from the context menu of an item; whether it has that.
  bool choose(QTreeWidgetItem* item, const QString& text) {
    const QPoint position = item_position(item);
    QContextMenuEvent event(QContextMenuEvent::Mouse, position,
                            tree().viewport()->mapToGlobal(position));
    QApplication::sendEvent(tree().viewport(), &event);
    auto* menu = qobject_cast<QMenu*>(QApplication::activePopupWidget());
    if (!menu) return false;
    for (QAction* action : menu->actions()) {
      if (action->text() != text) continue;
      QTest::mouseClick(menu, Qt::LeftButton, {}, menu->actionGeometry(action).center());
      return true;
    }
    menu->close();
    return false;
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
    SurfacesWindow window;
    const std::string before = window.saved();
    select_all(window.document());
    window.click(window.item(surface_group, 1));
    QTest::keyClick(&window.tree(), Qt::Key_Delete);
    QCOMPARE(window.document().undo_stack().undoText(), QString("Delete teapot.obj"));
    QCOMPARE(window.surfaces().size(), std::size_t{2});
    QVERIFY(window.saved().find("glaze") == std::string::npos);
    QCOMPARE(window.document().medium().size(), std::size_t{1});  // though it is selected
    // The one that takes its place is the next.
    QCOMPARE(window.tree().currentItem(), window.item(surface_group, 1));
    QTest::keyClick(&window.tree(), Qt::Key_X);
    QCOMPARE(window.document().undo_stack().undoText(), QString("Delete plane.obj (2)"));
    QVERIFY(window.saved().find("floor") != std::string::npos);
    QTest::keyClick(&window.tree(), Qt::Key_Delete);
    QVERIFY(window.surfaces().empty());
    QVERIFY(window.settle());
    for (int k = 0; k < 3; ++k) window.document().undo_stack().undo();
    QCOMPARE(window.saved(), before);
    // Gaussians go as before.
    window.click(window.item(medium_group, 0));
    QTest::keyClick(&window.tree(), Qt::Key_Delete);
    QCOMPARE(window.document().medium().size(), std::size_t{0});
    QCOMPARE(window.surfaces().size(), std::size_t{3});
  }

  void a_duplicate_stands_beside_its_original() {
    SurfacesWindow window;
    const std::string before = window.saved();
    window.click(window.item(surface_group, 1));
    QTest::keyClick(&window.tree(), Qt::Key_D, Qt::ControlModifier);
    QCOMPARE(window.document().undo_stack().undoText(), QString("Duplicate teapot.obj"));
    QCOMPARE(window.surfaces().size(), std::size_t{4});
    double right = -1e9;
    for (const glm::dvec3& p : world_points(window.surfaces()[1])) right = std::max(right, p.x);
    for (const glm::dvec3& p : world_points(window.surfaces()[3])) QVERIFY(p.x > right);
    Surface moved_back = window.surfaces()[3];
    moved_back.translate = window.surfaces()[1].translate;
    QVERIFY(moved_back == window.surfaces()[1]);
    const std::string text = window.saved();
    QVERIFY(text.find("glaze") != text.rfind("glaze"));
    // The copy is what is edited next.
    QTreeWidgetItem* copy = window.item(surface_group, 3);
    QCOMPARE(copy->text(0), QString("teapot.obj (2)"));
    QCOMPARE(window.tree().currentItem(), copy);
    QCOMPARE(window->findChild<QComboBox*>("surface")->currentText(), copy->text(0));
    window.document().undo_stack().undo();
    QCOMPARE(window.saved(), before);
  }

  void the_context_menu() {
    SurfacesWindow window;
    add_emitter(window.document(), {}, 1.0);
    const std::string before = window.saved();
    QVERIFY(window.choose(window.item(surface_group, 0), "Duplicate"));
    QCOMPARE(window.surfaces().size(), std::size_t{4});
    QVERIFY(window.choose(window.item(surface_group, 1), "Delete"));
    QCOMPARE(window.document().undo_stack().undoText(), QString("Delete teapot.obj"));
    QVERIFY(window.choose(window.item(light_group, 0), "Delete"));
    QVERIFY(window.document().scene().lights.empty());
    QVERIFY(window.choose(window.item(medium_group, 1), "Delete"));
    QVERIFY(window.document().scene().emitters.empty());
    QVERIFY(!window.choose(window.item(medium_group, 0), "Delete"));
    QVERIFY(!window.choose(window.tree().topLevelItem(surface_group), "Delete"));
    QVERIFY(!window.choose(window.tree().topLevelItem(environment_group), "Delete"));
    for (int k = 0; k < 4; ++k) window.document().undo_stack().undo();
    QCOMPARE(window.saved(), before);
    QVERIFY(window.choose(window.item(light_group, 0), "Duplicate"));
    QCOMPARE(window.document().scene().lights.size(), std::size_t{2});
    window.document().undo_stack().undo();
    QCOMPARE(window.saved(), before);
  }

  void the_eye_hides_and_shows() {
    SurfacesWindow window;
    const std::string before = window.saved();
    const auto shown = [&] { return window->viewport().shown_scene()->surfaces.size(); };
    const auto hits_teapot = [&] {
      SurfacePicker& picker = window->viewport().surfaces();
      return QTest::qWaitFor([&] { return picker.is_ready(); }, patience) &&
             picker.hit({0.5, 0.3, 9.0}, {0.0, 0.0, -1.0});
    };
    QCOMPARE(shown(), std::size_t{3});
    QVERIFY(hits_teapot());
    const auto click_eye = [&] {
      const QPoint row = window.item_position(window.item(surface_group, 1));
      const int x = window.tree().columnViewportPosition(1) + window.tree().columnWidth(1) / 2;
      QTest::mouseClick(window.tree().viewport(), Qt::LeftButton, {}, {x, row.y()});
    };
    click_eye();
    QCOMPARE(window.document().undo_stack().undoText(), QString("Hide teapot.obj"));
    QCOMPARE(shown(), std::size_t{2});
    QCOMPARE(evaluate_at(window.document().scene(), 0.0).surfaces.size(), std::size_t{2});
    QVERIFY(!hits_teapot());
    QVERIFY(window.settle());
    window.document().save(window.file("hidden.brume"));
    QVERIFY(!load_scene(window.file("hidden.brume")).surfaces[1].visible);
    click_eye();
    QCOMPARE(window.document().undo_stack().undoText(), QString("Show teapot.obj"));
    QCOMPARE(shown(), std::size_t{3});
    QCOMPARE(window.saved(), before);
    QVERIFY(window.choose(window.item(surface_group, 0), "Hide"));
    QVERIFY(!window.surfaces()[0].visible);
    QVERIFY(window.choose(window.item(surface_group, 0), "Show"));
    window.document().undo_stack().setIndex(0);
    QCOMPARE(window.saved(), before);
  }

  void surfaces_are_placed_by_numbers() {
    SurfacesWindow window;
    Document& document = window.document();
    const std::string before = window.saved();
    const Surfaces others = window.surfaces();
    window.click(window.item(surface_group, 1));
    const auto surface = [&] { return window.surfaces()[1]; };
    QCOMPARE(value(window, "surface_position_x"), QString("0.5"));
    QCOMPARE(value(window, "surface_scale"), QString("0.5"));
    QVERIFY(turns_alike(from_euler_angles({value(window, "surface_rotation_x").toDouble(),
                                           value(window, "surface_rotation_y").toDouble(),
                                           value(window, "surface_rotation_z").toDouble()}),
                        {0.0, 0.0, 1.0, 0.0}));
    enter(window, "surface_position_y", "1.25");
    QCOMPARE(surface().translate, glm::dvec3(0.5, 1.25, 0.0));
    QCOMPARE(document.undo_stack().undoText(), QString("Move teapot.obj"));
    enter(window, "surface_scale", "0.75");
    QCOMPARE(surface().scale, 0.75);
    QCOMPARE(document.undo_stack().undoText(), QString("Scale teapot.obj"));
    enter(window, "surface_scale", "0");  // refused
    QCOMPARE(document.undo_stack().count(), 2);
    QVERIFY(window.surfaces()[0] == others[0] && window.surfaces()[2] == others[2]);
    QVERIFY(window.settle());
    document.undo_stack().setIndex(0);
    QCOMPARE(value(window, "surface_position_y"), QString("0"));
    QCOMPARE(window.saved(), before);
  }

  // Beyond +-90 degrees, where a quaternion has other angles, too.
  void angles_stay_as_entered() {
    SurfacesWindow window;
    window.click(window.item(surface_group, 0));
    enter(window, "surface_rotation_x", "10");
    enter(window, "surface_rotation_y", "100");
    enter(window, "surface_rotation_z", "-200");
    QCOMPARE(window.document().undo_stack().undoText(), QString("Rotate plane.obj"));
    QCOMPARE(value(window, "surface_rotation_x"), QString("10"));
    QCOMPARE(value(window, "surface_rotation_y"), QString("100"));
    QCOMPARE(value(window, "surface_rotation_z"), QString("-200"));
    QVERIFY(window.surfaces()[0].rotate == from_euler_angles({10.0, 100.0, -200.0}));
    // Those of another surface are its own.
    window.click(window.item(surface_group, 2));
    QCOMPARE(value(window, "surface_rotation_y"), QString("0"));
    window.document().undo_stack().setIndex(0);
    window.click(window.item(surface_group, 0));
    QCOMPARE(value(window, "surface_rotation_y"), QString("0"));
  }

  void a_drag_is_one_step() {
    SurfacesWindow window;
    const std::string before = window.saved();
    window.click(window.item(surface_group, 1));
    const auto steps = [&] { return window.document().undo_stack().count(); };
    drag_title(window, "surface_position_x", 40);
    QCOMPARE(steps(), 1);
    QCOMPARE(window.surfaces()[1].translate.x, 0.9);
    drag_title(window, "surface_rotation_y", 40);
    QCOMPARE(steps(), 2);
    drag_title(window, "surface_scale", -20);
    QCOMPARE(steps(), 3);
    QVERIFY(window.surfaces()[1].scale < 0.45);
    window.document().undo_stack().setIndex(0);
    QCOMPARE(window.saved(), before);
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
