// Cameras in the menu Add and as rows of the outliner.

#include <QLineEdit>
#include <QTreeWidget>
#include <QTreeWidgetItemIterator>

#include "app/commands/objects/edit_cameras.h"
#include "app/import/add_imported.h"
#include "app/viewport/viewport.h"
#include "app/widgets/value_field.h"
#include "brume/limits.h"
#include "core/scene/cameras.h"
#include "tests/app/desk.h"
#include "tests/app/test_window.h"

using namespace brume;

namespace {

constexpr int icon_column = 1;

QTreeWidget& tree(const QWidget& window) {
  return *window.findChild<QTreeWidget*>("outliner_tree");
}

QTreeWidgetItem* row(const QWidget& window, const QString& name) {
  for (QTreeWidgetItemIterator it(&tree(window)); *it; ++it) {
    if ((*it)->text(0) == name) return *it;
  }
  return nullptr;
}

// The names of the rows below Cameras; that in use is in brackets.
QStringList rows(const QWidget& window) {
  QStringList names;
  const QTreeWidgetItem* cameras = row(window, "Cameras");
  for (int k = 0; cameras && k < cameras->childCount(); ++k) {
    const QTreeWidgetItem* item = cameras->child(k);
    names << (item->font(0).bold() ? '[' + item->text(0) + ']' : item->text(0));
  }
  return names;
}

void click_row(const QWidget& window, const QString& name, int column = 0) {
  QTest::mouseClick(tree(window).viewport(), Qt::LeftButton, {},
                    cell_position(tree(window), row(window, name), column));
}

// A second camera, which is not in use.
Scene two_cameras() {
  Scene scene = tiny_scene();
  scene.cameras = {{"aside", Camera{.eye = {5, 0, 0}, .vertical_fov = 30.0}, {}}};
  return scene;
}

}  // namespace

class OutlinerCamerasTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void a_camera_is_added_by_the_menu_where_the_view_is() {
    TestWindow window(tiny_scene());
    const Scene before = window.scene();
    QCOMPARE(rows(*window), QStringList{"[Camera]"});
    click_row(*window, "Light 1");
    QVERIFY(window.document().object().has_value());
    window.drag({300, 300}, {380, 320}, Qt::MiddleButton);
    const Camera seen = window.view().camera();
    QVERIFY(seen != before.camera);
    invoke(window, "add.camera");
    QCOMPARE(step_count(window.document()), 1);
    QCOMPARE(last_step(window.document()), "Add camera Camera 2");
    QVERIFY(window.scene().camera == seen);
    QCOMPARE(rows(*window), (QStringList{"Camera", "[Camera 2]"}));
    // It is selected, and the light is not any more.
    QCOMPARE(tree(*window).currentItem(), row(*window, "Camera 2"));
    QVERIFY(!window.document().object());
    QTRY_VERIFY(window->findChild<ValueField*>("camera_eye_x")->isVisible());
    QVERIFY(is_undone(window.document(), before));
    QCOMPARE(rows(*window), QStringList{"[Camera]"});
  }

  void a_click_shows_the_values_of_a_camera_and_its_menu_uses_it() {
    TestWindow window(two_cameras());
    Document& document = window.document();
    QCOMPARE(rows(*window), (QStringList{"aside", "[Camera]"}));
    click_row(*window, "Light 1");
    click_row(*window, "aside");
    QCOMPARE(rows(*window), (QStringList{"aside", "[Camera]"}));
    QVERIFY(!document.object());
    QCOMPARE(step_count(document), 0);
    QTRY_VERIFY(window->findChild<ValueField*>("camera_eye_x")->isVisible());
    QCOMPARE(value(window, "camera_eye_x"), "5");
    QTreeWidget& tree_of = tree(*window);
    const QPoint place = cell_position(tree_of, row(*window, "aside"));
    QVERIFY(choose_from_menu(*tree_of.viewport(), place, "Use"));
    QCOMPARE(rows(*window), (QStringList{"[aside]", "Camera"}));
    QCOMPARE(last_step(document), "Use camera aside");
    QCOMPARE(tree_of.currentItem(), row(*window, "aside"));
    QCOMPARE(value(window, "camera_eye_x"), "5");
    QVERIFY(!choose_from_menu(*tree_of.viewport(), place, "Use"));
    // The row of a light that is selected later is the current one.
    click_row(*window, "Light 1");
    document.undo_stack().undo();
    QCOMPARE(rows(*window), (QStringList{"aside", "[Camera]"}));
    QCOMPARE(tree_of.currentItem(), row(*window, "Light 1"));
  }

  void a_camera_that_is_not_in_use_is_edited_keyed_and_undone() {
    TestWindow window(two_cameras());
    Document& document = window.document();
    const Scene before = window.scene();
    const auto aside = [&]() -> const NamedCamera& { return window.scene().cameras[0]; };
    click_row(*window, "aside");
    enter(window, "camera_eye_x", "6");
    QCOMPARE(aside().camera.eye.x, 6.0);
    QCOMPARE(last_step(document), "Set position");
    const int steps = step_count(document);
    drag_title(*window, "camera_vertical_fov", 30);
    QVERIFY(aside().camera.vertical_fov > 30.0);
    QCOMPARE(step_count(document), steps + 1);
    choose(window, "camera_lens", 3);
    QCOMPARE(aside().camera.vertical_fov, vertical_fov(50.0, window.scene().film));
    enter(window, "camera_target_x", "6");
    enter(window, "camera_target_y", "0");
    enter(window, "camera_target_z", "0");  // where its eye is: refused
    QVERIFY(aside().camera.target != aside().camera.eye);
    choose(window, "camera_projection", 1);
    QVERIFY(aside().camera.height.has_value());
    choose(window, "camera_projection", 0);
    QVERIFY(window.scene().camera == before.camera);

    click(window, "camera_roll_key");
    QCOMPARE(last_step(document), "Set keyframe of aside roll");
    window->timeline().set_frame(30);
    enter(window, "camera_roll", "20");
    QCOMPARE(aside().keys.roll.size(), 2u);
    window->timeline().set_frame(15);
    QCOMPARE(value(window, "camera_roll"), "10");
    QVERIFY(window.scene().camera_keys == before.camera_keys);
    // The values stay those of this camera, whichever is in use and by whatever name.
    rename_camera(document, "aside", "beside");
    QCOMPARE(value(window, "camera_roll"), "10");
    click_row(*window, "beside", icon_column);
    QCOMPARE(window.scene().camera.roll, 10.0);
    document.undo_stack().undo();
    QCOMPARE(value(window, "camera_roll"), "0");  // of that in use
    click_row(*window, "beside");
    delete_camera(document, "beside");
    QCOMPARE(value(window, "camera_eye_x"), "0");
    window->timeline().set_frame(0);
    QVERIFY(is_undone(document, before));
  }

  void rows_look_through_their_cameras() {
    TestWindow window(two_cameras());
    const CameraController& view = window.view().camera_controller();
    QVERIFY(!view.looks_through_scene_camera());
    click_row(*window, "aside", icon_column);
    QVERIFY(view.looks_through_scene_camera());
    QCOMPARE(view.camera().eye.x, 5.0);
    QCOMPARE(rows(*window), (QStringList{"[aside]", "Camera"}));
    window.drag({300, 300}, {340, 300}, Qt::MiddleButton);
    QVERIFY(!view.looks_through_scene_camera());
    QTreeWidget& rows_of = tree(*window);
    QVERIFY(choose_from_menu(*rows_of.viewport(), cell_position(rows_of, row(*window, "Camera")),
                             "Look Through"));
    QVERIFY(view.looks_through_scene_camera());
    QVERIFY(view.camera() == tiny_scene().camera);
    QCOMPARE(rows(*window), (QStringList{"aside", "[Camera]"}));
  }

  void cameras_are_renamed_duplicated_and_deleted_by_keys() {
    Desk desk(two_cameras());
    Document& document = desk.document();
    QTreeWidget& rows_of = tree(desk);
    rows_of.setFocus();
    click_row(desk, "Camera");
    QCOMPARE(step_count(document), 0);  // it is in use
    QTest::keyClick(&rows_of, Qt::Key_F2);
    auto* editor = rows_of.findChild<QLineEdit*>("row_name");
    QVERIFY(editor);
    QTest::keyClick(editor, Qt::Key_A, Qt::ControlModifier);
    QTest::keyClicks(editor, "A wide one");
    QTest::keyClick(editor, Qt::Key_Return);
    QTRY_COMPARE(rows(desk), (QStringList{"[A wide one]", "aside"}));
    QCOMPARE(rows_of.currentItem(), row(desk, "A wide one"));

    // A double click on one that is not in use, too.
    const QPoint place = cell_position(rows_of, row(desk, "aside"));
    QTest::mouseClick(rows_of.viewport(), Qt::LeftButton, {}, place);
    QTest::mouseDClick(rows_of.viewport(), Qt::LeftButton, {}, place);
    editor = rows_of.findChild<QLineEdit*>("row_name");
    QVERIFY(editor);
    QTest::keyClick(editor, Qt::Key_Escape);
    click_row(desk, "A wide one");

    QTest::keyClick(&rows_of, Qt::Key_D, Qt::ControlModifier);
    QCOMPARE(last_step(document), "Duplicate camera A wide one");
    QCOMPARE(rows(desk), (QStringList{"A wide one", "[A wide one 2]", "aside"}));
    QCOMPARE(rows_of.currentItem(), row(desk, "A wide one 2"));
    QTest::keyClick(&rows_of, Qt::Key_Down);
    QTest::keyClick(&rows_of, Qt::Key_Delete);
    QCOMPARE(rows(desk), (QStringList{"A wide one", "[A wide one 2]"}));
    click_row(desk, "A wide one 2");
    QTest::keyClick(&rows_of, Qt::Key_Delete);
    QCOMPARE(rows(desk), QStringList{"[A wide one]"});
    QSignalSpy refused(&document, &Document::refused);
    QTest::keyClick(&rows_of, Qt::Key_Delete);
    QCOMPARE(refused.size(), 1);
    QVERIFY(!choose_from_menu(*rows_of.viewport(), cell_position(rows_of, row(desk, "A wide one")),
                              "Delete"));
    QVERIFY(choose_from_menu(*rows_of.viewport(), cell_position(rows_of, row(desk, "A wide one")),
                             "Duplicate"));
    QCOMPARE(rows(desk).size(), 2);
  }

  void names_of_the_greatest_length_leave_room_for_numbers() {
    const auto name = [](char c) {
      return QString(static_cast<qsizetype>(limits::name_length), c);
    };
    Scene scene = tiny_scene();
    scene.camera_name = name('n').toStdString();
    Desk desk(scene);  // it opens in the end what it has saved
    Document& document = desk.document();
    rename_camera(document, name('n'), name('n'));
    QCOMPARE(step_count(document), 0);
    duplicate_camera(document, name('n'));
    rename_camera(document, name('n'), name('m'));
    rename_camera(document, QString::fromStdString(desk.scene().camera_name), name('m'));
    QCOMPARE(step_count(document), 3);
    QCOMPARE(rows(desk).size(), 2);
    for (const QString& row : rows(desk)) QVERIFY(row.contains("mmm"));
  }

  void imported_names_of_the_greatest_length_leave_room_for_numbers() {
    ImportedScene imported;
    for (int k = 0; k < 2; ++k) {
      imported.cameras.push_back({std::string(limits::name_length, 'n'), Camera{}, {}});
    }
    Desk desk(two_cameras());
    add_cameras(desk.document(), imported, "Import");
    add_cameras(desk.document(), imported, "Import");
    QCOMPARE(rows(desk).size(), 6);
    for (const QString& row : rows(desk)) {
      QVERIFY(row.size() <= static_cast<qsizetype>(limits::name_length));
    }
  }

  void the_selection_stays_where_no_camera_can_be_added() {
    Scene scene = two_cameras();
    while (scene.cameras.size() < limits::cameras) {
      scene.cameras.push_back(scene.cameras.front());
      scene.cameras.back().name = "other " + std::to_string(scene.cameras.size());
    }
    TestWindow window(scene);
    QTreeWidget& rows_of = tree(*window);
    QSignalSpy refused(&window.document(), &Document::refused);
    click_row(*window, "Light 1");
    const auto object = window.document().object();
    QVERIFY(object.has_value());
    invoke(window, "add.camera");
    QCOMPARE(refused.size(), 1);
    QVERIFY(window.document().object() == object);
    QCOMPARE(rows_of.currentItem(), row(*window, "Light 1"));
    QVERIFY(choose_from_menu(*rows_of.viewport(), cell_position(rows_of, row(*window, "aside")),
                             "Duplicate"));
    QCOMPARE(refused.size(), 2);
    QCOMPARE(rows_of.currentItem(), row(*window, "aside"));
    QCOMPARE(step_count(window.document()), 0);
  }
};

BRUME_APP_SUITE("outliner_cameras", OutlinerCamerasTest)
#include "outliner_cameras_test.moc"
