#include "app/window/pages/start_page.h"

#include <QCheckBox>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QMainWindow>
#include <QMenuBar>
#include <QPainter>
#include <QPushButton>
#include <QScrollArea>
#include <QSettings>
#include <QStatusBar>
#include <QTimer>
#include <QToolButton>
#include <QVBoxLayout>
#include <array>

#include "app/document/document.h"
#include "app/document/paths.h"
#include "app/files/recent_pictures.h"
#include "app/files/scene_files.h"
#include "app/widgets/rows.h"
#include "app/window/pages/tile_grid.h"
#include "core/io/disk/installed_files.h"

namespace brume {
namespace {

constexpr const char* at_start_key = "start_page/at_start";
constexpr qsizetype max_recent_tiles = 8;

struct Offered {
  const char* name;  // of its file
  const char* title;
  const char* hint;
};
constexpr std::array offered_templates = std::to_array<Offered>({
    {"room", QT_TRANSLATE_NOOP("StartPage", "Room"),
     QT_TRANSLATE_NOOP("StartPage", "A room of 6 by 5 m with a window, the sun and a point light")},
    {"landscape", QT_TRANSLATE_NOOP("StartPage", "Landscape"),
     QT_TRANSLATE_NOOP("StartPage", "A valley of 120 m with mist under a morning sun")},
    {"stage", QT_TRANSLATE_NOOP("StartPage", "Stage"),
     QT_TRANSLATE_NOOP("StartPage", "A stage of 12 m with four beams in haze")},
    {"street", QT_TRANSLATE_NOOP("StartPage", "Street"),
     QT_TRANSLATE_NOOP("StartPage", "A street at dusk with spot lights and ground mist")},
});
// The README shows the first six.
constexpr std::array offered_samples = std::to_array<Offered>({
    {"harbour", QT_TRANSLATE_NOOP("StartPage", "Harbour"),
     QT_TRANSLATE_NOOP("StartPage", "Lights with photometric profiles, a neon sign, smoke")},
    {"forest", QT_TRANSLATE_NOOP("StartPage", "Forest"),
     QT_TRANSLATE_NOOP("StartPage", "Sunbeams between leaves")},
    {"headlights", QT_TRANSLATE_NOOP("StartPage", "Headlights"),
     QT_TRANSLATE_NOOP("StartPage", "Spots and an area light on a wet road in mist")},
    {"candle", QT_TRANSLATE_NOOP("StartPage", "Candle"),
     QT_TRANSLATE_NOOP("StartPage", "A flame of Gaussians that shine, and coloured smoke")},
    {"stage", QT_TRANSLATE_NOOP("StartPage", "Swaying beams"),
     QT_TRANSLATE_NOOP("StartPage", "Animated spots; press Space to play")},
    {"sunrise", QT_TRANSLATE_NOOP("StartPage", "Sunrise"),
     QT_TRANSLATE_NOOP("StartPage", "A day's sky, and mist that burns off; press Space to play")},
    {"bunny_fog", QT_TRANSLATE_NOOP("StartPage", "Statue in fog"),
     QT_TRANSLATE_NOOP("StartPage", "Drifting fog in three coloured lights")},
    {"evening_mist", QT_TRANSLATE_NOOP("StartPage", "Evening mist"),
     QT_TRANSLATE_NOOP("StartPage", "Ground mist under an evening sky")},
    {"teapot_steam", QT_TRANSLATE_NOOP("StartPage", "Teapot"),
     QT_TRANSLATE_NOOP("StartPage", "Steam against the light")},
    {"courtyard", QT_TRANSLATE_NOOP("StartPage", "Courtyard"),
     QT_TRANSLATE_NOOP("StartPage", "A building that shadows and lights itself")},
    {"ground_fog", QT_TRANSLATE_NOOP("StartPage", "Hills"),
     QT_TRANSLATE_NOOP("StartPage", "Patchy fog in the valleys of a terrain")},
    {"tunnel", QT_TRANSLATE_NOOP("StartPage", "Tunnel"),
     QT_TRANSLATE_NOOP("StartPage", "Mist, seen from inside towards the mouth")},
});

QPixmap start_picture(const QString& name) {
  return QPixmap(to_qstring(resources_folder() / "start_page") + "/" + name + ".jpg");
}

// The ground grid of a scene that has nothing else.
QPixmap empty_picture() {
  const QSize size = 2 * TileGrid::picture_size;
  QPixmap picture(size);
  picture.fill(QColor(24, 26, 29));
  QPainter painter(&picture);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(QPen(QColor(110, 114, 120), 1.5));
  const double horizon = 0.3 * size.height();
  const QPointF vanishing(0.5 * size.width(), horizon);
  for (int k = -8; k <= 8; ++k) {
    const QPointF near_end(vanishing.x() + 0.16 * k * size.width(), size.height());
    painter.drawLine(vanishing + 0.18 * (near_end - vanishing), near_end);
  }
  for (double depth = 1.0; depth < 6.0; depth += 0.6) {
    const double y = horizon + (size.height() - horizon) / depth;
    painter.drawLine(QPointF(0.0, y), QPointF(size.width(), y));
  }
  return picture;
}

QLabel* page_heading(const QString& text, QWidget* parent) {
  auto* label = new QLabel(QString("<b>%1</b>").arg(text), parent);
  label->setContentsMargins(0, 8, 0, 2);
  return label;
}

}  // namespace

StartPage::StartPage(Document& document, SceneFiles& files, QMainWindow& window, QWidget& bars,
                     QWidget& views)
    : QFrame(&window), files_(files), window_(window), bars_(bars), views_(views) {
  setObjectName("start_page");
  setAccessibleName(tr("Start page"));
  setAutoFillBackground(true);
  setFocusPolicy(Qt::StrongFocus);
  auto* content = new QWidget;
  templates_ = new TileGrid(content);
  recent_ = new TileGrid(content);
  samples_ = new TileGrid(content);
  recent_title_ = page_heading(tr("Recent scenes"), content);
  auto* column = new QVBoxLayout(content);
  column->setContentsMargins(18, 4, 18, 12);
  column->addWidget(page_heading(tr("New scene"), content));
  column->addWidget(templates_);
  column->addWidget(recent_title_);
  column->addWidget(recent_);
  column->addWidget(page_heading(tr("Samples"), content));
  column->addWidget(samples_);
  column->addStretch(1);
  auto* scroll = new QScrollArea(this);
  scroll->setWidget(content);
  scroll->setWidgetResizable(true);
  scroll->setFrameShape(NoFrame);
  scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);

