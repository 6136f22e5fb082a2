// Keys in lists, the dope sheet and the curves: they act there, and not on what is selected in the
// picture.

#include <QAbstractItemView>
#include <QListWidget>
#include <QTableView>
#include <array>

#include "app/document/time/timeline.h"
#include "app/panels/gaussians/gaussian_panel.h"
#include "app/panels/lists/outliner.h"
#include "app/panels/time/curve_editor.h"
#include "app/panels/time/dope_sheet.h"
#include "app/tools/tool_box.h"
#include "tests/app/dock_of.h"
#include "tests/app/test_window.h"

using namespace brume;

namespace {

void enter_picture(TestWindow& window) {
  QWidget& picture = *window->centralWidget();
  QEnterEvent event(picture.rect().center(), picture.rect().center(), {});
  QApplication::sendEvent(&picture, &event);
}

}  // namespace

class ListKeysTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void letters_typed_into_a_list_act_on_the_list_only() {
    TestWindow window;
    Document& document = window->document();
    const Scene before = document.scene();
    document.select({1, 2, 3});
    auto* table = window->findChild<GaussianPanel*>()->table();
    auto* outliner = window->findChild<Outliner*>();
    for (QWidget* list : {static_cast<QWidget*>(table), static_cast<QWidget*>(outliner)}) {
      show_dock_of(*list);
      list->setFocus();
      QTest::keyClicks(list, "hxk");
      QTest::keyClick(list, Qt::Key_Escape);
    }
    QCOMPARE(document.selection(), (std::vector<GaussianId>{1, 2, 3}));
    QVERIFY(document.hidden().empty() && document.locked().empty());
    QVERIFY(document.scene() == before);
    // They search names, and no letter deletes what they find.
    outliner->keyboardSearch({});  // what was typed before is over
    QTest::keyClicks(outliner, "lig");
    QCOMPARE(outliner->currentItem()->text(0), "Lights");
    document.set_object(ObjectRef{ObjectRef::Kind::light, 0});
    QTest::keyClick(outliner, Qt::Key_X);
    QCOMPARE(document.scene().lights.size(), 1u);
    // They are commands in the view, which the mouse gives the focus; it stays in the table.
    document.set_object(std::nullopt);
    table->setFocus();
    enter_picture(window);
    QVERIFY(table->hasFocus());
    outliner->setFocus();
    enter_picture(window);
    QVERIFY(!outliner->hasFocus());
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_X);
    QCOMPARE(document.medium().size(), 2u);
    document.undo_stack().undo();
  }

  void no_list_of_the_window_lets_keys_through_to_the_selection() {
    TestWindow window;
    Document& document = window->document();
    document.select({1, 2, 3});
    drag_title(*window, "density", 40);  // so that the history has a step to go back to
    const Scene before = document.scene();
    const QAbstractItemView* table = window->findChild<GaussianPanel*>()->table();
    int count = 0;
    for (auto* list : window->findChildren<QAbstractItemView*>()) {
      const bool is_shown_alone = list->window() != &*window;  // of a box to choose from
      if (is_shown_alone || list->focusPolicy() == Qt::NoFocus) continue;
      ++count;
      show_dock_of(*list);
      list->setFocus();
      const auto press = [list](Qt::Key key) {
        QTest::keyClick(list, key);
        QTest::keyClick(list, key, Qt::ShiftModifier);
        if (QWidget* editor = QApplication::focusWidget(); editor != list) {
          QTest::keyClick(editor, Qt::Key_Escape);
          list->setFocus();
        }
      };
      QList<Qt::Key> keys;
      for (int letter = Qt::Key_A; letter <= Qt::Key_Z; ++letter) keys << Qt::Key(letter);
      if (list != table) {  // whose rows are the selection
        keys << Qt::Key_Home << Qt::Key_End << Qt::Key_PageUp << Qt::Key_PageDown;
      }
      for (const Qt::Key key : keys) {
        press(key);
        QVERIFY2(document.scene() == before,
                 qPrintable(list->metaObject()->className() + QString(" %1").arg(key)));
      }
      if (list != table) press(Qt::Key_Delete);
      QVERIFY(document.medium() == before.medium);
      QCOMPARE(document.selection(), (std::vector<GaussianId>{1, 2, 3}));
      QVERIFY(document.hidden().empty() && document.locked().empty());
      // Lights may be deleted.
      while (document.undo_stack().index() > 1) document.undo_stack().undo();
      QVERIFY(document.scene() == before);
    }
    QVERIFY2(count >= 4, qPrintable(QString::number(count)));
    QTest::keyClick(window->findChild<GaussianPanel*>()->table(), Qt::Key_Delete);
    QCOMPARE(document.medium().size(), 2u);
    document.undo_stack().undo();
    // The dope sheet has no names: keys that it lacks do nothing.
    auto* sheet = window->findChild<DopeSheet*>();
    show_dock_of(*sheet);
    sheet->setFocus();
    QTest::keyClicks(sheet, "xhkgbe");
    QTest::keyClick(sheet, Qt::Key_Delete);
    QVERIFY(document.scene() == before);
    QVERIFY(document.hidden().empty() && document.locked().empty());
    const ToolBox& tools = window->tools();
    QCOMPARE(tools.entries()[tools.active()].name, "select");
  }

  void delete_in_a_list_deletes_its_current_item() {
    Scene scene = small_scene();
    scene.lights.push_back(scene.lights[0]);
    scene.emitters.assign(2, {.rate = 30.0, .lifetime = 1.0});
    TestWindow window(scene);
    Document& document = window->document();
    click(*window, "add_camera");
    click(*window, "add_camera");
    document.select({1, 2, 3});
    const auto sizes = [&] {
      const Scene& now = document.scene();
      return std::vector{now.lights.size(), now.emitters.size(), now.cameras.size()};
    };
    const Scene before = document.scene();
    std::vector<std::size_t> expected = sizes();
    for (std::size_t k = 0; k < expected.size(); ++k) {
      const char* name = std::array{"lights", "emitters", "cameras"}.at(k);
      auto* list = window->findChild<QListWidget*>(name);
      show_dock_of(*list);
      list->setFocus();
      QTest::keyClick(list, Qt::Key_X);  // which searches names
      QCOMPARE(sizes(), expected);
      QTest::keyClick(list, Qt::Key_Delete);
      --expected[k];
      QVERIFY2(sizes() == expected, name);
      QCOMPARE(document.medium().size(), 5u);
    }
    for (std::size_t k = 0; k < expected.size(); ++k) document.undo_stack().undo();
    QVERIFY(document.scene() == before);
    // The current camera may be another than that in use.
    const std::string in_use = document.scene().camera_name;
    auto* cameras = window->findChild<QListWidget*>("cameras");
    QTest::keyClick(cameras, cameras->currentRow() == 0 ? Qt::Key_Down : Qt::Key_Up);
    QTest::keyClick(cameras, Qt::Key_Delete);
    QCOMPARE(document.scene().cameras.size(), before.cameras.size() - 1);
    QCOMPARE(document.scene().camera_name, in_use);
  }

  void keyframes_are_set_and_deleted_by_keys_in_the_sheet_and_the_curves() {
    Scene scene = small_scene();
    scene.lights[0].keys.intensity = {{.time = 0.0, .value = glm::dvec3(10.0)},
                                      {.time = 1.0, .value = glm::dvec3(30.0)}};
    TestWindow window(scene);
    Document& document = window->document();
    document.select({1, 2, 3});
    const auto key_count = [&] { return document.scene().lights[0].keys.intensity.size(); };
    auto* sheet = window->findChild<DopeSheet*>();
    show_dock_of(*sheet);
    QTest::mouseClick(sheet, Qt::LeftButton, {}, sheet->name_position(1));
    window->timeline().set_frame(15);
    QTest::keyClick(sheet, Qt::Key_I);
    QCOMPARE(key_count(), 3u);
    auto* curves = window->findChild<CurveEditor*>();
    show_dock_of(*curves);
    curves->setFocus();
    window->timeline().set_frame(20);
    QTest::keyClick(curves, Qt::Key_I);
    QCOMPARE(key_count(), 4u);
    // Delete is about the selected keyframe, though the mouse comes over the picture.
    sheet->setFocus();
    QTest::mouseClick(sheet, Qt::LeftButton, {}, sheet->position(1, 15));
    QVERIFY(!sheet->selection().empty());
    enter_picture(window);
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_Delete);
    QCOMPARE(key_count(), 3u);
    QCOMPARE(document.medium().size(), 5u);
    // None is selected any more.
    enter_picture(window);
    QVERIFY(!sheet->hasFocus());
  }
};

BRUME_APP_SUITE("list_keys", ListKeysTest)
#include "list_keys_test.moc"
