#include "app/export/frame_dialog.h"

#include <QComboBox>
#include <QFileDialog>
#include <QFormLayout>
#include <QLineEdit>
#include <QPushButton>
#include <QSpinBox>

#include "app/document/paths.h"
#include "app/files/file_dialogs.h"
#include "app/files/picture_format.h"
#include "app/widgets/layer_boxes.h"
#include "app/widgets/rows.h"
#include "render/settings.h"

namespace brume {
namespace {

constexpr int first_paths = 256;  // a noise of a few per cent in most scenes

}  // namespace

FrameDialog::FrameDialog(const QString& folder, bool path_traced, const OutputLayers& layers,
                         QWidget* parent)
    : QDialog(parent),
      format_(named(new QComboBox(this), "frame_format")),
      bits_(named(new QComboBox(this), "frame_bits")),
      file_(named(new QLineEdit(last_folder(FileKind::picture, folder) + "/frame.png", this),
                  "frame_file")),
      method_(named(new QComboBox(this), "frame_method")),
      paths_(named(new QSpinBox(this), "frame_paths")),
      layers_(new LayerBoxes(this)),
      export_(named(new QPushButton(tr("Export")), "export_frame")) {
  setWindowTitle(tr("Export frame"));
  setAttribute(Qt::WA_DeleteOnClose);
  format_->addItem(tr("PNG picture"), ".png");
  format_->addItem(tr("EXR with layers"), ".exr");
  format_->addItem(tr("Deep EXR, for holdouts"), ".deep.exr");
  bits_->addItem(tr("8, dithered"), 8);
  bits_->addItem(tr("16"), 16);
  bits_->setToolTip(tr("Of each value of a PNG: 16 are for further editing"));
  file_->setMinimumWidth(360);
  method_->addItem(tr("As in View > Quality"), false);
  method_->addItem(tr("Path traced"), true);
  method_->setCurrentIndex(path_traced ? 1 : 0);
  method_->setToolTip(
      tr("Path traced: all light, scattered and reflected any number of times, with noise that "
         "four times the paths halve"));
  paths_->setRange(1, max_paths);
  paths_->setValue(first_paths);

  auto* form = new QFormLayout(this);
  form->addRow(tr("As"), format_);
  form->addRow(tr("Bits"), bits_);
  auto* browse = new QPushButton(tr("Choose…"), this);
  form->addRow(tr("File"), row_of({file_, browse}));
  form->addRow(tr("Rendered"), method_);
  form->addRow(tr("Paths per pixel"), paths_);
  layers_->set_layers(layers);
  form->addRow(tr("Layers"), layers_);
  form->addRow(dialog_buttons(this, export_, [this] { confirm(); }));

  connect(browse, &QPushButton::clicked, this, &FrameDialog::browse);
  connect(format_, &QComboBox::currentIndexChanged, this, [this] {
    file_->setText(to_qstring(with_extension(file_->text())));
    update_enabled();
  });
  connect(file_, &QLineEdit::textChanged, this, &FrameDialog::update_enabled);
  connect(method_, &QComboBox::currentIndexChanged, this, &FrameDialog::update_enabled);
  update_enabled();
}

void FrameDialog::update_enabled() {
  const QString format = format_->currentData().toString();
  const bool is_deep = format == ".deep.exr";
  method_->setEnabled(!is_deep);
  paths_->setEnabled(!is_deep && method_->currentData().toBool());
  layers_->setEnabled(format == ".exr");
  bits_->setEnabled(format == ".png");
  export_->setEnabled(to_path(file_->text()).has_stem());
}

std::filesystem::path FrameDialog::with_extension(const QString& name) const {
  return with_picture_format(to_path(name), format_->currentData().toString().toStdString());
}

void FrameDialog::browse() {
  const QString name = QFileDialog::getSaveFileName(this, tr("Export frame"), file_->text(), {},
                                                    nullptr, QFileDialog::DontConfirmOverwrite);
  if (!name.isEmpty()) file_->setText(to_qstring(with_extension(name)));
}

void FrameDialog::confirm() {
  const std::filesystem::path file = to_path(file_->text());
  if (!may_replace(this, file, std::nullopt)) return;
  remember_folder(FileKind::picture, file);
  const bool path_traced = paths_->isEnabled();
  Q_EMIT requested(file, path_traced ? std::optional(paths_->value()) : std::nullopt,
                   layers_->layers(), bits_->currentData().toInt());
  accept();
}

}  // namespace brume
