#pragma once

#include <QString>
#include <span>
#include <string>

namespace brume {

struct NumberDomain;

// A title inside a sentence: "position" of "Position". Languages that write nouns large keep it.
QString in_sentence(const QString& title);
void keep_titles_in_sentences(bool keep);

// Texts of the core, a line each.
QString lines_of(std::span<const std::string> texts);

// "a number > 0"
QString allowed_text(const NumberDomain& domain);

}  // namespace brume
