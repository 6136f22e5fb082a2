#include "app/import/folder_dialog.h"

#include <QDialogButtonBox>
#include <QFormLayout>
#include <QLineEdit>
#include <QPushButton>

#include "app/document/paths.h"
#include "app/widgets/plain_text.h"

namespace brume {

QLineEdit* add_folder_row(QFormLayout* form, const std::filesystem::path& file,
                          const FrameRun& run) {
  auto* folder = new QLineEdit(to_qstring(file.parent_path() / "gaussians"));
  folder->setObjectName("sequence_folder");
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
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel, this);
  buttons->addButton(tr("Import"), QDialogButtonBox::AcceptRole)->setObjectName("import_sequence");
  form->addRow(buttons);
  connect(buttons, &QDialogButtonBox::accepted, this, [this, folder] {
    Q_EMIT requested(folder->text());
    accept();
  });
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
}

}  // namespace brume
