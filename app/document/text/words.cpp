#include "app/document/text/words.h"

#include <QCoreApplication>

#include "core/number_domain.h"

namespace brume {
namespace {

bool keeps_titles = false;

}  // namespace

QString in_sentence(const QString& title) {
  return keeps_titles ? title : title.toLower();
}

void keep_titles_in_sentences(bool keep) {
  keeps_titles = keep;
}

QString lines_of(std::span<const std::string> texts) {
  QStringList lines;
  for (const std::string& text : texts) lines << QString::fromStdString(text);
  return lines.join('\n');
}

QString allowed_text(const NumberDomain& domain) {
  return QCoreApplication::translate("Fields", domain.allowed);
}

}  // namespace brume
