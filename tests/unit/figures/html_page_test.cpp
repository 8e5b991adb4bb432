// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "figures/html_page.hpp"

#include <gmock/gmock.h>

#include <filesystem>

#include "figures/figure_folder.hpp"
#include "image/image_io.hpp"
#include "polylume/error.hpp"

namespace polylume::figures {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

/// A figure of one small pair and a table, whose texts are full of markup.
Figure hostileFigure(const FigureFolder& folder) {
    PixelImage image{4, 2, 3, 8, std::vector<std::uint8_t>(24, 100)};
    Figure figure;
    figure.name = "floor";
    figure.title = "<script>alert(1)</script>";
    figure.caption = {"a < b & c"};
    Panel panel;
    panel.pairs.push_back({"\"left\"", "right", folder.addPng("a", image, "left \"picture\""),
                           folder.addPng("b", image, "right picture")});
    panel.note = "it's";
    figure.panels.push_back(panel);
    figure.tables.push_back({"<b>", {"<i>", "x"}, {{"</td>", "1"}}});
    return figure;
}

TEST(HtmlPage, escapesWhatIsMarkup) {
    EXPECT_EQ(escapeHtml("<a href=\"x\">'&'</a>"),
              "&lt;a href=&quot;x&quot;&gt;&#39;&amp;&#39;&lt;/a&gt;");
    EXPECT_EQ(escapeHtml("M⁻¹ω"), "M⁻¹ω");
}

TEST(HtmlPage, encodesTheVectorsOfRfc4648) {
    EXPECT_EQ(encodeBase64(""), "");
    EXPECT_EQ(encodeBase64("f"), "Zg==");
    EXPECT_EQ(encodeBase64("fo"), "Zm8=");
    EXPECT_EQ(encodeBase64("foo"), "Zm9v");
    EXPECT_EQ(encodeBase64("foobar"), "Zm9vYmFy");
    EXPECT_EQ(encodeBase64("\xff\xfe"), "//4=");
}

TEST(HtmlPage, isWholeInItselfAndEscaped) {
    const std::filesystem::path directory = "html_page_test";
    const FigureFolder folder(directory, "floor", {});
    const std::string html = makeHtmlPage({"x > y"}, {hostileFigure(folder)});
    EXPECT_THAT(html, HasSubstr("src=\"data:image/png;base64,iVBOR"));
    EXPECT_THAT(html, HasSubstr("type=\"range\""));
    EXPECT_THAT(html, HasSubstr("x &gt; y"));
    EXPECT_THAT(html, HasSubstr("&lt;script&gt;alert(1)"));
    EXPECT_THAT(html, HasSubstr("left &quot;picture&quot;"));
    EXPECT_THAT(html, Not(HasSubstr("<script>alert")));
    EXPECT_THAT(html, Not(HasSubstr("<td></td>")));
    EXPECT_THAT(html, Not(HasSubstr("http:")));
    EXPECT_THAT(html, Not(HasSubstr("https:")));
    std::filesystem::remove_all(directory);
}

TEST(HtmlPage, namesAPictureThatIsGone) {
    Figure figure;
    Panel panel;
    panel.pictures.emplace_back("", Picture{"gone/picture.png", 1, 1, "gone"});
    figure.panels.push_back(panel);
    try {
        makeHtmlPage({}, {figure});
        FAIL() << "expected an Error";
    } catch (const Error& error) {
        EXPECT_THAT(error.what(), HasSubstr("gone/picture.png"));
    }
}

TEST(FigureFolder, refusesAFileInItsPlace) {
    const std::filesystem::path directory = "figure_folder_test";
    createFolder(directory / "a" / "b");
    EXPECT_TRUE(std::filesystem::is_directory(directory / "a" / "b"));
    createFolder(directory / "a" / "b");
    PixelImage image{1, 1, 3, 8, {1, 2, 3}};
    writePng(directory / "file.png", image, {});
    EXPECT_THROW(createFolder(directory / "file.png"), Error);
    EXPECT_THROW(createFolder(directory / "file.png" / "below"), Error);
    std::filesystem::remove_all(directory);
}

}  // namespace
}  // namespace polylume::figures
