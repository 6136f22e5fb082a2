#include <QHBoxLayout>
#include <QLineEdit>
#include <QMenu>
#include <QPushButton>
#include <QToolButton>
#include <QWidgetAction>

#include "app/tools/brushes/brush_library.h"
#include "app/tools/brushes/fog_brush_tool.h"
#include "app/tools/brushes/stroke_options_button.h"
#include "app/widgets/rows.h"
#include "brume/error.h"

namespace brume {
namespace {

// The menu of the presets of a tool, made anew each time it opens.
class PresetMenu : public QMenu {
 public:
  PresetMenu(FogBrushTool& tool, const QString& prefix, QWidget* parent)
      : QMenu(parent), tool_(tool), prefix_(prefix) {
    setObjectName(prefix + "_presets");
    connect(this, &QMenu::aboutToShow, this, &PresetMenu::fill);
  }

 private:
  void add_presets(std::span<const BrushPreset> presets) {
    const bool sprays = tool_.preset().sprays;
    for (const BrushPreset& preset : presets) {
      if (preset.sprays != sprays) continue;
      QAction* action = addAction(QString(preset.name).replace('&', "&&"));
      connect(action, &QAction::triggered, &tool_, [this, preset] { tool_.apply_preset(preset); });
    }
  }

  void fill() {
    clear();
    add_presets(brush_presets());
    addSeparator();
    std::vector<BrushPreset> own;
    try {
      own = library_.read();
      reported_.clear();
    } catch (const InputError& error) {
      const QString problem = QString::fromUtf8(error.what());
      QAction* action = addAction(Tool::tr("Your brushes cannot be read"));
      action->setObjectName("broken_library");
      action->setEnabled(false);
      action->setToolTip(problem);
      report(problem);
      return;
    }
    add_presets(own);
    addSeparator();
    add_saving();
    std::erase_if(
        own, [this](const BrushPreset& preset) { return preset.sprays != tool_.preset().sprays; });
    if (own.empty()) return;
    QMenu* deleting = addMenu(Tool::tr("Delete"));
    for (const BrushPreset& preset : own) {
      QAction* action = deleting->addAction(QString(preset.name).replace('&', "&&"));
      action->setObjectName("delete_" + preset.name);
      connect(action, &QAction::triggered, &tool_,
              [this, preset] { attempt([&] { library_.remove(preset); }); });
    }
  }

  void add_saving() {
    auto* panel = new QWidget(this);
    auto* name = named(new QLineEdit(panel), prefix_ + "_preset_name");
    name->setPlaceholderText(Tool::tr("Name of this brush"));
    name->setMaxLength(100);
    auto* save = named(new QPushButton(Tool::tr("Save"), panel), prefix_ + "_preset_save",
                       Tool::tr("Keeps this brush among your own; its size follows the view"));
    save->setEnabled(false);
    auto* row = new QHBoxLayout(panel);
    row->setContentsMargins(8, 4, 8, 4);
    row->addWidget(name, 1);
    row->addWidget(save);
    connect(name, &QLineEdit::textChanged, save,
            [save](const QString& text) { save->setEnabled(!text.trimmed().isEmpty()); });
    const auto save_it = [this, name] {
      BrushPreset preset = tool_.preset();
      preset.name = name->text().trimmed();
      if (preset.name.isEmpty()) return;
      attempt([&] { library_.add(preset); });
      close();
    };
    connect(save, &QPushButton::clicked, this, save_it);
    connect(name, &QLineEdit::returnPressed, this, save_it);
    auto* action = new QWidgetAction(this);
    action->setDefaultWidget(panel);
    addAction(action);
  }

  template <typename Work>
  void attempt(const Work& work) {
    try {
      work();
    } catch (const InputError& error) {
      reported_.clear();
      report(QString::fromUtf8(error.what()));
    }
  }

  // Once for each problem.
  void report(const QString& problem) {
    if (problem == reported_) return;
    reported_ = problem;
    Q_EMIT tool_.refused(problem);
  }

  FogBrushTool& tool_;
  QString prefix_;
  BrushLibrary library_{BrushLibrary::default_file()};
  QString reported_;
};

}  // namespace

void add_preset_button(QHBoxLayout& row, FogBrushTool& tool, const QString& prefix) {
  auto* button = named(new QToolButton, prefix + "_preset");
  button->setText(Tool::tr("Preset"));
  button->setToolTip(Tool::tr("Ready-made brushes and your own; sizes follow the view"));
  button->setPopupMode(QToolButton::InstantPopup);
  button->setMenu(new PresetMenu(tool, prefix, button));
  row.addWidget(button);
}

}  // namespace brume
