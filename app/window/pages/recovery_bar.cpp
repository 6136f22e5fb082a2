#include "app/window/pages/recovery_bar.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QLocale>
#include <QPushButton>

#include "app/document/paths.h"
#include "app/widgets/plain_text.h"
#include "app/widgets/rows.h"

namespace brume {

RecoveryBar::RecoveryBar(QWidget* parent) : QFrame(parent), label_(new PlainLabel(this)) {
  setObjectName("recovery_bar");
  setStyleSheet("#recovery_bar { background: #33455c; } #recovery_bar QLabel { color: #f4f4f4; }");
  label_->setWordWrap(true);
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(10, 4, 4, 4);
  layout->addWidget(label_, 1);
  const auto button = [&](const QString& text, const char* name, auto react) {
    auto* made = named(new QPushButton(text, this), name);
    layout->addWidget(made);
    connect(made, &QPushButton::clicked, this, react);
  };
  button(tr("Restore"), "restore", [this] {
    const RecoveryFile work = work_.front();
    hide();  // the rest is offered at the next start
    Q_EMIT restore(work);
  });
  button(tr("Later"), "later", [this] { drop_first(); });
  button(tr("Discard"), "discard", [this] {
    Autosave::forget(work_.front());
    drop_first();
  });
  hide();
}

void RecoveryBar::offer(std::vector<RecoveryFile> work) {
  work_ = std::move(work);
  show_next();
}

void RecoveryBar::show_next() {
  setVisible(!work_.empty());
  if (work_.empty()) return;
  const RecoveryFile& work = work_.front();
  Autosave::mark_offered(work);
  const QString name =
      work.file.empty() ? tr("a new scene") : QString("“%1”").arg(to_qstring(work.file.filename()));
  label_->setText(tr("Unsaved changes to %1 from %2 can be restored.")
                      .arg(name, QLocale().toString(work.when, QLocale::ShortFormat)));
}

void RecoveryBar::drop_first() {
  work_.erase(work_.begin());
  show_next();
}

}  // namespace brume
