#pragma once

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <string>

#include "core/file.h"
#include "core/test_folder.h"

// Tests of this folder open pages in a browser by what follows.
namespace plumb::reports {

/// The outcome of a visit to a page: its document afterwards, and what the browser said.
struct Browsed {
    std::string dom, messages;
    /// The value of the attribute data-WHAT of <body>.
    [[nodiscard]] std::string saw(const std::string& what) const {
        const std::size_t body = dom.find("<body"), end = dom.find('>', body);
        const std::string mark = " data-" + what + "=\"";
        const std::size_t at = dom.find(mark, body);
        if (at > end) return "";
        const std::size_t from = at + mark.size();
        return dom.substr(from, dom.find('"', from) - from);
    }
};

/// The page around the page under test, which stands in a frame (a window is never narrower than 500 pixels). It writes
/// down what page/test/ reports from there; until then the second frame, opened and not closed, keeps
/// the browser from finishing.
inline constexpr const char* frame_page = R"(<body>
<iframe id="wait" hidden></iframe>
<script>
const wait = document.getElementById("wait").contentDocument;
wait.open();
onmessage = (event) => {{
  Object.assign(document.body.dataset, event.data);
  wait.close();
}};
</script>
<iframe src="page.html" style="width: {}px; height: 900px; border: 0"></iframe>
)";

/// Opens the page in a headless Chromium at this width, with everything tried by a script of page/test/.
inline Browsed browse(const std::string& page, const std::string& tries, int width, const std::string& options = "") {
    const TestFolder folder;
    const std::string script =
        read_file(PLUMB_PAGE_FOLDER "/test/tools.js") + read_file(PLUMB_PAGE_FOLDER "/test/" + tries);
    write_file(folder / "page.html", page + "<script>" + script + "</script>");
    write_file(folder / "frame.html", fmt::format(frame_page, width));
    const std::string command = fmt::format(
        "cd '{}' && timeout 120 '{}' --headless --hide-scrollbars --no-sandbox --disable-gpu --disable-quic "
        "--no-first-run "
        "--disable-background-networking --disable-component-update --disable-sync --user-data-dir=profile "
        "--enable-logging=stderr --window-size=1400,1000 {} --dump-dom "
        "\"file://$PWD/frame.html\" "
        ">dom 2>messages",
        folder.path().string(), PLUMB_CHROMIUM, options);
    EXPECT_EQ(std::system(command.c_str()), 0);
    return {read_file(folder / "dom"), read_file(folder / "messages")};
}

class PageInBrowser : public testing::Test {
protected:
    void SetUp() override {
        if (!std::filesystem::exists(PLUMB_CHROMIUM)) GTEST_SKIP() << "chromium is not installed";
    }
};

}  // namespace plumb::reports
