// Groups of Gaussians: made, nested, renamed, hidden and locked in the outliner, painted into.

#include <QComboBox>
#include <QLineEdit>
#include <QMenu>
#include <QMimeData>
#include <QTableView>
#include <QTreeWidget>

#include "app/commands/gaussians/clipboard.h"
#include "app/commands/gaussians/edit_groups.h"
#include "app/commands/gaussians/edit_medium.h"
#include "app/commands/gaussians/select_command.h"
#include "app/commands/objects/edit_keys.h"
#include "app/document/document.h"
#include "app/panels/gaussians/gaussian_table_model.h"
#include "app/viewport/viewport.h"
#include "app/widgets/mnemonics.h"
#include "app/window/pages/message_bar.h"
#include "brume/at_time.h"
#include "tests/app/groups_window.h"

using namespace brume;

namespace {

// Drags a row of the outliner onto that of a group, with the events of Qt.
void drop(GroupsDesk& desk, QTreeWidgetItem* row, const QString& onto) {
  QTreeWidget& tree = desk.tree();
  tree.setCurrentItem(row);
  const std::unique_ptr<QMimeData> data(tree.model()->mimeData({tree.currentIndex()}));
  if (!data) return;
  drop_at(*tree.viewport(), desk.position(onto), *data);
  QCoreApplication::processEvents();
}

}  // namespace

class GroupsTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void groups_and_gaussians_are_dragged_onto_groups() {
    GroupsDesk desk;
    desk.group({1, 2});
    desk.group({4});
    drop(desk, desk.row("Group 2"), "Group");
    QCOMPARE(last_step(desk.document()), "Move Group 2 into Group");
    QCOMPARE(desk.groups()[1].parent, desk.groups()[0].id);
    // A group that has one is in none.
    const int steps = desk.document().undo_stack().index();
    drop(desk, desk.row("Group"), "Group 2");
    QCOMPARE(desk.document().undo_stack().index(), steps);
    drop(desk, desk.row("Group 2"), "In no group");
    QCOMPARE(desk.groups()[1].parent, GroupId{0});
    // The row of all Gaussians takes the selected ones.
    select_gaussians(desk.document(), {3, 5});
    QTreeWidgetItem* gaussians =
        desk.tree().findItems("5 Gaussians", Qt::MatchExactly | Qt::MatchRecursive).value(0);
    drop(desk, gaussians, "Group 2");
    QCOMPARE(members_of(desk.document().scene(), desk.groups()[1].id), (Ids{3, 4, 5}));
    select_gaussians(desk.document(), {});
    drop(desk, gaussians, "Group");
    QCOMPARE(members_of(desk.document().scene(), desk.groups()[0].id), (Ids{1, 2}));
  }

  void the_table_has_a_column_of_groups() {
    GroupsDesk desk;
    auto* table = desk.findChild<QTableView*>();
    constexpr int column = GaussianTableModel::group_column;
    QVERIFY(table->isColumnHidden(column));
    desk.group({1, 5});
    desk.group({3});
    QVERIFY(!table->isColumnHidden(column));
    const auto text = [&](int row) { return table->model()->index(row, column).data().toString(); };
    QCOMPARE(text(0), "Group");
    QCOMPARE(text(1), "");
    QCOMPARE(text(2), "Group 2");
    QVERIFY(!table->model()->flags(table->model()->index(0, column)).testFlag(Qt::ItemIsEditable));
    // Sorted by name, those in none first; also when a name changes.
    table->sortByColumn(column, Qt::AscendingOrder);
    QCOMPARE((QStringList{text(0), text(1), text(2), text(3), text(4)}),
             (QStringList{"", "", "Group", "Group", "Group 2"}));
    rename_group(desk.document(), desk.groups()[1].id, "Ash");
    QCOMPARE((QStringList{text(2), text(3), text(4)}), (QStringList{"Ash", "Group", "Group"}));
    auto* filter = desk.findChild<QLineEdit*>("gaussian_filter");
    QTest::keyClicks(filter, "group = group");
    QCOMPARE(table->model()->rowCount(), 2);
    filter->clear();
    QTest::keyClicks(filter, "group = none");
    QCOMPARE(table->model()->rowCount(), 2);
    filter->clear();
    table->sortByColumn(-1, Qt::AscendingOrder);
  }

  void the_selection_becomes_a_group() {
    GroupsDesk desk;
    const std::string before = bytes_of(desk.document());
    QVERIFY(!desk.row("In no group"));
    desk.group({2, 4});
    QCOMPARE(last_step(desk.document()), "Group 2 Gaussians");
    QCOMPARE(desk.groups().size(), 1u);
    QCOMPARE(members_of(desk.document().scene(), desk.groups()[0].id), (Ids{2, 4}));
    QVERIFY(desk.row("Group"));
    QCOMPARE(desk.row("Group")->text(0), "Group (2)");
    QCOMPARE(desk.row("In no group")->text(0), "In no group (3)");
    QVERIFY(desk.row("Group")->font(0).bold());  // the active one
    desk.click("In no group");
    QCOMPARE(desk.document().selection(), (Ids{1, 3, 5}));
    QVERIFY(!desk.document().active_group());
    QVERIFY(desk.row("In no group")->font(0).bold());
    desk.click("Group");
    QCOMPARE(desk.document().selection(), (Ids{2, 4}));
    QCOMPARE(desk.document().active_group(), &desk.groups()[0]);
    QCOMPARE(desk.findChild<QComboBox*>("group")->currentText(), "Group");
    // A group of part of it is in it.
    desk.group({4});
    QCOMPARE(desk.groups()[1].parent, desk.groups()[0].id);
    QCOMPARE(desk.row("Group 2")->parent(), desk.row("Group"));
    QCOMPARE(desk.row("Group")->text(0), "Group (2)");
    desk.click("Group");
    QCOMPARE(desk.document().selection(), (Ids{2, 4}));
    // No deeper than that.
    desk.group({4});
    QCOMPARE(desk.groups().back().parent, desk.groups()[0].id);
    desk.group({});
    QCOMPARE(last_step(desk.document()), "Add group");
    VERIFY_UNDONE(desk, before);
    QVERIFY(!desk.document().active_group());
  }

  void ungroup() {
    GroupsDesk desk;
    ungroup_selection(desk.document());  // of nothing
    QCOMPARE(step_count(desk.document()), 0);
    desk.group({1, 2, 3});
    desk.group({3});
    select_gaussians(desk.document(), {2, 3});
    ungroup_selection(desk.document());
    QCOMPARE(last_step(desk.document()), "Ungroup 2 Gaussians");
    QCOMPARE(desk.groups().size(), 1u);  // the inner one is empty, and gone
    QCOMPARE(members_of(desk.document().scene(), desk.groups()[0].id), (Ids{1, 3}));
    QVERIFY(desk.choose("Group", "Ungroup"));
    QVERIFY(desk.groups().empty());
    QCOMPARE(desk.document().medium().size(), 5u);
  }

  void delete_takes_the_gaussians_along() {
    GroupsDesk desk;
    desk.group({1, 2, 3});
    desk.group({3});
    desk.group({5});
    desk.click("Group");
    QTest::keyClick(&desk.tree(), Qt::Key_Delete);
    QCOMPARE(last_step(desk.document()), "Delete Group");
    QCOMPARE(desk.groups().size(), 1u);
    QCOMPARE(desk.document().medium().size(), 2u);
    desk.document().undo_stack().undo();
    QCOMPARE(desk.document().selection(), (Ids{1, 2, 3}));
    QVERIFY(desk.choose("Group 3", "Delete with Gaussians"));
    QCOMPARE(desk.document().medium().size(), 4u);
    // Those in no group are none that could be deleted as one.
    desk.click("In no group");
    QTest::keyClick(&desk.tree(), Qt::Key_Delete);
    QCOMPARE(desk.document().medium().size(), 4u);
  }

  void rename_in_place() {
    GroupsDesk desk;
    desk.group({1});
    desk.group({2});
    desk.click("Group");
    QTest::keyClick(&desk.tree(), Qt::Key_F2);
    desk.type_name("  ground  mist ");
    QTRY_VERIFY(desk.row("ground mist"));
    QCOMPARE(last_step(desk.document()), "Rename Group to ground mist");
    QCOMPARE(desk.tree().currentItem(), desk.row("ground mist"));
    // A name that another has gets a number.
    desk.click("Group 2");
    QTest::mouseDClick(desk.tree().viewport(), Qt::LeftButton, {}, desk.position("Group 2"));
    desk.type_name("ground mist");
    QTRY_VERIFY(desk.row("ground mist 2"));
    const int count = step_count(desk.document());
    QVERIFY(desk.choose("ground mist", "Rename"));
    desk.type_name(" ");
    QTest::qWait(1);
    QCOMPARE(step_count(desk.document()), count);
    QVERIFY(desk.row("ground mist"));
    // Other rows have no names to change.
    QTest::keyClick(&desk.tree(), Qt::Key_Home);
    QTest::keyClick(&desk.tree(), Qt::Key_F2);
    QVERIFY(!desk.tree().findChild<QLineEdit*>("row_name"));
  }

  void the_eye_hides_and_shows() {
    GroupsDesk desk;
    desk.group({1, 2, 3});
    desk.group({3});
    select_all(desk.document());
    desk.click("Group", 1);
    QCOMPARE(last_step(desk.document()), "Hide Group");
    QCOMPARE(desk.shown_medium().size(), 2u);
    QCOMPARE(desk.document().selection(), (Ids{4, 5}));
    QVERIFY(!desk.document().is_editable(3));
    QCOMPARE(evaluate_at(desk.scene(), 0.0).medium, desk.shown_medium());
    QVERIFY(!desk.view().handles().pick(desk.handle(0)));
    // Hidden ones of their own stay hidden when the group is shown.
    desk.document().hide({2, 4});
    QCOMPARE(desk.shown_medium().size(), 1u);
    desk.click("Group", 1);
    QCOMPARE(last_step(desk.document()), "Show Group");
    QCOMPARE(desk.shown_medium().size(), 3u);
    desk.document().hide({});
    QCOMPARE(desk.shown_medium().size(), 5u);
    desk.click("Group 2", 1);
    QCOMPARE(desk.shown_medium().size(), 4u);
  }

  void the_lock_keeps_from_selecting_and_erasing() {
    GroupsDesk desk;
    desk.group({1, 2});
    desk.click("Group", 2);
    QCOMPARE(last_step(desk.document()), "Lock Group");
    QVERIFY(desk.document().selection().empty());
    QCOMPARE(desk.shown_medium().size(), 5u);
    select_all(desk.document());
    QCOMPARE(desk.document().selection(), (Ids{3, 4, 5}));
    QVERIFY(!desk.view().handles().pick(desk.handle(0)));
    desk.click("Group");
    QVERIFY(desk.document().selection().empty());
    // A Gaussian that moves into it is locked too.
    select_gaussians(desk.document(), {3});
    QVERIFY(desk.choose("Group", "Move Selection Here"));
    QVERIFY(desk.document().selection().empty());
    QVERIFY(!desk.document().is_editable(3));
    desk.click("Group", 2);
    QVERIFY(desk.document().is_editable(3));
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
    for (const GaussianId id : {1, 2}) {
      select_gaussians(window.document(), {id});
      window.key(Qt::Key_G, Qt::ControlModifier);
    }
    auto* menu = window->findChild<QMenu*>("move_to_group");
    const auto choose = [&](const QString& text) {
      Q_EMIT menu->aboutToShow();
      for (QAction* action : menu->actions()) {
        if (without_mnemonic(action->text()) == text && action->isEnabled())
          return action->trigger();
      }
      QFAIL(qPrintable(text));
    };
    select_gaussians(window.document(), {2, 3});
    choose("Group");
    QCOMPARE(last_step(window.document()), "Move 2 Gaussians to Group");
    QCOMPARE(members_of(window.document().scene(), window.groups()[0].id), (Ids{1, 2, 3}));
    QCOMPARE(window.groups().size(), 2u);  // though one is empty now
    choose("Out of Groups");
    QCOMPARE(members_of(window.document().scene(), window.groups()[0].id), (Ids{1}));
    select_gaussians(window.document(), {1});
    window.key(Qt::Key_G, Qt::ControlModifier | Qt::ShiftModifier);
    QCOMPARE(last_step(window.document()), "Ungroup 1 Gaussian");
    VERIFY_UNDONE(window, before);
  }

  void groups_go_into_groups_once() {
    GroupsDesk desk;
    for (const GaussianId id : {1, 2, 3}) desk.group({id});
    QVERIFY(desk.choose("Group 2", "Move into/Group"));
    QCOMPARE(desk.groups()[1].parent, desk.groups()[0].id);
    QVERIFY(!desk.choose("Group", "Move into/Group 3"));    // it has one in it
    QVERIFY(!desk.choose("Group 3", "Move into/Group 2"));  // that is in one
    QVERIFY(!desk.choose("Group 3", "Move out of Group"));
    QVERIFY(desk.choose("Group 2", "Move out of Group"));
    QCOMPARE(desk.groups()[1].parent, GroupId{0});
    QVERIFY(desk.choose("Group", "Move into/Group 3"));
    QCOMPARE(last_step(desk.document()), "Move Group into Group 3");
  }
};

BRUME_APP_SUITE("groups", GroupsTest)
#include "groups_test.moc"
