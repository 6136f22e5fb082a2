#include "app/panels/gaussians/filter_bar.h"

#include <QLineEdit>
#include <QPushButton>
#include <QVBoxLayout>

#include "app/widgets/frame_text.h"
#include "app/widgets/plain_text.h"
#include "app/widgets/rows.h"

namespace brume {
namespace {

constexpr QColor wrong(226, 92, 92);

}  // namespace

FilterBar::FilterBar(QWidget* parent)
    : QWidget(parent),
      line_(named(new QLineEdit(this), "gaussian_filter")),
      answer_(new QWidget(this)),
      count_(named(new PlainLabel(answer_), "filter_count")) {
  line_->setPlaceholderText(tr("Filter: radius < 0.5, density > 0.2"));
  line_->setClearButtonEnabled(true);
  count_->setWordWrap(true);
  auto* select = named(new QPushButton(tr("Select Shown"), answer_), "select_shown",
                       tr("Select all rows of the table (Enter)"));
  auto* group = named(new QPushButton(tr("Save as Group"), answer_), "save_as_group",
                      tr("Make a group of all rows of the table, named as they are asked for"));
  buttons_ = {select, group};
  auto* row = row_of({count_, select, group});
  row->setContentsMargins(6, 0, 0, 0);
  answer_->setLayout(row);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(4);
  layout->addWidget(line_);
  layout->addWidget(answer_);
  connect(line_, &QLineEdit::textChanged, this, &FilterBar::parse);
  connect(line_, &QLineEdit::returnPressed, select, &QAbstractButton::click);
  connect(select, &QAbstractButton::clicked, this, &FilterBar::select_asked);
  connect(group, &QAbstractButton::clicked, this, &FilterBar::group_asked);
  parse({});
}

QString FilterBar::text() const {
  return line_->text().simplified();
}

void FilterBar::show_count(std::size_t shown, std::size_t all) {
  shown_ = shown;
  all_ = all;
  show_answer();
}

void FilterBar::parse(const QString& text) {
  problem_.clear();
  const auto parsed = GaussianFilter::parse(text, problem_);
  line_->setToolTip(tr("Filter the table by %1 or group").arg(GaussianFilter::field_names()));
  if (parsed) Q_EMIT asked(*parsed);
  show_answer();
}

void FilterBar::show_answer() {
  const bool is_right = problem_.isEmpty();
  QPalette colors = palette();
  if (!is_right) {
    colors.setColor(QPalette::Text, wrong);
    colors.setColor(QPalette::WindowText, wrong);
  }
  line_->setPalette(colors);
  count_->setPalette(colors);
  count_->setText(is_right ? tr("%1 of %2").arg(count_text(shown_), count_text(all_)) : problem_);
  for (QAbstractButton* button : buttons_) {
    button->setVisible(is_right);
    button->setEnabled(is_right && shown_ > 0 && !text().isEmpty());
  }
  answer_->setVisible(!text().isEmpty());
}

}  // namespace brume
