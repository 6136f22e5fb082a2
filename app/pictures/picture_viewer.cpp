#include "app/pictures/picture_viewer.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>

#include "app/document/text/number_text.h"
#include "app/pictures/picture_scope.h"
#include "app/pictures/slot_strip.h"
#include "app/widgets/frame_text.h"
#include "app/widgets/plain_text.h"
#include "app/widgets/rows.h"

namespace brume {
namespace {

constexpr int side_width = 240;

QString channels_text(const std::array<float, 3>& rgb) {
  return QString("%1 %2 %3")
      .arg(number_text(rgb[0], 4), number_text(rgb[1], 4), number_text(rgb[2], 4));
}

}  // namespace

PictureViewer::PictureViewer(QWidget* parent)
    : QWidget(parent),
      strip_(new SlotStrip(slots_, this)),
      canvas_(new PictureCanvas(this)),
      scope_(new PictureScope(this)),
      mode_(named(new QComboBox(this), "picture_mode")),
      gain_(named(new QComboBox(this), "difference_gain")),
      layer_(named(new QComboBox(this), "picture_layer")),
      name_(named(new QLineEdit(this), "picture_name")),
      note_(named(new QLineEdit(this), "picture_note")),
      info_(named(new PlainLabel(this), "picture_info")),
      pixel_(named(new PlainLabel(this), "picture_pixel")) {
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(6, 6, 6, 6);
  auto* tools = new QHBoxLayout;
  add_tools(*tools);
  layout->addLayout(tools);
  auto* middle = new QHBoxLayout;
  middle->addWidget(canvas_, 1);
  middle->addLayout(new_side());
  layout->addLayout(middle, 1);
  layout->addWidget(strip_);

  connect(&slots_, &PictureSlots::changed, this, &PictureViewer::show_pictures);
  connect(&slots_, &PictureSlots::labelled, this, &PictureViewer::show_labels);
  connect(strip_, &SlotStrip::chosen, this, &PictureViewer::show_pictures);
  connect(canvas_, &PictureCanvas::pointed_at, this, &PictureViewer::show_pixel);
  show_pictures();
}

void PictureViewer::add_tools(QBoxLayout& row) {
  mode_->addItems({tr("A alone"), tr("Wipe A | B"), tr("Difference A − B")});
  mode_->setToolTip(tr("Wipe: A left and B right of a line; drag the line"));
  for (const int stops : {0, 2, 4, 6, 8}) gain_->addItem(tr("× %1").arg(1 << stops), stops);
  gain_->setToolTip(tr("How many times the difference is shown"));
  gain_->hide();
  layer_->setToolTip(tr("What is shown of the pictures: all their light, or a layer"));
  layer_->setSizeAdjustPolicy(QComboBox::AdjustToContents);
  connect(mode_, &QComboBox::currentIndexChanged, this, [this](int index) {
    canvas_->set_mode(static_cast<PictureCanvas::Mode>(index));
    gain_->setVisible(canvas_->mode() == PictureCanvas::Mode::difference);
    show_pictures();
  });
  connect(gain_, &QComboBox::currentIndexChanged, this, &PictureViewer::compare);
  connect(layer_, &QComboBox::activated, this, &PictureViewer::show_pictures);
  for (QWidget* widget : {mode_, gain_, layer_}) row.addWidget(widget);
  row.addStretch();
  const auto add = [&](const QString& text, const char* name, const QString& tip, auto react) {
    auto* button = named(new QPushButton(text, this), name, tip);
    connect(button, &QPushButton::clicked, this, react);
    row.addWidget(button);
  };
  add(tr("Fit"), "picture_fit", tr("Shows the whole picture"), [this] { canvas_->fit(); });
  add(tr("1:1"), "picture_actual", tr("A pixel of the picture on a pixel of the screen"),
      [this] { canvas_->actual_size(); });
  add(tr("Clear Slot"), "clear_slot", tr("Empties the slot that is shown as A"),
      [this] { slots_.set(strip_->a(), nullptr); });
  add(tr("Save…"), "save_picture",
      tr("Saves the picture that is shown as A, as it looks, as a PNG with its note"), [this] {
        const std::size_t slot = strip_->a();
        if (shown_a_) Q_EMIT save_asked_for(shown_a_, slots_.name(slot), slots_.note(slot));
      });
  add(tr("Keep View"), "keep_view", tr("Keeps what the view shows in the next empty slot"),
      [this] { Q_EMIT keep_view_asked_for(); });
}

QBoxLayout* PictureViewer::new_side() {
  auto* scope = named(new QComboBox(this), "picture_scope_kind",
                      tr("How the values of the shown picture are spread: how many pixels have "
                         "each, black left and white right, or those of each of its columns, black "
                         "at the bottom"));
  scope->addItems({tr("No scope"), tr("Histogram"), tr("Waveform")});
  scope->setFixedWidth(side_width);
  connect(scope, &QComboBox::currentIndexChanged, this,
          [this](int index) { scope_->set_kind(static_cast<PictureScope::Kind>(index)); });
  name_->setPlaceholderText(tr("Name"));
  name_->setToolTip(tr("The name of the picture that is shown as A"));
  note_->setPlaceholderText(tr("Note"));
  note_->setToolTip(tr("What there is to say of the picture that is shown as A"));
  for (QLineEdit* field : {name_, note_}) {
    connect(field, &QLineEdit::editingFinished, this, &PictureViewer::take_labels);
  }
  pixel_->setToolTip(
      tr("Linear radiance of the pixel under the mouse, red, green and blue, or what "
         "the layer has there"));
  auto* side = new QVBoxLayout;
  for (QWidget* widget :
       std::initializer_list<QWidget*>{scope, scope_, name_, note_, info_, pixel_}) {
    widget->setFixedWidth(side_width);
    side->addWidget(widget);
  }
  for (QLabel* label : {info_, pixel_}) {
    label->setWordWrap(true);
    label->setAlignment(Qt::AlignTop | Qt::AlignLeft);
  }
  side->setStretch(side->indexOf(scope_), 1);
  side->setStretch(side->indexOf(info_), 1);
  return side;
}

void PictureViewer::show_new(std::size_t slot) {
  const std::size_t shown = strip_->a();
  if (shown == slot) return;
  if (a()) strip_->choose_b(shown);
  strip_->choose_a(slot);
}

const std::shared_ptr<const Picture>& PictureViewer::a() const {
  return slots_.at(strip_->a());
}

const std::shared_ptr<const Picture>& PictureViewer::b() const {
  return slots_.at(strip_->b());
}

void PictureViewer::add_layer_names() {
  const QString chosen = layer_->currentData().toString();
  layer_->clear();
  layer_->addItem(tr("Picture"), QString());
  if (!a()) return;
  for (const PictureLayer& layer : a()->layers) layer_->addItem(layer.name, layer.name);
  layer_->setCurrentIndex(std::max(0, layer_->findData(chosen)));
}

void PictureViewer::show_pictures() {
  add_layer_names();
  const QString layer = layer_->currentData().toString();
  layering_.cancel();
  if (layer.isEmpty()) return show_both(a(), b());
  layering_.start([this, layer, first = a(), second = b()](const Job&) -> BackgroundJob::Apply {
    const auto layer_a = layer_picture(*first, layer);
    const auto layer_b = second ? layer_picture(*second, layer) : nullptr;
    return [this, layer_a, layer_b] { show_both(layer_a, layer_b); };
  });
}

void PictureViewer::show_both(const std::shared_ptr<const Picture>& a,
                              const std::shared_ptr<const Picture>& b) {
  shown_a_ = a;
  shown_b_ = b;
  difference_.reset();
  canvas_->show_pictures(a, b);
  scope_->show_image(a ? a->image : QImage());
  show_labels();
  show_pixel(std::nullopt);
  compare();
}

void PictureViewer::take_labels() {
  const auto is_typed = [](QLineEdit& field) {
    const bool is_modified = field.isModified();
    field.setModified(false);
    return is_modified;
  };
  if (is_typed(*name_)) slots_.set_name(labelled_, name_->text());
  if (is_typed(*note_)) slots_.set_note(labelled_, note_->text());
}

void PictureViewer::show_labels() {
  if (labelled_ != strip_->a()) take_labels();
  labelled_ = strip_->a();
  const auto show = [this](QLineEdit& field, const QString& text) {
    field.setEnabled(a() != nullptr);
    // One may be typing while a render changes the picture.
    if (!field.hasFocus() || !field.isModified()) field.setText(text);
  };
  show(*name_, slots_.name(labelled_));
  show(*note_, slots_.note(labelled_));
  show_info();
}

void PictureViewer::compare() {
  comparing_.cancel();
  if (canvas_->mode() == PictureCanvas::Mode::single || !shown_a_ || !shown_b_) return;
  const bool is_shown = canvas_->mode() == PictureCanvas::Mode::difference;
  comparing_.start([this, is_shown, first = shown_a_, second = shown_b_,
                    stops = gain_->currentData().toDouble()](const Job&) -> BackgroundJob::Apply {
    const QImage image = is_shown ? difference_image(*first, *second, stops) : QImage();
    return [this, image, difference = relative_difference(*first, *second)] {
      canvas_->show_difference(image);
      difference_ = difference;
      show_info();
    };
  });
}

void PictureViewer::show_info() {
  const auto text = [this](const QString& letter, std::size_t slot) {
    return QString("%1: %2 · %3").arg(letter, slots_.name(slot), slots_.at(slot)->details);
  };
  QStringList lines;
  if (a()) lines << text(tr("A"), strip_->a());
  if (canvas_->mode() != PictureCanvas::Mode::single && b()) {
    lines << text(tr("B"), strip_->b());
    lines << (difference_
                  ? tr("A differs from B by %1 (relative RMS)").arg(percent_text(*difference_))
                  : QString(" "));
  }
  info_->setText(lines.join('\n'));
}

void PictureViewer::show_pixel(std::optional<QPoint> pixel) {
  if (!pixel || !shown_a_) return pixel_->setText(" \n \n ");
  const Picture& first = *shown_a_;
  QStringList lines{tr("Pixel %1, %2").arg(pixel->x()).arg(pixel->y()),
                    tr("A %1").arg(channels_text(first.at(pixel->x(), pixel->y())))};
  const bool compares = canvas_->mode() != PictureCanvas::Mode::single && shown_b_;
  if (compares && shown_b_->width == first.width && shown_b_->height == first.height) {
    lines << tr("B %1").arg(channels_text(shown_b_->at(pixel->x(), pixel->y())));
  } else {
    lines << " ";
  }
  pixel_->setText(lines.join('\n'));
}

void PictureViewer::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  Q_EMIT visibility_changed(true);
}

void PictureViewer::hideEvent(QHideEvent* event) {
  QWidget::hideEvent(event);
  Q_EMIT visibility_changed(false);
}

}  // namespace brume
