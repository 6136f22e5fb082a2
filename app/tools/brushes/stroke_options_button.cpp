#include "app/tools/brushes/stroke_options_button.h"

#include <QCheckBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QMenu>
#include <QToolButton>
#include <QVBoxLayout>
#include <QWidgetAction>

#include "app/tools/brushes/fog_brush_tool.h"
#include "app/widgets/number_field.h"
#include "app/widgets/rows.h"
#include "core/number_domain.h"

namespace brume {
namespace {

void add_mirrors(QHBoxLayout& row, FogBrushTool& tool, const QString& prefix) {
  auto* title = new QLabel(Tool::tr("Mirror"));
  title->setToolTip(Tool::tr("Repeats the stroke on the other side of planes across these axes"));
  row.addWidget(title);
  for (std::size_t k = 0; k < 3; ++k) {
    auto* box = named(new QCheckBox(QString("XYZ").mid(static_cast<qsizetype>(k), 1)),
                      QString("%1_mirror_%2").arg(prefix).arg(QString("xyz")[static_cast<int>(k)]),
                      title->toolTip());
    row.addWidget(box);
    QObject::connect(box, &QCheckBox::clicked, &tool, [&tool, k](bool on) {
      StrokeOptions options = tool.stroke_options();
      options.mirrors[k] = on;
      tool.set_stroke_options(options);
    });
    QObject::connect(&tool, &Tool::options_changed, box,
                     [&tool, box, k] { box->setChecked(tool.stroke_options().mirrors[k]); });
  }
  add_choice(
      row, tool, {Tool::tr("at"), prefix + "_mirror_at"},
      {Tool::tr("Origin"), Tool::tr("View target")},
      [&tool] { return tool.stroke_options().mirrors_at_pivot ? 1 : 0; },
      [&tool](int index) {
        StrokeOptions options = tool.stroke_options();
        options.mirrors_at_pivot = index == 1;
        tool.set_stroke_options(options);
      });
}

void add_snap(QHBoxLayout& row, FogBrushTool& tool, const QString& prefix) {
  const auto change = [&tool](auto how) {
    PaintTarget target = tool.paint_target();
    how(target);
    tool.set_target(target);
  };
  add_choice(
      row, tool, {Tool::tr("Snap to"), prefix + "_snap"}, {Tool::tr("Nothing"), Tool::tr("Grid")},
      [&tool] { return tool.paint_target().snaps_to_grid ? 1 : 0; },
      [change](int index) { change([&](PaintTarget& t) { t.snaps_to_grid = index == 1; }); });
  ValueField* grid = add_number(
      row, tool,
      {Tool::tr("Grid"), prefix + "_grid", domain::length, ValueField::Scale::logarithmic, 0.01},
      [&tool] { return tool.paint_target().grid; },
      [change](double value) { change([&](PaintTarget& t) { t.grid = value; }); });
  grid->number().show_length_unit();
  grid->setToolTip(Tool::tr("Distance between the points of the grid in scene units"));
  const auto show = [grid, &tool] { grid->setEnabled(tool.paint_target().snaps_to_grid); };
  QObject::connect(&tool, &Tool::options_changed, grid, show);
  show();
}

}  // namespace

void add_stroke_options_button(QHBoxLayout& row, FogBrushTool& tool, const QString& prefix,
                               const std::vector<StrokeNumber>& numbers) {
  auto* button = named(new QToolButton, prefix + "_stroke");
  button->setText(Tool::tr("Stroke"));
  button->setToolTip(Tool::tr("Soft edge, smoothing, mirrors, snapping and the pen"));
  button->setPopupMode(QToolButton::InstantPopup);
  button->setMenu(new QMenu(button));
  auto* panel = new QWidget(button);
  // It is coloured as panels are: on a menu's ground an empty box would not be seen.
  panel->setBackgroundRole(QPalette::Window);
  panel->setAutoFillBackground(true);
  auto* column = new QVBoxLayout(panel);
  column->setContentsMargins(8, 8, 8, 8);
  const auto new_row = [column] {
    auto* made = new QHBoxLayout;
    column->addLayout(made);
    return made;
  };
  for (std::size_t k = 0; k < numbers.size(); k += 2) {
    QHBoxLayout* pair = new_row();
    for (std::size_t i = k; i < std::min(k + 2, numbers.size()); ++i) {
      const StrokeNumber& number = numbers[i];
      ValueField* field = add_number(*pair, tool, number.option, number.get, number.set);
      field->setMaximumWidth(QWIDGETSIZE_MAX);
      field->setToolTip(number.tip);
    }
  }
  QHBoxLayout* mirrors = new_row();
  add_mirrors(*mirrors, tool, prefix);
  mirrors->addStretch(1);
  QHBoxLayout* snap = new_row();
  add_snap(*snap, tool, prefix);
  QHBoxLayout* pen = new_row();
  add_choice(
      *pen, tool, {Tool::tr("Pen pressure changes"), prefix + "_pen"},
      {Tool::tr("Nothing"), Tool::tr("Radius"), Tool::tr("Density"), Tool::tr("Both")},
      [&tool] { return static_cast<int>(tool.stroke_options().pen); },
      [&tool](int index) {
        StrokeOptions options = tool.stroke_options();
        options.pen = static_cast<PenUse>(index);
        tool.set_stroke_options(options);
      });
  pen->addStretch(1);
  auto* action = new QWidgetAction(button);
  action->setDefaultWidget(panel);
  button->menu()->addAction(action);
  row.addWidget(button);
}

}  // namespace brume
