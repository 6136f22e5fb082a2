#include "app/window/dialogs/help_windows.h"

#include <QAction>
#include <QCoreApplication>
#include <QDesktopServices>
#include <QDialog>
#include <QFileInfo>
#include <QKeySequence>
#include <QLabel>
#include <QScrollArea>
#include <QUrl>
#include <QVBoxLayout>

#include "app/document/paths.h"
#include "app/widgets/mnemonics.h"

namespace brume {
namespace {

QString help_text(const char* text) {
  return QCoreApplication::translate("Help", text);
}

void show_text(QWidget* parent, const QString& title, const QString& html) {
  auto* window = new QDialog(parent);
  window->setAttribute(Qt::WA_DeleteOnClose);
  window->setWindowTitle(title);
  auto* label = new QLabel(html);
  label->setTextFormat(Qt::RichText);
  label->setMargin(16);
  label->setAlignment(Qt::AlignTop | Qt::AlignLeft);
  auto* scroll = new QScrollArea(window);
  scroll->setWidget(label);
  scroll->setWidgetResizable(true);
  scroll->setFrameShape(QFrame::NoFrame);
  auto* layout = new QVBoxLayout(window);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(scroll);
  window->resize(label->sizeHint().boundedTo(QSize(640, 620)) + QSize(24, 8));
  window->show();
}

QString row(const QString& what, const QString& keys) {
  return QString("<tr><td style='padding-right:32px'>%1</td><td>%2</td></tr>")
      .arg(what.toHtmlEscaped(), keys.toHtmlEscaped());
}

}  // namespace

void show_about(QWidget* parent) {
  show_text(
      parent, help_text("About Brume"),
      help_text("<h2>Brume %1</h2><p>An editor and renderer for fog, smoke and steam modelled as "
                "Gaussians.</p>")
          .arg(QCoreApplication::applicationVersion()));
}

void show_keys(QWidget* parent, const QList<QAction*>& actions) {
  QString html = "<table>";
  html += row(help_text("Select"), help_text("Click"));
  html += row(help_text("Add to the selection, toggle"), help_text("Shift+Click, Ctrl+Click"));
  html += row(help_text("Box select"), help_text("Drag"));
  html += row(help_text("Move the selection"), help_text("Drag a selected handle; Escape cancels"));
  html += row(help_text("Orbit"), help_text("Middle button, or Alt+Left"));
  html += row(help_text("Pan"), help_text("Shift+Middle, or Alt+Middle"));
  html += row(help_text("Zoom"), help_text("Wheel, or Alt+Right"));
  for (const QAction* action : actions) {
    if (action->shortcut().isEmpty()) continue;
    html += row(command_title(*action), action->shortcut().toString(QKeySequence::NativeText));
  }
  show_text(parent, help_text("Keyboard Shortcuts"), html + "</table>");
}

QString open_manual(const std::filesystem::path& folder) {
  const QString page = to_qstring(folder / "index.html");
  if (!QFileInfo::exists(page)) {
    return help_text(
               "The manual is not installed: %1 is missing. In Debian it is the package "
               "brume-doc.")
        .arg(page);
  }
  if (!QDesktopServices::openUrl(QUrl::fromLocalFile(page))) {
    return help_text("No browser could be started to show %1").arg(page);
  }
  return {};
}

}  // namespace brume
