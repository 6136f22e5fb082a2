#include "app/window/dialogs/preferences.h"

#include <tbb/global_control.h>

#include <QActionGroup>
#include <QComboBox>
#include <QFormLayout>
#include <QSettings>
#include <QSpinBox>
#include <QTabWidget>
#include <QVBoxLayout>
#include <optional>
#include <thread>

#include "app/document/autosave.h"
#include "app/window/dialogs/display_preferences.h"
#include "app/window/dialogs/key_preferences.h"

namespace brume {
namespace {

constexpr const char* threads_key = "render/threads";

}  // namespace

void apply_chosen_threads() {
  static std::optional<tbb::global_control> limit;  // the last one made counts
  limit.reset();
  const int threads = QSettings().value(threads_key).toInt();
  if (threads > 0) {
    limit.emplace(tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(threads));
  }
}

Preferences::Preferences(Autosave& autosave, QWidget* window) : QDialog(window) {
  setObjectName("preferences");
  setWindowTitle(tr("Preferences"));
  setAttribute(Qt::WA_DeleteOnClose);
  auto* general = new QWidget(this);
  form_ = new QFormLayout(general);
  add_autosave(autosave);
  add_threads();
  auto* tabs = new QTabWidget(this);
  tabs->addTab(general, tr("General"));
  tabs->addTab(new DisplayPreferences, tr("Display"));
  tabs->addTab(new KeyPreferences(*window), tr("Keys"));
  auto* layout = new QVBoxLayout(this);
  layout->addWidget(tabs);
  resize(520, 460);
}

void Preferences::add_choice(const QString& title, const QString& name, QActionGroup& group) {
  auto* box = new QComboBox(this);
  box->setObjectName(name);
  const QList<QAction*> actions = group.actions();
  for (int k = 0; k < actions.size(); ++k) {
    const QAction* action = actions.at(k);
    box->addItem(action->text().remove('&'));
    box->setItemData(k, action->toolTip(), Qt::ToolTipRole);
    if (action->isChecked()) box->setCurrentIndex(k);
    // Checked in the menu, or by what the view shows.
    connect(action, &QAction::changed, box, [box, action, k] {
      box->setItemText(k, action->text().remove('&'));
      if (action->isChecked()) box->setCurrentIndex(k);
    });
  }
  connect(box, &QComboBox::activated, &group, [actions](int k) { actions.at(k)->trigger(); });
  form_->insertRow(form_->rowCount() - 2, title, box);
}

void Preferences::add_autosave(Autosave& autosave) {
  auto* seconds = new QSpinBox(this);
  seconds->setObjectName("autosave_seconds");
  seconds->setRange(5, 3600);
  seconds->setSuffix(tr(" s"));
  seconds->setValue(autosave.interval());
  seconds->setToolTip(tr("How often a copy of unsaved work is kept, from 5 seconds to an hour"));
  connect(seconds, &QSpinBox::valueChanged, &autosave, &Autosave::set_interval);
  form_->addRow(tr("Keep unsaved work every"), seconds);
}

void Preferences::add_threads() {
  auto* threads = new QSpinBox(this);
  threads->setObjectName("threads");
  threads->setRange(0, static_cast<int>(std::max(1U, std::thread::hardware_concurrency())));
  threads->setSpecialValueText(tr("all cores"));
  threads->setValue(QSettings().value(threads_key).toInt());
  threads->setToolTip(tr("How many processor threads render at most, to leave some to others"));
  connect(threads, &QSpinBox::valueChanged, this, [](int count) {
    QSettings().setValue(threads_key, count);
    apply_chosen_threads();
  });
  form_->addRow(tr("Threads"), threads);
}

}  // namespace brume
