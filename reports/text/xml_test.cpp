#include "reports/text/xml.h"

#include <gtest/gtest.h>

namespace plumb::reports {
namespace {

TEST(Escaped, IsSafeInContentAndInBothQuotes) {
    EXPECT_EQ(escaped("a < b && c > \"d\" 'e'"), "a &lt; b &amp;&amp; c &gt; &quot;d&quot; &apos;e&apos;");
    EXPECT_EQ(escaped("two\nlines\tand a tab"), "two&#10;lines&#9;and a tab");
    EXPECT_EQ(escaped("δ ≤ 1e-4 𝄞"), "δ ≤ 1e-4 𝄞");
}

TEST(Escaped, ReplacesWhatXmlCannotHold) {
    EXPECT_EQ(escaped(std::string_view("a\0b\x1B", 4)), "a\uFFFDb\uFFFD");
    EXPECT_EQ(escaped("\xC3("), "\uFFFD(");                    // half a character
    EXPECT_EQ(escaped("\xC0\xAF"), "\uFFFD\uFFFD");            // a longer form of '/'
    EXPECT_EQ(escaped("\xED\xA0\x80"), "\uFFFD\uFFFD\uFFFD");  // a surrogate
}

}  // namespace
}  // namespace plumb::reports
