// The menu Help.

#include <QDesktopServices>
#include <QLabel>
#include <QMenuBar>

#include "app/document/paths.h"
#include "app/window/dialogs/help_windows.h"
#include "app/window/pages/message_bar.h"
#include "core/io/disk/installed_files.h"
#include "tests/app/test_window.h"

using namespace brume;

namespace {

// Stands in for the desktop's browser.
class Browser : public QObject {
  Q_OBJECT
 public:
  Browser() { QDesktopServices::setUrlHandler("file", this, "open"); }
  ~Browser() override { QDesktopServices::unsetUrlHandler("file"); }
  Browser(const Browser&) = delete;
  Browser& operator=(const Browser&) = delete;

  QList<QUrl> opened;

 public Q_SLOTS:
  void open(const QUrl& url) { opened << url; }
};

}  // namespace

class HelpTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void f1_opens_the_manual() {
    const Browser browser;
    TestWindow window;
    window.key(Qt::Key_F1);
    const QUrl page = QUrl::fromLocalFile(to_qstring(manual_folder() / "index.html"));
    QCOMPARE(browser.opened, QList<QUrl>{page});
    QVERIFY(QFileInfo::exists(page.toLocalFile()));
    QVERIFY(!window->findChild<MessageBar*>()->isVisible());
  }

  void menu_opens_the_manual() {
    const Browser browser;
    TestWindow window;
    QTest::keyClick(window->menuBar(), Qt::Key_H, Qt::AltModifier);
    QTRY_VERIFY(QApplication::activePopupWidget());
    QTest::keyClick(QApplication::activePopupWidget(), Qt::Key_M);
    QCOMPARE(browser.opened.size(), 1);
  }

  void keys_are_listed_by_commands_and_their_menus() {
    TestWindow window;
    window.document().undo_stack().push(new QUndoCommand("Move"));
    window.document().undo_stack().undo();
    window->findChild<QAction*>("help.keys")->trigger();
    QString text;
    for (const QLabel* label : window->findChildren<QLabel*>()) {
      if (label->text().startsWith("<table>")) text = label->text();
    }
    for (const char* title :
         {">Select › All<", ">Edit › Undo<", ">Edit › Redo<", ">File › Open<"}) {
      QVERIFY2(text.contains(title), title);
    }
  }

  void missing_manual_is_named() {
    const Browser browser;
    const QTemporaryDir folder;
    const QString error = open_manual(to_path(folder.path()));
    QVERIFY(error.contains(folder.filePath("index.html")));
    QVERIFY(error.contains("brume-doc"));
    QVERIFY(browser.opened.isEmpty());
  }
};

BRUME_APP_SUITE("help", HelpTest)

#include "help_test.moc"