  auto* open_button =
      named(new QPushButton(tr("Open…"), this), "start_open", tr("Open a scene file"));
  connect(open_button, &QPushButton::clicked, &files_, &SceneFiles::open);
  auto* at_start =
      named(new QCheckBox(tr("Show at start"), this), "start_page_at_start",
            tr("Whether this page comes up when no scene is opened; it is always under "
               "File > Start Page"));
  at_start->setChecked(is_wanted());
  connect(at_start, &QCheckBox::toggled, this,
          [](bool on) { QSettings().setValue(at_start_key, on); });
  auto* close_button = named(new QPushButton(tr("Close"), this), "start_close",
                             tr("Go on with the scene behind this page (Esc)"));
  connect(close_button, &QPushButton::clicked, this, &StartPage::close_page);
  auto* row = new QHBoxLayout;
  row->setContentsMargins(18, 6, 18, 10);
  row->setSpacing(12);
  row->addWidget(open_button);
  row->addWidget(at_start);
  row->addStretch(1);
  row->addWidget(close_button);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(0);
  layout->addWidget(scroll, 1);
  layout->addLayout(row);

  hide();
  for (QWidget* widget : {static_cast<QWidget*>(&window), &bars}) widget->installEventFilter(this);
  on_change(document, Change::scene, this, &StartPage::close_page);
  connect(&document.undo_stack(), &QUndoStack::indexChanged, this, &StartPage::close_page);
}

bool StartPage::is_wanted() {
  return QSettings().value(at_start_key, true).toBool();
}

