#include "app/window/help_windows.h"

#include <QAction>
#include <QCoreApplication>
#include <QDialog>
#include <QKeySequence>
#include <QLabel>
#include <QScrollArea>
#include <QVBoxLayout>

namespace brume {
namespace {

QString tr(const char* text) {
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
  show_text(parent, tr("About Brume"),
            tr("<h2>Brume %1</h2><p>An editor and renderer for fog, smoke and steam modelled as "
               "Gaussians.</p>")
                .arg(QCoreApplication::applicationVersion()));
}

void show_keys(QWidget* parent, const QList<QAction*>& actions) {
  QString html = "<table>";
  html += row(tr("Select"), tr("Click"));
  html += row(tr("Add to the selection, toggle"), tr("Shift+Click, Ctrl+Click"));
  html += row(tr("Box select"), tr("Drag"));
  html += row(tr("Move the selection"), tr("Drag a selected handle; Escape cancels"));
  html += row(tr("Orbit"), tr("Middle button, or Alt+Left"));
  html += row(tr("Pan"), tr("Shift+Middle, or Alt+Middle"));
  html += row(tr("Zoom"), tr("Wheel, or Alt+Right"));
  for (const QAction* action : actions) {
    if (action->shortcut().isEmpty()) continue;
    html += row(action->iconText(), action->shortcut().toString(QKeySequence::NativeText));
  }
  show_text(parent, tr("Keyboard shortcuts"), html + "</table>");
}

}  // namespace brume
