#pragma once

#include <QString>

namespace brume {

// Numbers as the editor shows them; nothing else formats any (tests/check_number_texts.sh).

// To `digits` significant digits, without zeros at the end: "0.918", "1234567", "1.2e-5". What is
// nearer to 0 than any length can be is "0".
QString number_text(double value, int digits = 6);
// The shortest text that gives the same value again.
QString exact_number_text(double value);
// With so many decimals, never "-0.0".
QString fixed_text(double value, int decimals);
// "8.2 ms", "140 ms", "1.2 s".
QString duration_text(double milliseconds);
// A time that is estimated, at least a second: "8 s", "3 min 4 s", "2 h 10 min".
QString estimated_time_text(double seconds);
// A share in per cent, to about two digits: "1.4 %", "0.7 %", "< 0.01 %", "0 %".
QString percent_text(double share);

}  // namespace brume
