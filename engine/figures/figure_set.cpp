// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "figures/figure_set.hpp"

#include <fmt/format.h>
#include <tbb/global_control.h>
#include <tbb/info.h>

#include <algorithm>
#include <memory>
#include <optional>
#include <span>

#include "core/file.hpp"
#include "figures/comparison_figures.hpp"
#include "figures/comparison_panel.hpp"
#include "figures/figure_folder.hpp"
#include "figures/html_page.hpp"
#include "figures/invariance_figure.hpp"
#include "figures/jacobian_figure.hpp"
#include "figures/partial_progress.hpp"
#include "figures/picture_maker.hpp"
#include "polylume/error.hpp"

namespace polylume::figures {
namespace {

/// Makes one figure after another, and a context at the first one that needs it.
class FigureSet {
  public:
    explicit FigureSet(const FigureSetOptions& options) : options_(options) {}

    Figure make(std::string_view name, Progress& progress) {
        ImageMetadata metadata;
        metadata["Software"] = fmt::format("Polylume {}", options_.version);
        metadata["polylume:figure"] = std::string(name);
        const bool quick = options_.quick;
        if (name == "invariance" || name == "jacobian") {
            const FigureFolder folder(options_.directory, name, metadata);
            return name == "invariance" ? makeInvarianceFigure(folder)
                                        : makeJacobianFigure(folder, quick);
        }
        PictureMaker& maker = pictureMaker();
        metadata["polylume:backend"] = maker.contextInfo().backend;
        metadata["polylume:renderer"] = maker.contextInfo().renderer;
        metadata["polylume:glVersion"] = maker.contextInfo().version;
        const FigureFolder folder(options_.directory, name, metadata);
        if (name == "floor") return makeFloorFigure(folder, maker, quick, progress);
        if (name == "failures") return makeFailureFigure(folder, maker, quick, progress);
        if (name == "shapes") return makeShapeFigure(folder, maker, quick, progress);
        return makeQualityFigure(folder, maker, quick, progress);
    }

    std::vector<std::string> introduction() const {
        std::vector<std::string> texts = {
            fmt::format("Made by polylume figures{}, version {}. The pictures, as PNG and as "
                        "OpenEXR with radiance in nits, lie beside this page, which needs none of "
                        "them.",
                        options_.quick ? " --quick (few cases, small pictures, few paths)" : "",
                        options_.version)};
        if (maker_) {
            texts.push_back(explainComparisons(maker_->settings()));
            const ContextInfo& info = maker_->contextInfo();
            texts.push_back(
                fmt::format("OpenGL {} of {}, by {}. Times are of the machine that "
                            "made the page; all else is the same on every run.",
                            info.version, info.renderer, info.backend));
        }
        return texts;
    }

  private:
    PictureMaker& pictureMaker() {
        if (!maker_) {
            PictureSettings settings;
            settings.threadCount = options_.threadCount;
            if (options_.quick) {
                settings.size = {160, 90};
                settings.sampleCount = 1;
                settings.pathCount = 256;
                settings.targetError = 0.01;
            }
            maker_ = std::make_unique<PictureMaker>(options_.backend, settings);
        }
        return *maker_;
    }

    const FigureSetOptions& options_;
    std::unique_ptr<PictureMaker> maker_;
};

}  // namespace

std::vector<std::string_view> figureNames() {
    return {"invariance", "floor", "shapes", "failures", "quality", "jacobian"};
}

void makeFigures(const FigureSetOptions& options, Progress& progress) {
    std::vector<std::string_view> names = figureNames();
    if (!options.only.empty()) {
        if (std::ranges::find(names, options.only) == names.end()) {
            throw Error(fmt::format("expected a figure of {}, found \"{}\"", fmt::join(names, ", "),
                                    options.only));
        }
        names = {options.only};
    }
    createFolder(options.directory);
    const std::filesystem::path page = options.directory / "index.html";
    checkWritable(page);
    std::optional<tbb::global_control> limit;
    if (options.threadCount > 0) {
        const int most = std::min(options.threadCount, tbb::info::default_concurrency());
        limit.emplace(tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(most));
    }
    FigureSet set(options);
    std::vector<Figure> figures;
    for (std::size_t i = 0; i < names.size(); ++i) {
        PartialProgress part(progress, i, names.size());
        figures.push_back(set.make(names[i], part));
        part.update(1.0);
    }
    const std::string html = makeHtmlPage(set.introduction(), figures);
    writeFile(page, std::as_bytes(std::span(html)));
}

}  // namespace polylume::figures
