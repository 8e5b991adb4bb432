// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "bench/lighting_bench.hpp"

#include <algorithm>
#include <functional>
#include <memory>

#include "bench/bench_shaders.hpp"
#include "bench/lit_floor.hpp"
#include "bench/textbook_pass.hpp"
#include "core/text.hpp"
#include "polylume/error.hpp"
#include "render/renderer.hpp"

namespace polylume::bench {
namespace {

/// Lights on a GPU, which is done with fewer before its clock has told them from none.
constexpr int kHardwareLightCount = 64;

constexpr BenchCase kReferenceCase = {Shape::rectangle, Model::oneLobe};

bool hasSheen(Model model) {
    return model == Model::sheen || model == Model::everything;
}

/// A case with its program and its measurements, in nanoseconds of a pixel.
struct Subject {
    BenchCase which;
    LightSet oneLight;
    LightSet manyLights;
    int lightCount;
    const LitFloor* floor;
    std::unique_ptr<LightingPass> pass;
    std::vector<double> perLight{};
    std::vector<double> fixed{};
};

/// A number of rectangles, and the measurements in milliseconds.
struct SweepStep {
    int lightCount;
    std::vector<double> milliseconds{};
    std::vector<double> textbookMilliseconds{};
};

/// A way to write the textbook formulation, and its measurements in nanoseconds of a pixel and a
/// light and in units of ours.
struct TextbookSubject {
    TextbookInfo info;
    TextbookPass pass;
    std::vector<double> perLight{};
    std::vector<double> ratios{};
};

/// What is measured, and the measurements.
class Measurements {
  public:
    Measurements(Context& context, const BenchOptions& options);

    /// Everything once, with a call of `step` after each of stepCount() parts.
    void measure(const std::function<void()>& step);
    std::size_t stepCount() const { return subjects_.size() + sweep_.size() + 2; }

    BenchResult result() const;

  private:
    void addSubject(const BenchCase& which);
    const LitFloor& floorOf(Model model);
    /// Seconds of one drawing of `lights`.
    double secondsOf(const Subject& subject, const LightSet& lights);
    double textbookSecondsOf(TextbookSubject& subject, const LightSet& lights);
    void measureSubject(Subject& subject, double emptyTime);
    /// Beside a subject that has just been measured.
    void measureTextbook(TextbookSubject& textbook, const Subject& subject);
    void measureSweep(SweepStep& step);

    double perPixel(double seconds) const {
        return 1e9 * seconds / (static_cast<double>(options_.size.x) * options_.size.y);
    }
    const Subject& reference() const { return *subjects_.front(); }
    CaseResult resultOf(const Subject& subject, const MachineRates& machine) const;

