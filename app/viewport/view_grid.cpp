#include "app/viewport/view_grid.h"

#include <QGridLayout>

#include "app/widgets/interface_settings.h"

namespace brume {

ViewGrid::ViewGrid(Document& document, QWidget* parent)
    : QWidget(parent), document_(document), services_(document), layout_(new QGridLayout(this)) {
  layout_->setContentsMargins(0, 0, 0, 0);
  layout_->setSpacing(2);
  connect(&services_.frames.service, &FrameService::backend_changed, this,
          &ViewGrid::backend_changed);
  auto& settings = InterfaceSettings::instance();
  const auto limit_memory = [this, &settings] {
    services_.frames.cache.set_capacity(static_cast<std::size_t>(settings.frame_memory()) << 20);
  };
  connect(&settings, &InterfaceSettings::changed, this, limit_memory);
  limit_memory();
  make_pane(Projection::perspective);
  activate(perspective());
  arrange();
}

// The panes go before what they share.
ViewGrid::~ViewGrid() {
  qDeleteAll(panes_);
}

void ViewGrid::make_pane(Projection projection) {
  auto* pane = new Viewport(document_, services_, projection, this);
  pane->setAccessibleName(projection_title(projection));
  const std::size_t k = panes_.size();
  panes_.push_back(pane);
  layout_->addWidget(pane, static_cast<int>(k / 2), static_cast<int>(k % 2));

  auto* header = headers_.emplace_back(new ViewHeader(*pane));
  header->set_menus(menus_);
  connect(header, &ViewHeader::refused, this, &ViewGrid::failed);
  pane->installEventFilter(this);
  const auto update_header = [this, pane, header] {
    header->refresh(pane == active_ && shows_four_);
  };
  for (const auto signal : {&FrameScheduler::frame_shown, &FrameScheduler::picture_changed,
                            &FrameScheduler::mode_changed}) {
    connect(&pane->frames(), signal, header, update_header);
  }
  connect(&pane->camera_controller(), &CameraController::moved, header, update_header);
  connect(&pane->frames().quality(), &FrameQuality::settings_changed, header, update_header);

  connect(pane, &Viewport::used, this, [this, pane] { activate(*pane); });
  connect(&pane->frames(), &FrameScheduler::failed, this, &ViewGrid::failed);
  connect(pane, &Viewport::pointed_at, this,
          [this, pane](QPointF position) { Q_EMIT pointed_at(*pane, position); });
  connect(pane, &Viewport::menu_asked, this,
          [this, pane](QPointF position) { Q_EMIT menu_asked(*pane, position); });
  const auto pass_on = [this, pane](auto signal) {
    return [this, pane, signal] {
      if (pane == active_) Q_EMIT(this->*signal)();
    };
  };
  connect(&pane->frames(), &FrameScheduler::frame_shown, this, pass_on(&ViewGrid::frame_shown));
  connect(&pane->frames(), &FrameScheduler::mode_changed, this, pass_on(&ViewGrid::mode_changed));
  connect(&pane->frames().quality(), &FrameQuality::error_changed, this,
          pass_on(&ViewGrid::error_changed));

  if (pane != panes_.front()) {
    pane->set_time(perspective().time());
    pane->show_ground_grid(shows_ground_grid_);
    FrameScheduler& frames = pane->frames();
    const FrameScheduler& first = perspective().frames();
    frames.set_exposure(first.exposure());
    frames.quality().set_airlight(first.quality().airlight(), first.quality().slices());
    frames.quality().set_scattering(first.quality().scattering());
    frames.quality().set_max_error(first.quality().max_error());
    pane->camera_controller().set_navigation(perspective().camera_controller().navigation());
    pane->set_tool(tool_);
    pane->show_overlay(shows_overlays_);
    Q_EMIT pane_made(pane);
  }
}

Viewport& ViewGrid::pointed() const {
  for (Viewport* pane : panes_) {
    if (pane->isVisible() && pane->underMouse()) return *pane;
  }
  return *active_;
}

void ViewGrid::activate(Viewport& pane) {
  if (active_ == &pane) return;
  if (active_) active_->frames().set_active(false);
  active_ = &pane;
  setFocusProxy(&pane);
  pane.frames().set_active(true);
  update_headers();
  Q_EMIT active_changed();
  Q_EMIT mode_changed();
}

void ViewGrid::show_four(bool four) {
  if (four == shows_four_) return;
  shows_four_ = four;
  if (panes_.size() == 1) {
    for (const Projection projection : {Projection::top, Projection::front, Projection::side}) {
      make_pane(projection);
    }
  }
  arrange();
  active_->setFocus();
}

void ViewGrid::arrange() {
  for (Viewport* pane : panes_) pane->setVisible(shows_four_ || pane == active_);
  update_headers();
}

void ViewGrid::update_headers() {
  for (std::size_t k = 0; k < panes_.size(); ++k) {
    headers_[k]->refresh(panes_[k] == active_ && shows_four_);
  }
}

void ViewGrid::set_header_menus(const ViewHeader::Menus& menus) {
  menus_ = menus;
  for (ViewHeader* header : headers_) header->set_menus(menus);
}

// The header of a pane is as wide as it.
bool ViewGrid::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::Resize) {
    for (std::size_t k = 0; k < headers_.size(); ++k) {
      if (panes_[k] == watched) headers_[k]->place();
    }
  }
  return QWidget::eventFilter(watched, event);
}

void ViewGrid::set_tool(Tool* tool) {
  tool_ = tool;
  for (Viewport* pane : panes_) pane->set_tool(tool);
}

void ViewGrid::set_time(double time) {
  for (Viewport* pane : panes_) pane->set_time(time);
}

void ViewGrid::hold_frames() {
  for (Viewport* pane : panes_) pane->frames().hold();
}

void ViewGrid::release_frames() {
  for (Viewport* pane : panes_) pane->frames().release();
}

void ViewGrid::show_ground_grid(bool shown) {
  shows_ground_grid_ = shown;
  for (Viewport* pane : panes_) pane->show_ground_grid(shown);
}

void ViewGrid::set_airlight(AirlightMethod method, int slices) {
  for (Viewport* pane : panes_) pane->frames().quality().set_airlight(method, slices);
}

void ViewGrid::set_scattering(Scattering scattering) {
  for (Viewport* pane : panes_) pane->frames().quality().set_scattering(scattering);
}

void ViewGrid::show_overlays(bool shown) {
  shows_overlays_ = shown;
  for (Viewport* pane : panes_) pane->show_overlay(shown);
}

void ViewGrid::set_navigation(NavigationPreset preset) {
  for (Viewport* pane : panes_) pane->camera_controller().set_navigation(preset);
}

void ViewGrid::set_max_error(double max_error) {
  for (Viewport* pane : panes_) pane->frames().quality().set_max_error(max_error);
}

}  // namespace brume
