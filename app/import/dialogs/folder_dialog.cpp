#include "app/import/dialogs/folder_dialog.h"

#include <QFormLayout>
#include <QLineEdit>
#include <QPushButton>

#include "app/document/paths.h"
#include "app/widgets/plain_text.h"
#include "app/widgets/rows.h"

namespace brume {

QLineEdit* add_folder_row(QFormLayout* form, const std::filesystem::path& file,
                          const FrameRun& run) {
  auto* folder =
      named(new QLineEdit(to_qstring(file.parent_path() / "gaussians")), "sequence_folder");
  folder->setMinimumWidth(320);
  form->addRow(FolderDialog::tr("Write Gaussians to"), folder);
  form->addRow(new PlainLabel(FolderDialog::tr("Frames %1 to %2").arg(run.first).arg(run.last)));
  return folder;
}

FolderDialog::FolderDialog(const std::filesystem::path& file, const FrameRun& run, QWidget* parent)
    : QDialog(parent) {
  setWindowTitle(tr("Import %1").arg(to_qstring(file.filename())));
  setAttribute(Qt::WA_DeleteOnClose);
  auto* form = new QFormLayout(this);
  const QLineEdit* folder = add_folder_row(form, file, run);
  auto* import = named(new QPushButton(tr("Import")), "import_sequence");
  form->addRow(dialog_buttons(this, import, [this, folder] {
    Q_EMIT requested(folder->text());
    accept();
  }));
}

}  // namespace brume
