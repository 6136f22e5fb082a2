// Groups of Gaussians: made, nested, renamed, hidden and locked in the outliner, painted into.

#include <QComboBox>
#include <QLineEdit>
#include <QMenu>
#include <QMimeData>
#include <QTableView>
#include <QTreeWidget>

#include "app/commands/clipboard.h"
#include "app/commands/edit_groups.h"
#include "app/commands/edit_keys.h"
#include "app/commands/edit_medium.h"
#include "app/commands/select_command.h"
#include "app/document/document.h"
#include "app/panels/gaussians/gaussian_table_model.h"
#include "app/viewport/viewport.h"
#include "app/window/pages/message_bar.h"
#include "brume/at_time.h"
#include "tests/app/groups_window.h"

using namespace brume;

namespace {

// Drags a row of the outliner onto that of a group, with the events of Qt.
void drop(GroupsWindow& window, QTreeWidgetItem* row, const QString& onto) {
  QTreeWidget& tree = window.tree();
  tree.setCurrentItem(row);
  const std::unique_ptr<QMimeData> data(tree.model()->mimeData({tree.currentIndex()}));
  if (!data) return;
  const QPoint at = window.position(onto);
  QDragEnterEvent enter(at, Qt::CopyAction, data.get(), Qt::LeftButton, {});
  QApplication::sendEvent(tree.viewport(), &enter);
  QDragMoveEvent move(at, Qt::CopyAction, data.get(), Qt::LeftButton, {});
  QApplication::sendEvent(tree.viewport(), &move);
  QDropEvent event(at, Qt::CopyAction, data.get(), Qt::LeftButton, {});
  QApplication::sendEvent(tree.viewport(), &event);
  QCoreApplication::processEvents();
}

}  // namespace

class GroupsTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void groups_and_gaussians_are_dragged_onto_groups() {
    GroupsWindow window;
    const std::string before = bytes_of(window.document());
    window.group({1, 2});
    window.group({4});
    drop(window, window.row("Group 2"), "Group");
    QCOMPARE(window.document().undo_stack().undoText(), QString("Move Group 2 into Group"));
    QCOMPARE(window.groups()[1].parent, window.groups()[0].id);
    // A group that has one is in none.
    const int steps = window.document().undo_stack().index();
    drop(window, window.row("Group"), "Group 2");
    QCOMPARE(window.document().undo_stack().index(), steps);
    drop(window, window.row("Group 2"), "In no group");
    QCOMPARE(window.groups()[1].parent, GroupId{0});
    // The row of all Gaussians takes the selected ones.
    select_gaussians(window.document(), {3, 5});
    QTreeWidgetItem* gaussians =
        window.tree().findItems("5 Gaussians", Qt::MatchExactly | Qt::MatchRecursive).value(0);
    drop(window, gaussians, "Group 2");
    QCOMPARE(members_of(window.document(), window.groups()[1].id), (Ids{3, 4, 5}));
    select_gaussians(window.document(), {});
    drop(window, gaussians, "Group");
    QCOMPARE(members_of(window.document(), window.groups()[0].id), (Ids{1, 2}));
    VERIFY_UNDONE(window, before);
  }

  void the_table_has_a_column_of_groups() {
    GroupsWindow window;
    auto* table = window->findChild<QTableView*>();
    constexpr int column = GaussianTableModel::group_column;
    QVERIFY(table->isColumnHidden(column));
    window.group({1, 5});
    window.group({3});
    QVERIFY(!table->isColumnHidden(column));
    const auto text = [&](int row) { return table->model()->index(row, column).data().toString(); };
    QCOMPARE(text(0), QString("Group"));
    QCOMPARE(text(1), QString());
    QCOMPARE(text(2), QString("Group 2"));
    QVERIFY(!table->model()->flags(table->model()->index(0, column)).testFlag(Qt::ItemIsEditable));
    // Sorted by name, those in none first; also when a name changes.
    table->sortByColumn(column, Qt::AscendingOrder);
    QCOMPARE((QStringList{text(0), text(1), text(2), text(3), text(4)}),
             (QStringList{"", "", "Group", "Group", "Group 2"}));
    rename_group(window.document(), window.groups()[1].id, "Ash");
    QCOMPARE((QStringList{text(2), text(3), text(4)}), (QStringList{"Ash", "Group", "Group"}));
    auto* filter = window->findChild<QLineEdit*>("gaussian_filter");
    QTest::keyClicks(filter, "group = group");
    QCOMPARE(table->model()->rowCount(), 2);
    filter->clear();
    QTest::keyClicks(filter, "group = none");
    QCOMPARE(table->model()->rowCount(), 2);
    filter->clear();
    table->sortByColumn(-1, Qt::AscendingOrder);
  }

  void the_selection_becomes_a_group() {
    GroupsWindow window;
    const std::string before = bytes_of(window.document());
    QVERIFY(!window.row("In no group"));
    window.group({2, 4});
    QCOMPARE(window.document().undo_stack().undoText(), QString("Group 2 Gaussians"));
    QCOMPARE(window.groups().size(), std::size_t{1});
    QCOMPARE(members_of(window.document(), window.groups()[0].id), (Ids{2, 4}));
    QVERIFY(window.row("Group"));
    QCOMPARE(window.row("Group")->text(0), QString("Group (2)"));
    QCOMPARE(window.row("In no group")->text(0), QString("In no group (3)"));
    QVERIFY(window.row("Group")->font(0).bold());  // the active one
    window.click("In no group");
    QCOMPARE(window.document().selection(), (Ids{1, 3, 5}));
    QVERIFY(!window.document().active_group());
    QVERIFY(window.row("In no group")->font(0).bold());
    window.click("Group");
    QCOMPARE(window.document().selection(), (Ids{2, 4}));
    QCOMPARE(window.document().active_group(), &window.groups()[0]);
    QCOMPARE(window->findChild<QComboBox*>("group")->currentText(), QString("Group"));
    // A group of part of it is in it.
    window.group({4});
    QCOMPARE(window.groups()[1].parent, window.groups()[0].id);
    QCOMPARE(window.row("Group 2")->parent(), window.row("Group"));
    QCOMPARE(window.row("Group")->text(0), QString("Group (2)"));
    window.click("Group");
    QCOMPARE(window.document().selection(), (Ids{2, 4}));
    // No deeper than that.
    window.group({4});
    QCOMPARE(window.groups().back().parent, window.groups()[0].id);
    window.group({});
    QCOMPARE(window.document().undo_stack().undoText(), QString("Add group"));
    QVERIFY(window.settle());
    VERIFY_UNDONE(window, before);
    QVERIFY(!window.document().active_group());
  }

  void ungroup() {
    GroupsWindow window;
    const std::string before = bytes_of(window.document());
    window.key(Qt::Key_G, Qt::ControlModifier | Qt::ShiftModifier);  // of nothing
    QCOMPARE(window.document().undo_stack().count(), 0);
    window.group({1, 2, 3});
    window.group({3});
    select_gaussians(window.document(), {2, 3});
    window.key(Qt::Key_G, Qt::ControlModifier | Qt::ShiftModifier);
    QCOMPARE(window.document().undo_stack().undoText(), QString("Ungroup 2 Gaussians"));
    QCOMPARE(window.groups().size(), std::size_t{1});  // the inner one is empty, and gone
    QCOMPARE(members_of(window.document(), window.groups()[0].id), (Ids{1, 3}));
    QVERIFY(window.choose("Group", "Ungroup"));
    QVERIFY(window.groups().empty());
    QCOMPARE(window.document().medium().size(), std::size_t{5});
    VERIFY_UNDONE(window, before);
  }

  void delete_takes_the_gaussians_along() {
    GroupsWindow window;
    const std::string before = bytes_of(window.document());
    window.group({1, 2, 3});
    window.group({3});
    window.group({5});
    window.click("Group");
    QTest::keyClick(&window.tree(), Qt::Key_Delete);
    QCOMPARE(window.document().undo_stack().undoText(), QString("Delete Group"));
    QCOMPARE(window.groups().size(), std::size_t{1});
    QCOMPARE(window.document().medium().size(), std::size_t{2});
    window.document().undo_stack().undo();
    QCOMPARE(window.document().selection(), (Ids{1, 2, 3}));
    QVERIFY(window.choose("Group 3", "Delete with Gaussians"));
    QCOMPARE(window.document().medium().size(), std::size_t{4});
    // Those in no group are none that could be deleted as one.
    window.click("In no group");
    QTest::keyClick(&window.tree(), Qt::Key_Delete);
    QCOMPARE(window.document().medium().size(), std::size_t{4});
    VERIFY_UNDONE(window, before);
  }

  void rename_in_place() {
    GroupsWindow window;
    const std::string before = bytes_of(window.document());
    window.group({1});
    window.group({2});
    window.click("Group");
    QTest::keyClick(&window.tree(), Qt::Key_F2);
    window.type_name("  ground  mist ");
    QTRY_VERIFY(window.row("ground mist"));
    QCOMPARE(window.document().undo_stack().undoText(), QString("Rename Group to ground mist"));
    QCOMPARE(window.tree().currentItem(), window.row("ground mist"));
    // A name that another has gets a number.
    window.click("Group 2");
    QTest::mouseDClick(window.tree().viewport(), Qt::LeftButton, {}, window.position("Group 2"));
    window.type_name("ground mist");
    QTRY_VERIFY(window.row("ground mist 2"));
    const int count = window.document().undo_stack().count();
    QVERIFY(window.choose("ground mist", "Rename"));
    window.type_name(" ");
    QTest::qWait(1);
    QCOMPARE(window.document().undo_stack().count(), count);
    QVERIFY(window.row("ground mist"));
    // Other rows have no names to change.
    QTest::keyClick(&window.tree(), Qt::Key_Home);
    QTest::keyClick(&window.tree(), Qt::Key_F2);
    QVERIFY(!window.tree().findChild<QLineEdit*>("row_name"));
    VERIFY_UNDONE(window, before);
  }

  void the_eye_hides_and_shows() {
    GroupsWindow window;
    const std::string before = bytes_of(window.document());
    window.group({1, 2, 3});
    window.group({3});
    select_all(window.document());
    window.click("Group", 1);
    QCOMPARE(window.document().undo_stack().undoText(), QString("Hide Group"));
    QCOMPARE(window.shown_medium().size(), std::size_t{2});
    QCOMPARE(window.document().selection(), (Ids{4, 5}));
    QVERIFY(!window.document().is_editable(3));
    QCOMPARE(evaluate_at(window.document().scene(), 0.0).medium, window.shown_medium());
    QVERIFY(!window->viewport().handles().pick(window.handle(0)));
    QVERIFY(window.settle());
    // Hidden ones of their own stay hidden when the group is shown.
    window.document().hide({2, 4});
    QCOMPARE(window.shown_medium().size(), std::size_t{1});
    window.click("Group", 1);
    QCOMPARE(window.document().undo_stack().undoText(), QString("Show Group"));
    QCOMPARE(window.shown_medium().size(), std::size_t{3});
    window.document().hide({});
    QCOMPARE(window.shown_medium().size(), std::size_t{5});
    window.click("Group 2", 1);
    QCOMPARE(window.shown_medium().size(), std::size_t{4});
    // The file has it.
    window.document().save(window.file("hidden.brume"));
    QVERIFY(!load_scene(window.file("hidden.brume")).groups[1].visible);
    window.document().undo_stack().setIndex(0);
    QCOMPARE(bytes_of(window.document()), before);
  }

  void the_lock_keeps_from_selecting_and_erasing() {
    GroupsWindow window;
    const std::string before = bytes_of(window.document());
    window.group({1, 2});
    window.click("Group", 2);
    QCOMPARE(window.document().undo_stack().undoText(), QString("Lock Group"));
    QVERIFY(window.document().selection().empty());
    QCOMPARE(window.shown_medium().size(), std::size_t{5});
    select_all(window.document());
    QCOMPARE(window.document().selection(), (Ids{3, 4, 5}));
    QVERIFY(!window->viewport().handles().pick(window.handle(0)));
    window.click("Group");
    QVERIFY(window.document().selection().empty());
    // What moves into it is locked too.
    select_gaussians(window.document(), {3});
    QVERIFY(window.choose("Group", "Move Selection Here"));
    QVERIFY(window.document().selection().empty());
    QVERIFY(!window.document().is_editable(3));
    window.click("Group", 2);
    QVERIFY(window.document().is_editable(3));
    VERIFY_UNDONE(window, before);
  }

  void brushes_paint_into_the_active_group() {
    GroupsWindow window;
    Document& document = window.document();
    const std::string before = bytes_of(document);
    window.group({1});
    const GroupId group = window.groups()[0].id;
    const auto last_group = [&] { return document.medium().group(document.medium().size() - 1); };
    window.key(Qt::Key_B);
    const QPoint at(300, 300);
    window.drag(at, at + QPoint(80, 0));
    QVERIFY(document.medium().size() > 6);
    QCOMPARE(last_group(), group);
    window.key(Qt::Key_A, Qt::ShiftModifier);  // Add Gaussian
    QCOMPARE(last_group(), group);
    select_gaussians(document, {2});
    window.key(Qt::Key_C, Qt::ControlModifier);
    window.key(Qt::Key_V, Qt::ControlModifier);
    QCOMPARE(last_group(), group);
    // A duplicate is where its original is.
    select_gaussians(document, {2});
    window.key(Qt::Key_D, Qt::ControlModifier);
    QCOMPARE(last_group(), GroupId{0});
    window.click("In no group");
    window.key(Qt::Key_A, Qt::ShiftModifier);
    QCOMPARE(last_group(), GroupId{0});
    // Nothing comes into what cannot be seen or touched.
    window.click("Group");
    for (const int column : {1, 2}) {
      window.click("Group", column);
      const std::size_t count = document.medium().size();
      window.drag(at, at + QPoint(80, 0));
      window.key(Qt::Key_A, Qt::ShiftModifier);
      window.key(Qt::Key_V, Qt::ControlModifier);
      QCOMPARE(document.medium().size(), count);
      QVERIFY(window->findChild<MessageBar*>()->isVisible());
      window.click("Group", column);
    }
    VERIFY_UNDONE(window, before);
  }

  void the_selection_moves_to_a_group() {
    GroupsWindow window;
    const std::string before = bytes_of(window.document());
    window.group({1});
    window.group({2});
    auto* menu = window->findChild<QMenu*>("move_to_group");
    const auto choose = [&](const QString& text) {
      Q_EMIT menu->aboutToShow();
      for (QAction* action : menu->actions()) {
        if (action->text() == text && action->isEnabled()) return action->trigger();
      }
      QFAIL(qPrintable(text));
    };
    select_gaussians(window.document(), {2, 3});
    choose("Group");
    QCOMPARE(window.document().undo_stack().undoText(), QString("Move 2 Gaussians to Group"));
    QCOMPARE(members_of(window.document(), window.groups()[0].id), (Ids{1, 2, 3}));
    QCOMPARE(window.groups().size(), std::size_t{2});  // though one is empty now
    choose("Out of Groups");
    QCOMPARE(members_of(window.document(), window.groups()[0].id), (Ids{1}));
    VERIFY_UNDONE(window, before);
  }

  void groups_go_into_groups_once() {
    GroupsWindow window;
    const std::string before = bytes_of(window.document());
    for (const GaussianId id : {1, 2, 3}) window.group({id});
    QVERIFY(window.choose("Group 2", "Move into/Group"));
    QCOMPARE(window.groups()[1].parent, window.groups()[0].id);
    QVERIFY(!window.choose("Group", "Move into/Group 3"));    // it has one in it
    QVERIFY(!window.choose("Group 3", "Move into/Group 2"));  // that is in one
    QVERIFY(!window.choose("Group 3", "Move out of Group"));
    QVERIFY(window.choose("Group 2", "Move out of Group"));
    QCOMPARE(window.groups()[1].parent, GroupId{0});
    QVERIFY(window.choose("Group", "Move into/Group 3"));
    QCOMPARE(window.document().undo_stack().undoText(), QString("Move Group into Group 3"));
    VERIFY_UNDONE(window, before);
  }
};

BRUME_APP_SUITE("groups", GroupsTest)
#include "groups_test.moc"
