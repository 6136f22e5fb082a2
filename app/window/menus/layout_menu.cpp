#include <QInputDialog>
#include <QMainWindow>
#include <QMenu>
#include <QSettings>
#include <QVariantMap>

#include "app/widgets/rows.h"
#include "app/window/menus/menus.h"

namespace brume {
namespace {

constexpr const char* layouts_key = "window/layouts";
constexpr int max_name_length = 60;

QVariantMap layouts() {
  return QSettings().value(layouts_key).toMap();
}

void store(const QVariantMap& layouts) {
  QSettings().setValue(layouts_key, layouts);
}

QString menu_text(QString name) {
  return name.replace('&', "&&");
}

void ask_for_name(QMainWindow& window) {
  auto* dialog = named(new QInputDialog(&window), "layout_name");
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setWindowTitle(QMenu::tr("Save Layout"));
  dialog->setLabelText(QMenu::tr("Name of the layout; one of the same name is replaced"));
  QObject::connect(dialog, &QInputDialog::textValueSelected, &window,
                   [&window](const QString& text) {
                     const QString name = text.simplified().left(max_name_length);
                     if (name.isEmpty()) return;
                     QVariantMap all = layouts();
                     all[name] = window.saveState();
                     store(all);
                   });
  dialog->open();
}

void fill(QMenu& menu, QMainWindow& window, const QByteArray& initial) {
  menu.clear();
  const QVariantMap all = layouts();
  for (auto it = all.begin(); it != all.end(); ++it) {
    menu.addAction(menu_text(it.key()), &window,
                   [&window, state = it.value().toByteArray()] { window.restoreState(state); });
  }
  menu.addSeparator();
  QAction* save =
      menu.addAction(QMenu::tr("&Save Current As…"), &window, [&window] { ask_for_name(window); });
  save->setObjectName("layout.save");
  QMenu* remove = menu.addMenu(QMenu::tr("&Delete"));
  remove->setObjectName("layout_delete");
  remove->setEnabled(!all.isEmpty());
  for (const QString& name : all.keys()) {
    remove->addAction(menu_text(name), &window, [name] {
      QVariantMap rest = layouts();
      rest.remove(name);
      store(rest);
    });
  }
  QAction* reset = menu.addAction(QMenu::tr("&Reset to Default"), &window,
                                  [&window, initial] { window.restoreState(initial); });
  reset->setObjectName("layout.reset");
}

}  // namespace

void fill_layout_menu(QMenu& menu, QMainWindow& window, const QByteArray& initial) {
  menu.setObjectName("layouts");
  fill(menu, window, initial);
  QObject::connect(&menu, &QMenu::aboutToShow, &window,
                   [&menu, &window, initial] { fill(menu, window, initial); });
}

}  // namespace brume
