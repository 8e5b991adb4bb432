// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

// What a page of figures is made of. All texts are plain UTF-8, not HTML.
namespace polylume::figures {

/// A PNG that lies in the figures' folder.
struct Picture {
    std::filesystem::path file;
    int width = 0;
    int height = 0;
    std::string text;  ///< What is to be seen, for those who can't see it.
};

/// Two pictures of one size on one place, with a slider between them.
struct PicturePair {
    std::string leftLabel;
    std::string rightLabel;
    Picture left;
    Picture right;
};

/// A part of a figure: pairs, then single pictures, each under its own heading, then a note.
struct Panel {
    std::string title;
    std::vector<PicturePair> pairs;
    std::vector<std::pair<std::string, Picture>> pictures;  ///< Heading, may be empty; picture.
    std::string note;
};

struct DataTable {
    std::string title;
    std::vector<std::string> head;
    std::vector<std::vector<std::string>>
        rows;  ///< As long as `head`; the first one names the row.
};

struct Figure {
    std::string name;  ///< One of figureNames().
    std::string title;
    std::vector<std::string> caption;  ///< Paragraphs.
    int columns = 1;                   ///< Panels side by side, where there is room.
    std::vector<Panel> panels;
    std::vector<DataTable> tables;
};

}  // namespace polylume::figures
