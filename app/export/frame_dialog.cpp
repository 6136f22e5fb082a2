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
#include "app/widgets/method_box.h"
#include "app/widgets/rows.h"
#include "render/settings.h"

namespace brume {
FrameDialog::FrameDialog(const QString& folder, bool path_traced, const OutputLayers& layers,
                         QWidget* parent)
    : QDialog(parent),
      format_(named(new QComboBox(this), "frame_format")),
      bits_(named(new QComboBox(this), "frame_bits")),
      file_(named(new QLineEdit(last_folder(FileKind::picture, folder) + "/frame.png", this),
                  "frame_file")),
      method_(named(new MethodBox(this), "frame_method")),
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
  if (path_traced) method_->set_paths(Denoising::solved);  // as the view shows them
  paths_->setRange(1, max_paths);
  const auto offer_paths = [this] {
    paths_->setValue(MethodBox::first_paths(method_->paths().value_or(Denoising::solved)));
  };
  offer_paths();

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
  connect(method_, &QComboBox::currentIndexChanged, this, [this, offer_paths] {
    offer_paths();
    update_enabled();
  });
  update_enabled();
}

void FrameDialog::update_enabled() {
  const QString format = format_->currentData().toString();
  const bool is_deep = format == ".deep.exr";
  method_->setEnabled(!is_deep);
  paths_->setEnabled(!is_deep && method_->paths());
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
  Output output;
  if (paths_->isEnabled()) {
    output.paths = paths_->value();
    output.denoise = method_->paths().value_or(Denoising::none);
  }
  output.layers = layers_->layers();
  Q_EMIT requested(file, output, bits_->currentData().toInt());
  accept();
}

}  // namespace brume
