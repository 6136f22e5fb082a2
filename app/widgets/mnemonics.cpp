#include "app/widgets/mnemonics.h"

#include <QAbstractButton>
#include <QAction>
#include <QDialog>
#include <QEvent>
#include <QFormLayout>
#include <QGroupBox>
#include <QLabel>
#include <QMenu>
#include <QMenuBar>
#include <QTabBar>
#include <algorithm>
#include <array>
#include <functional>
#include <optional>
#include <vector>

#include "app/widgets/form_rows.h"

namespace brume {
namespace {

struct Entry {
  QString text;
  std::function<void(const QString&)> set_text;
};

// The places of a text that a mark can be before, the best first: where one is, beginnings of
// words, all letters and digits.
class Places {
 public:
  explicit Places(const QString& text) {
    for (qsizetype k = 0; k < text.size() && text[k] != '\t'; ++k) {
      if (text[k] == '&' && k + 1 < text.size()) {
        if (text[k + 1] == '&') {
          plain_ += "&&";
        } else if (marked_ < 0) {
          marked_ = plain_.size();
        }
        if (text[k + 1] == '&') ++k;
        continue;
      }
      plain_ += text[k];
    }
    rest_ = text.mid(text.indexOf('\t') < 0 ? text.size() : text.indexOf('\t'));
    add(marked_);
    for (const bool at_word : {true, false}) {
      for (qsizetype k = 0; k < plain_.size(); ++k) {
        if (!at_word || k == 0 || plain_[k - 1].isSpace()) add(k);
      }
    }
  }

  [[nodiscard]] bool is_marked() const { return marked_ >= 0; }
  [[nodiscard]] const std::vector<qsizetype>& all() const { return all_; }
  [[nodiscard]] int letter(qsizetype place) const { return plain_[place].toLower().unicode(); }
  [[nodiscard]] QString text(std::optional<qsizetype> mark) const {
    QString marked = plain_;
    if (mark) marked.insert(*mark, '&');
    return marked + rest_;
  }

 private:
  void add(qsizetype place) {
    if (place < 0 || place >= plain_.size()) return;
    const QChar letter = plain_[place];
    if (letter.unicode() < 0x80 && letter.isLetterOrNumber()) all_.push_back(place);
  }

  QString plain_;  // without a mark
  QString rest_;   // the keys behind a tab
  qsizetype marked_ = -1;
  std::vector<qsizetype> all_;
};

// A maximum matching of entries and letters, by augmenting paths.
class Matching {
 public:
  explicit Matching(const std::vector<Entry>& entries) : marks_(entries.size()) {
    for (const Entry& entry : entries) places_.emplace_back(entry.text);
    owners_.fill(none);
    for (const bool is_marked : {true, false}) {
      for (std::size_t k = 0; k < places_.size(); ++k) {
        if (places_[k].is_marked() != is_marked) continue;
        asked_.fill(false);
        find_letter(k);
      }
    }
  }

  [[nodiscard]] QString text(std::size_t entry) const { return places_[entry].text(marks_[entry]); }

 private:
  static constexpr std::size_t none = ~std::size_t{0};

  bool find_letter(std::size_t entry) {
    for (const bool is_free : {true, false}) {
      for (const qsizetype place : places_[entry].all()) {
        const auto letter = static_cast<std::size_t>(places_[entry].letter(place));
        if (asked_[letter] || (owners_[letter] == none) != is_free) continue;
        asked_[letter] = true;
        if (!is_free && !find_letter(owners_[letter])) continue;
        owners_[letter] = entry;
        marks_[entry] = place;
        return true;
      }
    }
    return false;
  }

  std::vector<Places> places_;
  std::vector<std::optional<qsizetype>> marks_;
  std::array<std::size_t, 0x80> owners_{};  // of letters
  std::array<bool, 0x80> asked_{};
};

void assign(const std::vector<Entry>& entries) {
  const Matching letters(entries);
  for (std::size_t k = 0; k < entries.size(); ++k) {
    if (const QString text = letters.text(k); text != entries[k].text) entries[k].set_text(text);
  }
}

// The entries of a menu, or a bar of menus.
std::vector<Entry> menu_entries(const QWidget& menu) {
  std::vector<Entry> entries;
  for (QAction* action : menu.actions()) {
    if (action->isSeparator() || !action->isVisible()) continue;
    entries.push_back({action->text(), [action](const QString& text) { action->setText(text); }});
  }
  return entries;
}

// The first widget of a row that takes the keyboard; the label of the row stands for it.
QWidget* first_field(const QWidgetList& row) {
  for (QWidget* field : row.mid(1)) {
    if (field->focusPolicy() != Qt::NoFocus) return field;
    for (QWidget* part : field->findChildren<QWidget*>()) {
      if (part->focusPolicy() != Qt::NoFocus) return part;
    }
  }
  return nullptr;
}

template <class Widget>
void add_texts(const QDialog& dialog, std::vector<Entry>& entries, auto&& is_wanted) {
  for (Widget* widget : dialog.findChildren<Widget*>()) {
    if (widget->window() != &dialog || !is_wanted(*widget)) continue;
    QString text = widget->property("text").toString();
    if (text.isEmpty()) text = widget->property("title").toString();
    entries.push_back({text, [widget](const QString& changed) {
                         widget->setProperty(qobject_cast<QGroupBox*>(widget) ? "title" : "text",
                                             changed);
                       }});
  }
}

std::vector<Entry> dialog_entries(const QDialog& dialog) {
  std::vector<Entry> entries;
  add_texts<QLabel>(dialog, entries, [](QLabel& label) {
    if (!label.buddy()) {
      const QWidgetList row = row_with(&label);
      if (row.size() > 1 && row[0] == &label) label.setBuddy(first_field(row));
    }
    return label.buddy() && !Qt::mightBeRichText(label.text());
  });
  add_texts<QAbstractButton>(dialog, entries, [](QAbstractButton&) { return true; });
  add_texts<QGroupBox>(dialog, entries, [](QGroupBox& box) { return box.isCheckable(); });
  for (QTabBar* tabs : dialog.findChildren<QTabBar*>()) {
    for (int k = 0; k < tabs->count(); ++k) {
      entries.push_back(
          {tabs->tabText(k), [tabs, k](const QString& text) { tabs->setTabText(k, text); }});
    }
  }
  return entries;
}

}  // namespace

QString without_mnemonic(const QString& text) {
  return Places(text).text({}).replace("&&", "&");
}

QString command_title(const QAction& action) {
  const QString title = without_mnemonic(action.iconText()).remove(QChar(0x2026));
  for (const QObject* holder : action.associatedObjects()) {
    if (const auto* menu = qobject_cast<const QMenu*>(holder)) {
      return without_mnemonic(menu->title()) + " › " + title;
    }
  }
  return title;
}

bool Mnemonics::eventFilter(QObject* watched, QEvent* event) {
  // Texts that change ask for another layout.
  if (event->type() == QEvent::Show || event->type() == QEvent::LayoutRequest) {
    if (qobject_cast<QMenu*>(watched) || qobject_cast<QMenuBar*>(watched)) {
      assign(menu_entries(*static_cast<QWidget*>(watched)));
    }
    if (const auto* dialog = qobject_cast<QDialog*>(watched)) assign(dialog_entries(*dialog));
  }
  return QObject::eventFilter(watched, event);
}

}  // namespace brume
