// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "figures/html_page.hpp"

#include <fmt/format.h>

#include <cstdint>
#include <span>

#include "core/embedded_file.hpp"
#include "core/file.hpp"
#include "polylume/error.hpp"

namespace polylume {
/// The files of page/ (cmake/EmbedFiles.cmake).
std::span<const EmbeddedFile> figurePageFiles();
}  // namespace polylume

namespace polylume::figures {
namespace {

std::string_view embeddedText(std::string_view name) {
    for (const EmbeddedFile& file : figurePageFiles()) {
        if (file.path == name) {
            return {reinterpret_cast<const char*>(file.bytes.data()), file.bytes.size()};
        }
    }
    throw Error(fmt::format("the page's {} was not compiled in", name));
}

std::string paragraphs(const std::vector<std::string>& texts) {
    std::string html;
    for (const std::string& text : texts) html += fmt::format("<p>{}</p>\n", escapeHtml(text));
    return html;
}

std::string imageTag(const Picture& picture, std::string_view cssClass) {
    const std::vector<std::byte> bytes = readFile(picture.file);
    const std::string_view content(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    return fmt::format(
        "<img class=\"{}\" width=\"{}\" height=\"{}\" alt=\"{}\" "
        "src=\"data:image/png;base64,{}\">",
        cssClass, picture.width, picture.height, escapeHtml(picture.text), encodeBase64(content));
}

/// The left picture lies over the right one and is cut at the slider (page.js).
std::string pairHtml(const PicturePair& pair) {
    const std::string left = escapeHtml(pair.leftLabel);
    const std::string right = escapeHtml(pair.rightLabel);
    return fmt::format(
        "<div class=\"pair\">\n{}\n{}\n"
        "<span class=\"label left\" aria-hidden=\"true\">{}</span>"
        "<span class=\"label right\" aria-hidden=\"true\">{}</span>"
        "<span class=\"divider\" aria-hidden=\"true\"></span>\n"
        "<input type=\"range\" min=\"0\" max=\"100\" step=\"1\" value=\"50\" "
        "aria-label=\"Share of {} (left) over {} (right), percent\">\n</div>\n",
        imageTag(pair.right, "under"), imageTag(pair.left, "over"), left, right, left, right);
}

std::string panelHtml(const Panel& panel) {
    std::string html = "<div class=\"panel\">\n";
    if (!panel.title.empty()) html += fmt::format("<h3>{}</h3>\n", escapeHtml(panel.title));
    for (const PicturePair& pair : panel.pairs) html += pairHtml(pair);
    if (!panel.pictures.empty()) html += "<div class=\"pictures\">\n";
    for (const auto& [heading, picture] : panel.pictures) {
        html += fmt::format("<figure>{}", imageTag(picture, "single"));
        if (!heading.empty()) {
            html += fmt::format("<figcaption>{}</figcaption>", escapeHtml(heading));
        }
        html += "</figure>\n";
    }
    if (!panel.pictures.empty()) html += "</div>\n";
    if (!panel.note.empty()) {
        html += fmt::format("<p class=\"note\">{}</p>\n", escapeHtml(panel.note));
    }
    return html + "</div>\n";
}

std::string tableHtml(const DataTable& table) {
    std::string html = fmt::format(
        "<div class=\"table\" tabindex=\"0\" role=\"region\" aria-label=\"{0}\">\n"
        "<table>\n<caption>{0}</caption>\n<thead><tr>",
        escapeHtml(table.title));
    for (const std::string& cell : table.head) {
        html += fmt::format("<th scope=\"col\">{}</th>", escapeHtml(cell));
    }
    html += "</tr></thead>\n<tbody>\n";
    for (const std::vector<std::string>& row : table.rows) {
        html += "<tr>";
        for (std::size_t i = 0; i < row.size(); ++i) {
            html += i == 0 ? fmt::format("<th scope=\"row\">{}</th>", escapeHtml(row[i]))
                           : fmt::format("<td>{}</td>", escapeHtml(row[i]));
        }
        html += "</tr>\n";
    }
    return html + "</tbody>\n</table>\n</div>\n";
}

std::string figureHtml(const Figure& figure, std::size_t number) {
    std::string html =
        fmt::format("<section id=\"{}\">\n<h2>{}. {}</h2>\n{}", escapeHtml(figure.name), number,
                    escapeHtml(figure.title), paragraphs(figure.caption));
    html += fmt::format("<div class=\"panels columns{}\">\n", figure.columns);
    for (const Panel& panel : figure.panels) html += panelHtml(panel);
    html += "</div>\n";
    for (const DataTable& table : figure.tables) html += tableHtml(table);
    return html + "</section>\n";
}

std::string contentsHtml(const std::vector<Figure>& figures) {
    std::string html = "<nav aria-label=\"Figures\"><ol>\n";
    for (const Figure& figure : figures) {
        html += fmt::format("<li><a href=\"#{}\">{}</a></li>\n", escapeHtml(figure.name),
                            escapeHtml(figure.title));
    }
    return html + "</ol></nav>\n";
}

}  // namespace

std::string escapeHtml(std::string_view text) {
    std::string html;
    for (const char c : text) {
        switch (c) {
            case '&':
                html += "&amp;";
                break;
            case '<':
                html += "&lt;";
                break;
            case '>':
                html += "&gt;";
                break;
            case '"':
                html += "&quot;";
                break;
            case '\'':
                html += "&#39;";
                break;
            default:
                html += c;
        }
    }
    return html;
}

std::string encodeBase64(std::string_view bytes) {
    constexpr std::string_view kDigits =
        "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    text.reserve((bytes.size() + 2) / 3 * 4);
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        std::uint32_t bits = 0;
        for (std::size_t j = 0; j < 3; ++j) {
            bits =
                bits << 8 | (i + j < bytes.size() ? static_cast<unsigned char>(bytes[i + j]) : 0);
        }
        for (std::size_t j = 0; j < 4; ++j) {
            const bool isPadding = i + j > bytes.size();
            text += isPadding ? '=' : kDigits[bits >> (18 - 6 * j) & 63];
        }
    }
    return text;
}

std::string makeHtmlPage(const std::vector<std::string>& introduction,
                         const std::vector<Figure>& figures) {
    std::string html = fmt::format(
        "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
        "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
        "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; img-src data:; "
        "style-src 'unsafe-inline'; script-src 'unsafe-inline'\">\n"
        "<link rel=\"icon\" href=\"data:,\">\n<title>Polylume: figures</title>\n"
        "<style>\n{}</style>\n</head>\n<body>\n<main>\n<h1>Polylume: figures</h1>\n",
        embeddedText("page.css"));
    html += paragraphs(introduction);
    if (figures.size() > 1) html += contentsHtml(figures);
    for (std::size_t i = 0; i < figures.size(); ++i) html += figureHtml(figures[i], i + 1);
    return html + fmt::format("</main>\n<script>\n{}</script>\n</body>\n</html>\n",
                              embeddedText("page.js"));
}

}  // namespace polylume::figures
