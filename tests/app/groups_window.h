#pragma once

#include <QLineEdit>
#include <QTreeWidget>
#include <vector>

#include "app/commands/gaussians/edit_groups.h"
#include "app/commands/gaussians/select_command.h"
#include "app/document/document.h"
#include "app/viewport/viewport.h"
#include "tests/app/desk.h"

namespace brume {

using Ids = std::vector<GaussianId>;

// The outliner's rows of groups, of a window or a desk.
template <class Window>
class WithGroups : public Window {
 public:
  using Window::document;
  using Window::view;
  const Groups& groups() { return document().scene().groups; }
  QTreeWidget& tree() {
    const QWidget& widget = *this;
    return *widget.findChild<QTreeWidget*>("outliner_tree");
  }
  // The row of a name, which is followed by a number.
  QTreeWidgetItem* row(const QString& name) {
    const auto found = tree().findItems(name + " (", Qt::MatchStartsWith | Qt::MatchRecursive);
    return found.isEmpty() ? nullptr : found.front();
  }
  QPoint position(const QString& name, int column = 0) {
    return cell_position(tree(), row(name), column);
  }
  void click(const QString& name, int column = 0) {
    QTest::mouseClick(tree().viewport(), Qt::LeftButton, {}, position(name, column));
  }
  // Chooses from the context menu of a row; "Move into/a" from a menu in it.
  bool choose(const QString& name, const QString& text) {
    return choose_from_menu(*tree().viewport(), position(name), text);
  }
  // Types a name into the editor that is open.
  void type_name(const QString& name) {
    const QWidget& rows = tree();
    auto* editor = rows.findChild<QLineEdit*>("row_name");
    QVERIFY(editor);
    editor->selectAll();
    QTest::keyClicks(editor, name);
    QTest::keyClick(editor, Qt::Key_Return);
  }
  void group(const Ids& ids) {
    select_gaussians(document(), ids);
    group_selection(document());
  }
  Medium shown_medium() { return view().shown_scene()->medium; }
};

using GroupsWindow = WithGroups<TestWindow>;
using GroupsDesk = WithGroups<Desk>;

// Makes the window of a test be left as it was opened once all is undone.
#define VERIFY_UNDONE(window, before)            \
  window.document().undo_stack().setIndex(0);    \
  QCOMPARE(bytes_of(window.document()), before); \
  QVERIFY(!window.document().is_modified())

}  // namespace brume
