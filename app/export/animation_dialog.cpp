#include "app/export/animation_dialog.h"

#include <QComboBox>
#include <QFileDialog>
#include <QFormLayout>
#include <QLineEdit>
#include <QPushButton>
#include <QStandardItemModel>

#include "app/document/paths.h"
#include "app/document/timeline.h"
#include "app/export/frame_export.h"
#include "app/export/video_file.h"
#include "app/files/file_dialogs.h"
#include "app/widgets/plain_text.h"
#include "app/widgets/rows.h"
#include "app/widgets/whole_number_box.h"
#include "brume/limits.h"
#include "core/io/disk/file_bytes.h"

namespace brume {

AnimationDialog::AnimationDialog(const Timeline& timeline, const QString& folder, QWidget* parent)
    : QDialog(parent),
      format_(named(new QComboBox(this), "animation_format")),
      file_(named(new QLineEdit(last_folder(FileKind::animation, folder) + "/animation.png", this),
                  "animation_file")),
      first_(
          named(new WholeNumberBox(tr("First frame"), 0, limits::frame, this), "animation_first")),
      last_(named(new WholeNumberBox(tr("Last frame"), 0, limits::frame, this), "animation_last")),
      names_(new PlainLabel(this)),
      export_(named(new QPushButton(tr("Export")), "export_animation")) {
  setWindowTitle(tr("Export animation"));
  setAttribute(Qt::WA_DeleteOnClose);
  format_->addItem(tr("PNG, one file per frame"), ".png");
  format_->addItem(tr("EXR with layers, one file per frame"), ".exr");
  format_->addItem(tr("MP4 video"), ".mp4");
  auto* why = named(new PlainLabel(tr("Video export needs the program ffmpeg on the PATH."), this),
                    "no_video");
  why->setVisible(find_ffmpeg().isEmpty());
  if (find_ffmpeg().isEmpty()) {
    QStandardItem* video = qobject_cast<QStandardItemModel*>(format_->model())->item(2);
    video->setEnabled(false);
    video->setToolTip(why->text());
  }
  file_->setMinimumWidth(360);
  first_->setValue(timeline.first());
  last_->setValue(timeline.last());

  auto* form = new QFormLayout(this);
  form->addRow(tr("As"), format_);
  form->addRow(QString(), why);
  auto* browse = new QPushButton(tr("Choose…"), this);
  form->addRow(tr("File"), row_of({file_, browse}));
  form->addRow(tr("First frame"), first_);
  form->addRow(tr("Last frame"), last_);
  form->addRow(QString(), names_);
  form->addRow(dialog_buttons(this, export_, [this] { confirm(); }));

  connect(browse, &QPushButton::clicked, this, &AnimationDialog::browse);
  connect(format_, &QComboBox::currentIndexChanged, this, [this] {
    std::filesystem::path file = to_path(file_->text());
    file_->setText(
        to_qstring(file.replace_extension(format_->currentData().toString().toStdString())));
  });
  connect(file_, &QLineEdit::textChanged, this, &AnimationDialog::show_names);
  for (WholeNumberBox* box : {first_, last_}) {
    connect(box, &WholeNumberBox::changed, this, &AnimationDialog::show_names);
  }
  show_names();
}

void AnimationDialog::show_names() {
  const std::filesystem::path file = to_path(file_->text());
  const int count = last_->value() - first_->value() + 1;
  const QString problem = first_->problem().isEmpty() ? last_->problem() : first_->problem();
  export_->setEnabled(problem.isEmpty() && count > 0 && file.has_stem());
  if (!problem.isEmpty()) {
    names_->setText(problem);
  } else if (count <= 0) {
    names_->setText(tr("The last frame is before the first."));
  } else if (lower_case_extension(file) == ".mp4") {
    names_->setText(tr("%1 frames").arg(count));
  } else {
    const auto name = [&](int frame) { return to_qstring(numbered_file(file, frame).filename()); };
    names_->setText(
        tr("%1 files, %2 to %3").arg(count).arg(name(first_->value()), name(last_->value())));
  }
}

void AnimationDialog::browse() {
  const QString name = QFileDialog::getSaveFileName(this, tr("Export animation"), file_->text(), {},
                                                    nullptr, QFileDialog::DontConfirmOverwrite);
  if (name.isEmpty()) return;
  std::filesystem::path file = to_path(name);
  file_->setText(
      to_qstring(file.replace_extension(format_->currentData().toString().toStdString())));
}

void AnimationDialog::confirm() {
  const std::filesystem::path file = to_path(file_->text());
  const std::pair<int, int> frames(first_->value(), last_->value());
  const bool is_video = lower_case_extension(file) == ".mp4";
  if (!may_replace(this, file, is_video ? std::nullopt : std::optional(frames))) return;
  remember_folder(FileKind::animation, file);
  Q_EMIT requested(file, frames.first, frames.second);
  accept();
}

}  // namespace brume
