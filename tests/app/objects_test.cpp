// Primitives, and lights, emitters and surfaces as they are met in the view and the outliner.

#include <QLineEdit>
#include <QListWidget>
#include <QMenu>
#include <QTreeWidget>
#include <QTreeWidgetItemIterator>
#include <fstream>

#include "app/commands/gaussians/select_command.h"
#include "app/commands/objects/edit_objects.h"
#include "app/document/document.h"
#include "app/panels/lists/outliner.h"
#include "app/view/camera/object_box.h"
#include "app/view/surface_picker.h"
#include "app/viewport/viewport.h"
#include "brume/at_time.h"
#include "brume/medium.h"
#include "core/io/scene/scene_file.h"
#include "tests/app/desk.h"

using namespace brume;

namespace {

// A box and a ball on a floor, an emitter, thin fog over the box and dense fog before the ball.
template <class Window>
class WithObjects : public Window {
 public:
  using Window::document;
  using Window::file;
  using Window::view;
  WithObjects() {
    std::ofstream(file("objects.brume")) << R"({"format": "brume-scene", "version": 1,
      "film": {"width": 40, "height": 30}, "camera": {"eye": [0, 2, 9], "target": [0, 0.5, 0]},
      "medium": {"gaussians": [{"center": [-1.5, 0.5, 0], "radius": 1, "density": 0.05},
                               {"center": [1.5, 0.5, 2], "radius": 0.6, "density": 3}],
        "emitters": [{"position": [0, 2.5, 0], "rate": 0, "owner": "pot"}]},
      "lights": [{"type": "point", "position": [0, 4, 3], "intensity": [40, 40, 40]}],
      "surfaces": [
        {"primitive": {"type": "plane", "size": [9, 1, 9]}, "name": "floor", "owner": "us"},
        {"primitive": {"type": "box", "owner": "box"}, "translate": [-1.5, 0.5, 0]},
        {"primitive": {"type": "sphere"}, "translate": [1.5, 0.5, 0]}]})";
    document().open(load_document(file("objects.brume")), file("objects.brume"));
    before = saved();
  }

  const Surfaces& surfaces() { return document().scene().surfaces; }
  std::string saved() { return document_to_json(document().document_to_save(), "/"); }
  bool is_before() {
    document().undo_stack().setIndex(0);
    return saved() == before;
  }
  QPoint on_film(const glm::dvec3& point) { return film_position(view(), point); }
  bool picks() {
    return QTest::qWaitFor([this] { return view().surfaces().is_ready(); }, patience);
  }
  void click(QPoint at, Qt::MouseButton button = Qt::LeftButton) {
    QTest::mouseMove(&view(), at);
    QTest::mouseClick(&view(), button, {}, at);
  }
  QTreeWidget& tree() {
    const QWidget& widget = *this;
    return *widget.findChild<QTreeWidget*>("outliner_tree");
  }
  QTreeWidgetItem* row(const QString& name) {
    for (QTreeWidgetItemIterator it(&tree()); *it; ++it) {
      if ((*it)->text(0) == name) return *it;
    }
    return nullptr;
  }
  void click_row(const QString& name, int column) {
    QTest::mouseClick(tree().viewport(), Qt::LeftButton, {},
                      cell_position(tree(), row(name), column));
  }

  std::string before;
};
using ObjectsWindow = WithObjects<TestWindow>;
using ObjectsDesk = WithObjects<Desk>;

constexpr int eye_column = 1;
constexpr int lock_column = 2;
constexpr ObjectRef box_object{ObjectRef::Kind::surface, 1};
constexpr ObjectRef ball{ObjectRef::Kind::surface, 2};
constexpr ObjectRef emitter{ObjectRef::Kind::emitter, 0};
constexpr ObjectRef first_light{ObjectRef::Kind::light, 0};

}  // namespace

class ObjectsTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void a_click_takes_what_is_seen() {
    ObjectsDesk desk;
    QVERIFY(desk.picks());
    const QPoint corner = desk.on_film({-1.85, 0.85, 0.5});  // beside the Gaussian's handle
    desk.click(corner);
    QVERIFY(desk.document().object() == box_object);
    QVERIFY(desk.document().selection().empty());
    QCOMPARE(desk.tree().currentItem(), desk.row("Box"));
    // The ball is hidden by dense fog, which is what a click means there.
    desk.click(desk.on_film({1.5, 0.7, 2.0}));
    QVERIFY(!desk.document().object());
    QCOMPARE(desk.document().selection().size(), 1u);
    desk.click(desk.on_film(desk.scene().emitters[0].position));
    QVERIFY(desk.document().object() == emitter);
    desk.click(desk.on_film(desk.scene().lights[0].position));
    QVERIFY(desk.document().object() == first_light);
    desk.click({5, 5});
    QVERIFY(!desk.document().object());
    // A locked object is left alone.
    desk.click_row("Box", lock_column);
    QVERIFY(desk.surfaces()[1].locked);
    QVERIFY(desk.picks());
    desk.click(corner);
    QVERIFY(desk.document().object() != box_object);
  }

  void handles_move_turn_and_scale() {
    ObjectsDesk desk;
    desk.click_row("Box", 0);
    QVERIFY(desk.document().object() == box_object);
    const auto drag_from_center = [&](const glm::dvec3& from, const QPoint& by) {
      const glm::dvec3 center = object_center(desk.scene(), box_object, desk.view().rays());
      const QPoint start = desk.on_film(center + from);
      QTest::mouseMove(&desk.view(), start);
      desk.drag(start, start + by);
    };
    desk.key(Qt::Key_G);
    drag_from_center({0.0, 0.5, 0.0}, {0, -60});  // the arrow of y
    QCOMPARE(step_count(desk.document()), 1);
    QCOMPARE(last_step(desk.document()), "Move Box");
    const Surface raised = desk.surfaces()[1];
    QVERIFY(raised.translate.y > 0.8);
    QCOMPARE(raised.translate.x, -1.5);
    QCOMPARE(raised.translate.z, 0.0);
    QCOMPARE(desk.document().medium().gaussian(0).center.y, 0.5);
    desk.key(Qt::Key_S);
    drag_from_center({0.0, 0.5, 0.0}, {0, -60});
    QCOMPARE(step_count(desk.document()), 2);
    const Surface stretched = desk.surfaces()[1];
    QVERIFY(stretched.primitive->size.y > 1.3);
    QCOMPARE(stretched.primitive->size.x, 1.0);
    QCOMPARE(stretched.scale, 1.0);
    const auto corners = box_corners(stretched);
    QVERIFY(std::abs(corners[7].y - corners[0].y - stretched.primitive->size.y) < 1e-5);
    desk.key(Qt::Key_R);
    const glm::dvec3 center = stretched.translate;
    const QPoint middle = desk.on_film(center);
    // The outer ring, 96 pixels around.
    QTest::mouseMove(&desk.view(), middle + QPoint(96, 0));
    desk.drag(middle + QPoint(96, 0), middle + QPoint(0, 96));
    QCOMPARE(last_step(desk.document()), "Rotate Box");
    QVERIFY(std::abs(desk.surfaces()[1].rotate.w) < 0.8);
  }

  void escape_ends_a_drag_as_if_it_had_not_been() {
    ObjectsDesk desk;
    desk.click_row("Box", 0);
    desk.key(Qt::Key_G);
    const QPoint arrow = desk.on_film({-1.5, 1.0, 0.0});
    QTest::mouseMove(&desk.view(), arrow);
    QVERIFY(is_cancelled_by_escape(desk.view(), desk.document(), arrow, arrow - QPoint(0, 50)));
    QCOMPARE(desk.saved(), desk.before);
  }

  void keys_act_on_the_object() {
    ObjectsWindow window;
    select_all(window.document());
    window.click_row("Sphere", 0);
    window.key(Qt::Key_D, Qt::ControlModifier);
    QCOMPARE(window.surfaces().size(), 4u);
    QCOMPARE(window.document().medium().size(), 2u);
    QVERIFY(window.document().object() == ObjectRef(ObjectRef::Kind::surface, 3));
    window.key(Qt::Key_H);
    QVERIFY(!window.surfaces()[3].visible);
    window.key(Qt::Key_K);
    QVERIFY(window.surfaces()[3].locked);
    window.key(Qt::Key_F2);
    QVERIFY(window.tree().findChild<QLineEdit*>());
    window.key(Qt::Key_Delete);
    QCOMPARE(window.surfaces().size(), 3u);
    QVERIFY(!window.document().object());
    window.key(Qt::Key_Delete);  // now the Gaussians, which are selected
    QCOMPARE(window.surfaces().size(), 3u);
    QCOMPARE(window.document().medium().size(), 0u);
    window.document().undo_stack().undo();
    window.click_row("2 Gaussians", 0);
    QTest::keyClick(&window.tree(), Qt::Key_Delete);
    QCOMPARE(window.document().medium().size(), 0u);
    QVERIFY(window.is_before());
  }

  void names_are_edited_in_the_outliner() {
    ObjectsDesk desk;
    const auto rename = [&](const QString& row, const QString& name) {
      desk.click_row(row, 0);
      desk.findChild<Outliner*>()->rename_current();
      auto* line = desk.tree().findChild<QLineEdit*>();
      QVERIFY(line);
      line->setText(name);
      QTest::keyClick(line, Qt::Key_Return);
      // The name is taken when the editor has gone.
      QTRY_VERIFY(!desk.tree().findChild<QLineEdit*>());
      QCoreApplication::processEvents();
    };
    rename("Box", "  crate \n ");
    QCOMPARE(desk.surfaces()[1].name, std::string("crate"));
    QCOMPARE(last_step(desk.document()), "Rename Box");
    rename("crate", "crate");  // no step
    QCOMPARE(step_count(desk.document()), 1);
    rename("Light 1", "key light");
    rename("Emitter 1", "pot");
    QVERIFY(desk.row("key light") && desk.row("pot"));
    rename("crate", QString(300, QChar(0xe9)));
    QCOMPARE(desk.surfaces()[1].name.size(), 256u);
    rename("pot", "");
    QVERIFY(desk.row("Emitter 1"));
  }

  void eyes_of_lights_and_emitters() {
    ObjectsDesk desk;
    desk.click_row("Light 1", eye_column);
    QVERIFY(!desk.scene().lights[0].on);
    QCOMPARE(last_step(desk.document()), "Turn off light 1");
    desk.document().undo_stack().undo();
    Emitters emitters = desk.scene().emitters;
    emitters[0].rate = 20.0;
    Scene scene = desk.scene();
    scene.emitters = emitters;
    QVERIFY(evaluate_at(scene, 2.0).medium.size() > 20);
    desk.click_row("Emitter 1", eye_column);
    scene.emitters[0].visible = desk.scene().emitters[0].visible;
    QCOMPARE(evaluate_at(scene, 2.0).medium.size(), 2u);
  }

  void the_menu_of_the_view() {
    ObjectsWindow window;
    QVERIFY(window.picks());
    const auto choose = [&](QPoint at, const QString& text) {
      window.click(at, Qt::RightButton);
      auto* menu = window.view().findChild<QMenu*>("view_menu");
      if (!menu || !menu->isVisible()) return false;
      for (QAction* action : menu->actions()) {
        if (action->text().remove('&') != text) continue;
        QTest::mouseClick(menu, Qt::LeftButton, {}, menu->actionGeometry(action).center());
        return true;
      }
      menu->close();
      return false;
    };
    const QPoint on_box = window.on_film({-1.85, 0.85, 0.5});
    QVERIFY(choose(on_box, "Hide"));
    QVERIFY(!window.surfaces()[1].visible);
    window.document().undo_stack().undo();
    QVERIFY(window.picks());
    QVERIFY(choose(on_box, "Delete"));
    QCOMPARE(window.surfaces().size(), 2u);
    QVERIFY(window.is_before());
    window.document().set_object(std::nullopt);
    const QPoint in_fog = window.on_film({1.5, 0.5, 2.0});
    QVERIFY(choose(in_fog, "Delete"));
    QCOMPARE(window.document().medium().size(), 1u);
    // A drag of the right button is no click.
    window.drag(on_box, on_box + QPoint(40, 0), Qt::RightButton);
    QVERIFY(!QApplication::activePopupWidget());
    QVERIFY(window.is_before());
  }

  void what_is_locked_is_not_dropped() {
    ObjectsWindow window;
    QVERIFY(window.picks());
    Document& document = window.document();
    change_surface(document, ball.index, "Lift %1", no_merge, [](Surface& surface) {
      surface.translate.y = 2.0;
      surface.locked = true;
    });
    QVERIFY(window.picks());
    document.set_object(ball);
    invoke(window, "edit.drop");
    QCOMPARE(window.surfaces()[ball.index].translate.y, 2.0);
    QCOMPARE(step_count(document), 1);
    lock_object(document, ball, false);
    QVERIFY(window.picks());
    invoke(window, "edit.drop");
    QVERIFY(window.surfaces()[ball.index].translate.y < 2.0);
  }

  void primitives_are_added_and_lit() {
    TestWindow window;
    Document& document = window->document();
    document.create();
    for (const char* name : {"add.plane", "add.box", "add.sphere", "add.cylinder"}) {
      invoke(window, name);
      QVERIFY(QTest::qWaitFor([&] { return window->viewport().surfaces().is_ready(); }, patience));
    }
    const Surfaces& surfaces = document.scene().surfaces;
    QCOMPARE(surfaces.size(), 4u);
    QCOMPARE(surfaces[0].translate.y, 0.0);
    // The box stands on the plane.
    QVERIFY(std::abs(box_corners(surfaces[1])[0].y) < 1e-6);
    QVERIFY(document.object() == ObjectRef(ObjectRef::Kind::surface, 3));
    QVERIFY(window.settle());
    document.save(window.file("primitives.brume"));
    const Scene loaded = load_scene(window.file("primitives.brume"));
    for (std::size_t k = 0; k < 4; ++k) {
      QVERIFY(loaded.surfaces[k].primitive == surfaces[k].primitive);
    }
    // Sizes are numbers, too.
    enter(window, "surface_size_y", "*2");
    document.undo_stack().setIndex(0);
    QVERIFY(document.scene() == new_scene());
  }

  void commands_are_found_by_words() {
    ObjectsWindow window;
    window.key(Qt::Key_F3);
    auto* search = window->findChild<QWidget*>("command_search");
    QVERIFY(search && search->isVisible());
    auto* words = search->findChild<QLineEdit*>("command_words");
    auto* list = search->findChild<QListWidget*>("command_list");
    const int all = list->count();
    QVERIFY(all > 80);
    QTest::keyClicks(words, "cyl add");
    QCOMPARE(list->count(), 1);
    QTest::keyClick(words, Qt::Key_Return);
    QTRY_COMPARE(window.surfaces().size(), 4u);
    QCOMPARE(last_step(window.document()), "Add Cylinder");
    window.key(Qt::Key_F3);
    QTRY_VERIFY(window->findChild<QLineEdit*>("command_words"));
    words = window->findChild<QLineEdit*>("command_words");
    QTest::keyClicks(words, "no such thing");
    QTest::keyClick(words, Qt::Key_Return);
    QTest::keyClick(words, Qt::Key_Escape);
    QTRY_VERIFY(!window->findChild<QLineEdit*>("command_words"));
    QVERIFY(window.is_before());
  }
};

BRUME_APP_SUITE("objects", ObjectsTest)

#include "objects_test.moc"