    Context& context_;
    const gl::Functions& gl_;
    BenchOptions options_;
    gl::ShaderLibrary library_;
    Stopwatch stopwatch_;
    MachineBench machine_;
    FullscreenPass empty_;
    std::vector<std::unique_ptr<TextbookSubject>> textbooks_;
    std::unique_ptr<LitFloor> plainFloor_;
    std::unique_ptr<LitFloor> sheenFloor_;
    /// The first is the rectangle that the textbook formulation is compared with.
    std::vector<std::unique_ptr<Subject>> subjects_;
    std::vector<SweepStep> sweep_;
    std::vector<double> emptyTimes_;
};

Measurements::Measurements(Context& context, const BenchOptions& options)
    : context_(context),
      gl_(context.functions()),
      options_(options),
      library_(makeShaderLibrary()),
      stopwatch_(context, options.clock),
      machine_(gl_, library_, options.size),
      empty_(gl_, library_, "bench/empty.frag", {}, options.size) {
    if (options_.cases.empty()) options_.cases = defaultCases();
    addSubject(kReferenceCase);
    for (const BenchCase& which : options_.cases) {
        if (which != kReferenceCase) addSubject(which);
    }
    for (const TextbookInfo& info : kTextbooks) {
        textbooks_.push_back(std::make_unique<TextbookSubject>(
            TextbookSubject{info, TextbookPass(gl_, library_, options_.size, info.variant)}));
    }
    for (const int count : options_.sweepCounts) sweep_.push_back({count});
    context_.debugLog().checkNoErrors("preparing the benchmark");
}

const LitFloor& Measurements::floorOf(Model model) {
    std::unique_ptr<LitFloor>& floor = hasSheen(model) ? sheenFloor_ : plainFloor_;
    if (!floor) floor = std::make_unique<LitFloor>(gl_, library_, model, options_.size);
    return *floor;
}

void Measurements::addSubject(const BenchCase& which) {
    const int count =
        context_.info().software ? infoOf(which.shape).softwareLightCount : kHardwareLightCount;
    LightingModel model = lightingModel(which.model);
    model.sheen = hasSheen(which.model);
    subjects_.push_back(std::make_unique<Subject>(
        Subject{which, makeLights(which.shape, 1), makeLights(which.shape, count), count,
                &floorOf(which.model), std::make_unique<LightingPass>(gl_, library_, model)}));
}

double Measurements::secondsOf(const Subject& subject, const LightSet& lights) {
    subject.pass->setLights(lights);
    return stopwatch_.seconds([&] { subject.floor->light(*subject.pass); });
}

double Measurements::textbookSecondsOf(TextbookSubject& subject, const LightSet& lights) {
    subject.pass.setLights(lights);
    return stopwatch_.seconds(
        [&] { subject.pass.draw(reference().floor->gbuffer().textureNames()); });
}

void Measurements::measureSubject(Subject& subject, double emptyTime) {
    // The first drawing compiles the program, or more of it.
    if (subject.perLight.empty()) secondsOf(subject, subject.oneLight);
    const double withOne = perPixel(secondsOf(subject, subject.oneLight));
    const double withMany = perPixel(secondsOf(subject, subject.manyLights));
    subject.perLight.push_back((withMany - withOne) / (subject.lightCount - 1));
    subject.fixed.push_back(withOne - subject.perLight.back() - emptyTime);
}

void Measurements::measureTextbook(TextbookSubject& textbook, const Subject& subject) {
    if (textbook.perLight.empty()) textbookSecondsOf(textbook, subject.oneLight);
    const double withOne = perPixel(textbookSecondsOf(textbook, subject.oneLight));
    const double withMany = perPixel(textbookSecondsOf(textbook, subject.manyLights));
    textbook.perLight.push_back((withMany - withOne) / (subject.lightCount - 1));
    textbook.ratios.push_back(textbook.perLight.back() / subject.perLight.back());
}

void Measurements::measureSweep(SweepStep& step) {
    const LightSet lights = makeLights(Shape::rectangle, step.lightCount);
    step.milliseconds.push_back(1e3 * secondsOf(reference(), lights));
    step.textbookMilliseconds.push_back(1e3 * textbookSecondsOf(*textbooks_.front(), lights));
}

void Measurements::measure(const std::function<void()>& step) {
    machine_.measure(stopwatch_);
    if (emptyTimes_.empty()) empty_.draw();
    emptyTimes_.push_back(perPixel(stopwatch_.seconds([&] { empty_.draw(); })));
    step();
    for (const auto& subject : subjects_) {
        measureSubject(*subject, emptyTimes_.back());
        step();
        if (subject == subjects_.front()) {
            for (const auto& textbook : textbooks_) measureTextbook(*textbook, *subject);
            step();
        }
    }
    for (SweepStep& sweepStep : sweep_) {
        measureSweep(sweepStep);
        step();
    }
    context_.debugLog().checkNoErrors("measuring");
}

/// The time that arithmetic or reads take alone, whichever is longer.
Floor floorOf(const Operations& operations, const MachineRates& machine) {
    const double arithmetic = 1e9 * (operations.simple + kSpecialWeight * operations.special) /
                              machine.operations.perSecond.median;
    const double reads = 1e9 * operations.bytes / machine.sharedBytes.perSecond.median;
    return {std::max(arithmetic, reads), arithmetic >= reads};
}

CaseResult Measurements::resultOf(const Subject& subject, const MachineRates& machine) const {
    const auto& [shape, model] = subject.which;
    CaseResult result;
    result.which = subject.which;
    result.lightCount = subject.lightCount;
    result.nanoseconds = summarize(subject.perLight);
    result.fixed = summarize(subject.fixed);
    result.operations = operationsPerLight(shape, model);
    result.pixelOperations = operationsPerPixel(shape, model);
    result.floor = bench::floorOf(result.operations, machine);
    result.ratio = result.nanoseconds.median / result.floor.nanoseconds;
    return result;
}

BenchResult Measurements::result() const {
    BenchResult result;
    result.context = context_.info();
    result.clock = stopwatch_.name();
    result.size = options_.size;
    result.repeatCount = static_cast<int>(emptyTimes_.size());
    result.machine = machine_.rates();
    result.emptyPass = summarize(emptyTimes_);
    for (const auto& subject : subjects_) {
        if (std::ranges::find(options_.cases, subject->which) == options_.cases.end()) continue;
        result.cases.push_back(resultOf(*subject, result.machine));
    }
    for (const auto& textbook : textbooks_) {
        TextbookResult& one = result.textbooks.emplace_back();
        one.variant = textbook->info.variant;
        one.nanoseconds = summarize(textbook->perLight);
        one.ratio = summarize(textbook->ratios);
        one.operations = operationsPerLight(one.variant);
        one.floor = bench::floorOf(one.operations, result.machine);
    }
    for (const SweepStep& step : sweep_) {
        result.sweep.push_back(
            {step.lightCount, summarize(step.milliseconds), summarize(step.textbookMilliseconds)});
    }
    return result;
}

void checkOptions(const gl::Functions& gl, const BenchOptions& options) {
    checkPictureSize(gl, options.size);
    if (options.repeatCount < 1) {
        throw Error(concat("expected 1 repeat or more, found ", options.repeatCount));
    }
    for (const int count : options.sweepCounts) {
        if (count >= 1 && count <= static_cast<int>(TextbookPass::kMostLights)) continue;
        throw Error(concat("expected 1 to ", TextbookPass::kMostLights,
                           " lights to sweep over, found ", count));
    }
}

}  // namespace

std::vector<BenchCase> defaultCases() {
    std::vector<BenchCase> cases;
    for (const ShapeInfo& shape : kShapes) cases.push_back({shape.shape, Model::oneLobe});
    for (const ModelInfo& model : kModels) {
        if (model.model != Model::oneLobe) cases.push_back({Shape::rectangle, model.model});
    }
    return cases;
}

BenchResult runLightingBench(Context& context, const BenchOptions& options, Progress& progress) {
    checkOptions(context.functions(), options);
    Measurements measurements(context, options);
    const auto steps = static_cast<double>(measurements.stepCount()) * options.repeatCount;
    double done = 0.0;
    for (int i = 0; i < options.repeatCount; ++i) {
        measurements.measure([&] { progress.update(++done / steps); });
    }
    return measurements.result();
}

}  // namespace polylume::bench