void StartPage::open() {
  if (!is_filled_) {
    fill_templates();
    fill_samples();
    is_filled_ = true;
  }
  fill_recent();
  cover();
  raise();
  show();
  setFocus();
}

// All between the menu and the status line but for the bars.
void StartPage::cover() {
  QRect room = window_.rect();
  room.setTop(window_.menuBar()->geometry().bottom() + 1);
  room.setBottom(window_.statusBar()->geometry().top() - 1);
  setGeometry(room);
  const QRect bars(bars_.mapTo(&window_, QPoint()) - room.topLeft(), bars_.size());
  const bool are_shown = bars_.isVisible() && bars.height() > 0;
  setMask(are_shown ? QRegion(rect()) - QRegion(bars) : QRegion(rect()));
  layout()->setContentsMargins(0, are_shown ? std::max(bars.bottom() + 1, 0) : 0, 0, 0);
}

void StartPage::close_page() {
  if (isHidden()) return;
  const bool had_focus = hasFocus() || isAncestorOf(focusWidget());
  hide();
  if (had_focus) views_.setFocus();
}

void StartPage::fill_templates() {
  const auto add = [this](const Offered& offered) {
    const QString name = QString("template_") + offered.name;
    QToolButton* tile = templates_->add(start_picture(name), tr(offered.title));
    tile->setObjectName(name);
    tile->setToolTip(tr(offered.hint));
    connect(tile, &QToolButton::clicked, this, [this, file = std::string(offered.name)] {
      files_.open_copy(resources_folder() / "templates" / (file + ".brume"));
    });
  };
  QToolButton* empty = templates_->add(empty_picture(), tr("Empty"));
  empty->setObjectName("template_empty");
  empty->setToolTip(tr("One light and the ground grid"));
  connect(empty, &QToolButton::clicked, this, [this] { files_.create(); });
  for (const Offered& offered : offered_templates) add(offered);
}

void StartPage::fill_samples() {
  for (const Offered& offered : offered_samples) {
    QToolButton* tile = samples_->add(start_picture(offered.name), tr(offered.title));
    tile->setObjectName(QString("sample_") + offered.name);
    tile->setToolTip(tr(offered.hint));
    connect(tile, &QToolButton::clicked, this, [this, file = std::string(offered.name)] {
      files_.open_copy(resources_folder() / "scenes" / (file + ".brume"));
    });
  }
}

void StartPage::fill_recent() {
  recent_->clear();
  const QStringList recent = SceneFiles::recent().mid(0, max_recent_tiles);
  for (const QString& name : recent) {
    QToolButton* tile =
        recent_->add(recent_picture(to_path(name)).pixmap(2 * TileGrid::picture_size),
                     QFileInfo(name).completeBaseName());
    tile->setObjectName(QString("recent_%1").arg(recent.indexOf(name)));
    tile->setToolTip(name);
    connect(tile, &QToolButton::clicked, this, [this, name] { files_.open_file(to_path(name)); });
  }
  recent_title_->setVisible(!recent.isEmpty());
  recent_->setVisible(!recent.isEmpty());
}

bool StartPage::eventFilter(QObject* watched, QEvent* event) {
  const bool has_changed = event->type() == QEvent::Resize || event->type() == QEvent::Show ||
                           event->type() == QEvent::Hide || event->type() == QEvent::Move;
  // The window lays itself out first.
  if (has_changed && isVisible()) QTimer::singleShot(0, this, &StartPage::cover);
  return QFrame::eventFilter(watched, event);
}

void StartPage::showEvent(QShowEvent* event) {
  QFrame::showEvent(event);
  cover();
  Q_EMIT covers(true);
}

void StartPage::hideEvent(QHideEvent* event) {
  QFrame::hideEvent(event);
  Q_EMIT covers(false);
}

void StartPage::keyPressEvent(QKeyEvent* event) {
  if (event->key() == Qt::Key_Escape) {
    close_page();
  } else {
    QFrame::keyPressEvent(event);
  }
}

}  // namespace brume
