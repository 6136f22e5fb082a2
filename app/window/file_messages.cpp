#include "app/window/file_messages.h"

#include <QCoreApplication>
#include <cstdio>

#include "app/document/document.h"
#include "app/files/scene_files.h"
#include "app/viewport/view_grid.h"
#include "app/window/pages/message_bar.h"

namespace brume {
namespace {

QString translate(const char* text) {
  return QCoreApplication::translate("brume::SceneFiles", text);
}

}  // namespace

void show_file_messages(const Workspace& work) {
  MessageBar* bar = &work.messages;
  SceneFiles* files = &work.files;
  const Document& document = work.document;
  const auto fail = [bar](const QString& message) {
    std::fprintf(stderr, "%s\n", qUtf8Printable(message));
    bar->show_error(message);
  };
  QObject::connect(files, &SceneFiles::failed, bar, fail);
  QObject::connect(&work.views, &ViewGrid::failed, bar, fail);
  QObject::connect(&files->loading(), &BackgroundJob::cancelled, bar,
                   [show_status = work.show_status] { show_status(translate("Not opened")); });
  QObject::connect(files, &SceneFiles::warned, bar, &MessageBar::show_note);
  QObject::connect(files, &SceneFiles::changed_on_disk, bar, [bar, files, &document] {
    bar->show_offers(
        translate("“%1” has been changed by another program.").arg(document.name()),
        {{translate("Reload"), "reload", [files] { files->reload(); }},
         {translate("Keep Mine"), "keep_mine", [files] { files->ignore_file_change(); }}});
  });
  QObject::connect(files, &SceneFiles::removed, bar, [bar, files, &document] {
    bar->show_offers(translate("“%1” is missing: it was deleted, moved or renamed. The scene is "
                               "unsaved until the file is back.")
                         .arg(document.name()),
                     {{translate("Save"), "save_missing", [files] { files->save(); }},
                      {translate("Save As…"), "save_missing_as", [files] { files->save_as(); }}});
  });
  QObject::connect(
      files, &SceneFiles::opened_without, bar,
      [bar, files](const QStringList& missing, const QString& warnings) {
        const QString text = translate(
                                 "Missing files: %1. The scene is shown without them; saving "
                                 "keeps the references.")
                                 .arg(missing.join(", "));
        bar->show_offers(
            warnings.isEmpty() ? text : text + '\n' + warnings,
            {{translate("Find…"), "find_missing", [files] { files->find_missing(); }}});
      });
  // Saved, or another scene.
  on_change(document, Change::file, bar, [bar] {
    if (bar->findChild<QWidget*>("reload")) bar->hide();
  });
  on_change(document, Change::modified, bar, [bar, &document] {
    if (document.is_file_missing()) return;
    if (bar->findChild<QWidget*>("save_missing")) bar->hide();
  });
  on_change(document, Change::scene, bar, &MessageBar::hide);
  QObject::connect(&document, &Document::refused, bar, &MessageBar::show_error);
  TransferJob& transfers = work.views.transfer_job();
  QObject::connect(&transfers, &TransferJob::warned, bar, &MessageBar::show_note);
  QObject::connect(&transfers.job(), &BackgroundJob::failed, bar, &MessageBar::show_error);
}

}  // namespace brume
