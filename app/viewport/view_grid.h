#pragma once

#include <QWidget>
#include <span>
#include <vector>

#include "app/viewport/view_header.h"
#include "app/viewport/view_services.h"
#include "app/viewport/viewport.h"

class QGridLayout;

namespace brume {

// One view, or four: perspective, top, front and side. All share the render service and tool;
// shortcuts, panels and error measurement follow the active (last used) view. Axis views are
// created on first use.
class ViewGrid : public QWidget {
  Q_OBJECT
 public:
  explicit ViewGrid(Document& document, QWidget* parent = nullptr);
  ~ViewGrid() override;

  [[nodiscard]] Viewport& perspective() const { return *panes_.front(); }
  [[nodiscard]] Viewport& active() const { return *active_; }
  // The view under the mouse, or else the active one.
  [[nodiscard]] Viewport& pointed() const;
  [[nodiscard]] std::span<Viewport* const> panes() const { return panes_; }

  [[nodiscard]] bool shows_four() const { return shows_four_; }
  void show_four(bool four);  // four, or only the active one

  // The menus of the headers of all views.
  void set_header_menus(const ViewHeader::Menus& menus);

  // Settings of all views.
  void set_tool(Tool* tool);
  void set_time(double time);
  // Changes between the two are due to the time; see FrameScheduler.
  void hold_frames();
  void release_frames();
  void set_airlight(AirlightMethod method, int slices = Settings().slices);
  void set_scattering(Scattering scattering);
  void set_max_error(double max_error);
  // Handles, outlines and brushes over the picture.
  void show_overlays(bool shown);
  [[nodiscard]] bool shows_overlays() const { return shows_overlays_; }
  void show_ground_grid(bool shown);
  [[nodiscard]] bool shows_ground_grid() const { return shows_ground_grid_; }
  void set_navigation(NavigationPreset preset);
  void set_backend(Backend backend) { services_.frames.service.set_backend(backend); }
  [[nodiscard]] Backend backend() const { return services_.frames.service.backend(); }

  [[nodiscard]] const PictureCache& picture_cache() const { return services_.frames.cache; }
  [[nodiscard]] ColorManagement& color() { return services_.frames.color; }
  [[nodiscard]] TransferJob& transfer_job() { return services_.frames.transfer_job; }

 Q_SIGNALS:
  void pane_made(brume::Viewport* pane);
  void pointed_at(brume::View& view, QPointF position);
  void menu_asked(brume::Viewport& view, QPointF position);
  // Signals of the active view; also emitted when it changes.
  void active_changed();
  void frame_shown();
  void error_changed();
  void mode_changed();
  void backend_changed();  // of all views
  void failed(const QString& message);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void make_pane(Projection projection);
  void activate(Viewport& pane);
  void arrange();
  void update_headers();

  Document& document_;
  ViewServices services_;
  QGridLayout* layout_;
  std::vector<Viewport*> panes_;
  std::vector<ViewHeader*> headers_;  // one per pane
  ViewHeader::Menus menus_{};
  Viewport* active_ = nullptr;
  Tool* tool_ = nullptr;
  bool shows_four_ = false;
  bool shows_overlays_ = true;
  bool shows_ground_grid_ = false;
};

}  // namespace brume
