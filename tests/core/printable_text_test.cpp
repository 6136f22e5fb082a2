#include "core/printable_text.h"

#include <gtest/gtest.h>

#include <array>

#include "brume/error.h"

namespace brume {
namespace {

TEST(PrintableText, PreservesPrintableText) {
  for (const char* text : {"", "plain", "sc\xc3\xa8ne", "\xe9\x9b\xbe", "\xf0\x9f\x8c\xab",
                           "C:\\folder \"a\" 'b'", "\xd7\xa9\xd7\x9c\xd7\x95\xd7\x9d"}) {
    EXPECT_EQ(printable(text), text);
  }
}

TEST(PrintableText, EscapesWhatDrivesATerminal) {
  EXPECT_EQ(printable("\x1b[31mred"), "\\u001b[31mred");
  EXPECT_EQ(printable("a\rb\nc\td\x7f"), "a\\u000db\\u000ac\\u0009d\\u007f");
  EXPECT_EQ(printable("\xc2\x9b"), "\\u009b") << "the control sequence introducer of C1";
  EXPECT_EQ(printable("\x9b"), "\\x9b") << "the same as a bare byte";
  EXPECT_EQ(printable(std::string_view("a\0b", 3)), "a\\u0000b");
}

TEST(PrintableText, EscapesWhatTurnsTheDirection) {
  EXPECT_EQ(printable("gpj.\xe2\x80\xaetxt"), "gpj.\\u202etxt");
  EXPECT_EQ(printable("\xe2\x81\xa6\xe2\x81\xa9"), "\\u2066\\u2069");
  EXPECT_EQ(printable("\xe2\x80\x8f\xd8\x9c"), "\\u200f\\u061c");
  EXPECT_EQ(printable("\xe2\x80\xa8\xe2\x80\xa9"), "\\u2028\\u2029");
}

TEST(PrintableText, EscapesBytesThatAreNotUtf8) {
  EXPECT_EQ(printable("caf\xe9"), "caf\\xe9");
  EXPECT_EQ(printable("\xc0\x80"), "\\xc0\\x80") << "overlong";
  EXPECT_EQ(printable("\xed\xa0\x80"), "\\xed\\xa0\\x80") << "a surrogate";
  EXPECT_EQ(printable("\xe2\x80"), "\\xe2\\x80") << "cut off";
  EXPECT_EQ(printable("\xf4\x90\x80\x80"), "\\xf4\\x90\\x80\\x80") << "beyond Unicode";
}

TEST(PrintableText, MayBeAppliedAgain) {
  for (int byte = 0; byte < 256; ++byte) {
    const std::array<char, 3> text{'a', static_cast<char>(byte), 'b'};
    const std::string once = printable(std::string_view(text.data(), text.size()));
    EXPECT_EQ(printable(once), once) << byte;
  }
}

TEST(PrintableText, LinesStay) {
  EXPECT_EQ(printable_lines("a\nb\x1b\n"), "a\nb\\u001b\n");
}

TEST(InputError, IsOnePrintableLine) {
  EXPECT_STREQ(InputError("a\x1b.ply", "line\n1", "found \xc2\x85").what(),
               "a\\u001b.ply: line\\u000a1: found \\u0085");
}

}  // namespace
}  // namespace brume
