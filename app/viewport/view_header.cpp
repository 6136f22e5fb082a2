#include "app/viewport/view_header.h"

#include <QLabel>
#include <QMenu>
#include <QToolButton>
#include <algorithm>

#include "app/viewport/viewport.h"
#include "app/widgets/application.h"
#include "app/widgets/number_field.h"
#include "app/widgets/plain_text.h"
#include "app/widgets/rows.h"
#include "app/widgets/value_field.h"

namespace brume {
namespace {

constexpr NumberDomain exposures{-max_exposure, max_exposure, "a number from -20 to 20"};

}  // namespace

ViewHeader::ViewHeader(Viewport& pane)
    : QToolBar(&pane),
      pane_(pane),
      mode_(add_button("pane_title", tr("What this view shows"))),
      quality_(add_button("header_quality", tr("How exactly all views are rendered"))) {
  setObjectName("view_header");
  setAutoFillBackground(true);
  setFocusPolicy(Qt::NoFocus);
  setCursor(Qt::ArrowCursor);
  setContextMenuPolicy(Qt::PreventContextMenu);
  auto* modes = new QMenu(mode_);
  for (const ViewMode mode : view_modes) {
    modes->addAction(view_mode_title(mode), &pane, [&pane, mode] { pane.frames().set_mode(mode); });
  }
  mode_->setMenu(modes);
  add_exposure();
  color_ = add_button("header_color", tr("How radiance becomes colours, in all views"));
  color_->setText(tr("Colour"));
  camera_ = add_button("header_camera", tr("The camera of the scene and this view"));
  overlays_ = add_button("header_overlays", tr("What is drawn over the picture"));
  overlays_->setText(tr("Overlays"));
  resolution_ = named(new PlainLabel(this), "header_resolution",
                      tr("Width and height of the picture at rest, in pixels"));
  resolution_->setContentsMargins(8, 0, 8, 0);
  addWidget(resolution_);
}

QToolButton* ViewHeader::add_button(const char* name, const QString& tip) {
  auto* button = named(new QToolButton(this), name, tip);
  button->setAutoRaise(true);
  button->setFocusPolicy(Qt::NoFocus);
  button->setPopupMode(QToolButton::InstantPopup);
  button->setAccessibleName(tip);
  addWidget(button);
  return button;
}

void ViewHeader::add_exposure() {
  exposure_ =
      named(new ValueField(tr("Exposure"), exposures, ValueField::Scale::linear, 0.05, this),
            "header_exposure", tr("Exposure of this view in stops; the scene is not changed"));
  exposure_->number().setFixedWidth(44);
  connect(exposure_, &ValueField::edited, this,
          [this](double stops) { pane_.frames().set_exposure(stops); });
  connect(exposure_, &ValueField::refused, this, &ViewHeader::refused);
  addWidget(exposure_);
  reset_ = named(new QToolButton(this), "header_reset", tr("Exposure 0"));
  reset_->setText(QStringLiteral("↺"));
  reset_->setAutoRaise(true);
  reset_->setFocusPolicy(Qt::NoFocus);
  connect(reset_, &QToolButton::clicked, this, [this] { pane_.frames().set_exposure(0.0); });
  addWidget(reset_);
}

void ViewHeader::set_menus(const Menus& menus) {
  quality_->setMenu(menus.quality);
  color_->setMenu(menus.color);
  camera_->setMenu(menus.camera);
  overlays_->setMenu(menus.overlays);
}

void ViewHeader::refresh(bool is_marked) {
  const FrameScheduler& frames = pane_.frames();
  mode_->setText(projection_title(pane_.projection()) + " · " + view_mode_title(frames.mode()));
  QPalette colors;  // what is not set follows the theme
  if (is_marked) colors.setColor(QPalette::ButtonText, accent_color());
  mode_->setPalette(colors);
  const FrameQuality& quality = frames.quality();
  quality_->setText(frames.mode() == ViewMode::path_traced        ? tr("Reference")
                    : quality.is_auto()                           ? tr("Auto")
                    : quality.airlight() == AirlightMethod::paper ? tr("Paper's Method")
                    : quality.is_fast()                           ? tr("Fast")
                                                                  : tr("Fixed"));
  exposure_->show_value(frames.exposure());
  reset_->setEnabled(frames.exposure() != 0.0);
  camera_->setText(pane_.camera_title());
  if (const RenderedFrame* frame = frames.shown()) {
    const Film& film = frame->request.film;
    resolution_->setText(QString("%1 × %2").arg(film.width).arg(film.height));
  }
  place();
}

void ViewHeader::place() {
  constexpr int margin = 4;  // pixels
  const int room = pane_.width() - 2 * margin;
  setGeometry(margin, margin, std::min(sizeHint().width(), std::max(room, 0)), sizeHint().height());
}

}  // namespace brume
