// The rows of the output panel about files: where pictures are written, and how.

#include <QComboBox>
#include <QFileDialog>
#include <QFormLayout>
#include <QLineEdit>
#include <QSettings>
#include <QStandardItemModel>
#include <QToolButton>

#include "app/commands/objects/edit_output.h"
#include "app/document/document.h"
#include "app/document/paths.h"
#include "app/document/time/timeline.h"
#include "app/files/file_dialogs.h"
#include "app/files/numbered_file.h"
#include "app/files/picture_format.h"
#include "app/panels/forms/output_panel.h"
#include "app/widgets/plain_text.h"
#include "app/widgets/rows.h"
#include "core/io/disk/file_bytes.h"

namespace brume {
namespace {

constexpr const char* bits_key = "output/png_bits";

}  // namespace

QComboBox* OutputPanel::new_format() {
  auto* format = named(new QComboBox(this), "output_format");
  format->addItem(tr("PNG picture"), ".png");
  format->addItem(tr("EXR with layers"), ".exr");
  format->addItem(tr("Deep EXR, for holdouts"), ".deep.exr");
  format->addItem(tr("MP4 video"), ".mp4");
  format->setToolTip(
      tr("PNG: ready to show. EXR: linear light in 32-bit floats, with layers, for compositing. "
         "MP4: a video of all frames, by the program ffmpeg"));
  if (find_ffmpeg().isEmpty()) {
    QStandardItem* video = qobject_cast<QStandardItemModel*>(format->model())->item(3);
    video->setEnabled(false);
    video->setToolTip(tr("Videos need the program ffmpeg on the PATH."));
  }
  return format;
}

void OutputPanel::add_bits(QFormLayout& form) {
  bits_ = named(new QComboBox(this), "output_bits",
                tr("Of each value of a PNG: 16 are for further editing. A setting of yours, not of "
                   "the scene"));
  bits_->addItem(tr("8, dithered"), 8);
  bits_->addItem(tr("16"), 16);
  bits_->setCurrentIndex(QSettings().value(bits_key).toInt() == 16 ? 1 : 0);
  form.addRow(tr("Bits"), bits_);
  connect(bits_, &QComboBox::activated, this,
          [this] { QSettings().setValue(bits_key, png_bits()); });
  on_refresh([this] { bits_->setEnabled(picture_format(output().file) == ".png"); });
}

int OutputPanel::png_bits() const {
  return bits_->currentData().toInt();
}

void OutputPanel::add_file(QFormLayout& form) {
  auto* file = named(new QLineEdit(this), "output_file");
  file->setPlaceholderText(tr("none: into the picture viewer only"));
  auto* choose = new QToolButton(this);
  choose->setText("…");
  choose->setToolTip(tr("Choose a file"));
  form.addRow(tr("File"), row_of({file, choose}));
  auto* format = new_format();
  form.addRow(tr("Format"), format);
  add_bits(form);
  auto* names = named(new PlainLabel(this), "output_names");
  names->setWordWrap(true);
  form.addRow({}, names);
  connect(choose, &QToolButton::clicked, this, &OutputPanel::browse);
  connect(file, &QLineEdit::editingFinished, this, [this, file, format] {
    if (!file->isModified()) return;
    file->setModified(false);
    const QString text = file->text().trimmed();
    if (text.isEmpty()) return set_file({});
    std::filesystem::path path = to_path(document_.folder()) / to_path(text);
    if (path.extension().empty()) path += format->currentData().toString().toStdString();
    set_file(std::move(path));
  });
  connect(format, &QComboBox::activated, this, [this, format] {
    if (output().file.empty()) return;
    set_file(with_picture_format(output().file, format->currentData().toString().toStdString()));
  });
  on_refresh([this, file, format, names] {
    const std::filesystem::path& path = output().file;
    const std::filesystem::path folder = to_path(document_.folder());
    const std::filesystem::path relative = path.lexically_relative(folder);
    const bool is_inside = !relative.empty() && *relative.begin() != "..";
    if (!file->hasFocus() || !file->isModified()) {
      file->setText(to_qstring(is_inside ? relative : path));
    }
    file->setToolTip(plain_tool_tip(
        path.empty() ? tr("Where pictures are written; frames of an animation get numbers. Without "
                          "a file, they are only shown")
                     : to_qstring(path)));
    const int index = format->findData(QString::fromStdString(picture_format(path)));
    if (index >= 0) format->setCurrentIndex(index);
    const auto name = [&](int frame) { return to_qstring(numbered_file(path, frame).filename()); };
    const bool is_video = lower_case_extension(path) == ".mp4";
    names->setVisible(!path.empty());
    names->setText(
        is_video && find_ffmpeg().isEmpty() ? tr("Videos need the program ffmpeg on the PATH.")
        : is_video
            ? tr("Frames %1 to %2").arg(timeline_.first()).arg(timeline_.last())
            : tr("Animation: %1 to %2").arg(name(timeline_.first()), name(timeline_.last())));
  });
}

void OutputPanel::set_file(std::filesystem::path file) {
  const std::string extension = lower_case_extension(file);
  if (!file.empty() && extension != ".png" && extension != ".exr" && extension != ".mp4") {
    Q_EMIT refused(tr("Pictures are written as .png or .exr, videos as .mp4."));
    return refresh();
  }
  file = file.lexically_normal();
  change_output(document_, tr("Set file of output"), no_merge,
                [&](Output& output) { output.file = file; });
  refresh();
}

void OutputPanel::browse() {
  const QString start = output().file.empty()
                            ? last_folder(FileKind::picture, document_.folder()) + "/render.png"
                            : to_qstring(output().file);
  const QString name = QFileDialog::getSaveFileName(
      this, tr("Output File"), start, tr("Pictures and videos (*.png *.exr *.mp4);;All files (*)"),
      nullptr, QFileDialog::DontConfirmOverwrite);
  if (name.isEmpty()) return;
  remember_folder(FileKind::picture, to_path(name));
  set_file(to_path(name));
}

}  // namespace brume
