// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "fit/full_score.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

#include "fit/lobe_samples.hpp"
#include "fit/prepared_model.hpp"
#include "fit/score_grid.hpp"
#include "parallel/threads.hpp"

namespace polylume::fit {
namespace {

/// What is found out at one place.
struct PlaceResult {
    double l1 = 0.0;
    double l2 = 0.0;
    double leak = 0.0;
    PolygonErrors polygons;
    double albedo = 0.0;
    double fresnel = 0.0;
};

/// Sums over rectangles by the points of a rule: f - m is summed point by point and m known in
/// closed form, so that the noise of the rectangle's edges among the points is that of f - m, a
/// tenth of f's.
class RectangleSums {
  public:
    explicit RectangleSums(const std::vector<Rectangle>& rectangles)
        : differences_(rectangles.size()) {
        for (const Rectangle& rectangle : rectangles) cones_.emplace_back(rectangle);
    }

    /// A point of positive y that stands for its mirror image too.
    void add(const glm::dvec3& direction, double difference) {
        const glm::dvec3 mirrored(direction.x, -direction.y, direction.z);
        for (std::size_t i = 0; i < cones_.size(); ++i) {
            if (cones_[i].holds(direction)) differences_[i] += 0.5 * difference;
            if (cones_[i].holds(mirrored)) differences_[i] += 0.5 * difference;
        }
    }

    double difference(std::size_t index) const { return differences_[index]; }

  private:
    std::vector<RectangleCone> cones_;
    std::vector<double> differences_;
};

double leakOf(const ltc::TableEntry& entry) {
    // Lobes of the weights share / H hold 1 above the surface.
    double whole = 0.0;
    for (int i = 0; i < entry.lobeCount; ++i) {
        whole += entry.shares[i] / ltc::upperShare(entry.lobes[i]);
    }
    return 1.0 - 1.0 / whole;
}

/// All but the reflectance.
PlaceResult scoreLobes(const brdf::Brdf& brdf, const ScorePlace& place,
                       const ltc::TableEntry& entry, const std::vector<Rectangle>& rectangles,
                       int resolution) {
    const LobeSamples samples = sampleLobe(brdf, place.roughness, place.cosThetaView, resolution);
    const double scale = entry.albedo / samples.albedo;
    const PreparedModel model(entry);
    RectangleSums sums(rectangles);
    PlaceResult result;
    double squares = 0.0;
    double differenceSquares = 0.0;
    for (const LobeSamples::Point& point : samples.points) {
        const double difference = point.target - scale * model.density(point.direction);
        result.l1 += point.area * std::abs(difference);
        squares += point.area * point.target * point.target;
        differenceSquares += point.area * difference * difference;
        sums.add(point.direction, point.area * difference);
    }
    result.l2 = std::sqrt(differenceSquares / squares);
    result.leak = leakOf(entry);
    for (std::size_t i = 0; i < rectangles.size(); ++i) {
        const double difference = sums.difference(i);
        result.polygons.add(scale * modelShare(rectangles[i], entry) + difference, difference);
    }
    return result;
}

/// Adds places up to means.
class ErrorSums {
  public:
    void add(const PlaceResult& place) {
        ++count_;
        addTo(lobes_.l1, place.l1);
        addTo(lobes_.l2, place.l2);
        addTo(lobes_.leak, place.leak);
        polygons_.add(place.polygons);
        addTo(reflectance_.albedo, place.albedo);
        addTo(reflectance_.fresnel, place.fresnel);
    }

    LobeErrors lobes() const {
        LobeErrors errors = lobes_;
        for (ErrorSummary* summary : {&errors.l1, &errors.l2, &errors.leak}) divide(*summary);
        errors.polygonMean = polygons_.mean();
        errors.polygonOfSums = polygons_.ratioOfSums();
        errors.polygonCount = polygons_.count;
        return errors;
    }

    ReflectanceErrors reflectance() const {
        ReflectanceErrors errors = reflectance_;
        divide(errors.albedo);
        divide(errors.fresnel);
        return errors;
    }

  private:
    static void addTo(ErrorSummary& summary, double error) {
        summary.mean += error;
        summary.largest = std::max(summary.largest, error);
    }
    void divide(ErrorSummary& summary) const {
        if (count_ > 0) summary.mean /= count_;
    }

    int count_ = 0;
    LobeErrors lobes_;
    PolygonErrors polygons_;
    ReflectanceErrors reflectance_;
};

enum class PlaceKind { atNode, betweenNodes, grazing };

/// A place, the row that it counts for, and how.
struct Task {
    ScorePlace place;
    std::size_t row;
    PlaceKind kind;
};

std::vector<Task> tasksOf(const ltc::Table& table, const std::vector<double>& roughnesses) {
    constexpr int kGrazingCount = 18;  // A quarter of a degree apart.
    constexpr double kGrazingStep = (kMostGrazingDegrees - kMostScoredDegrees) / kGrazingCount;
    const std::vector<double> views = scoredViews(0.0, kMostScoredDegrees, kScoredViewCount);
    const std::vector<double> grazing =
        scoredViews(kMostScoredDegrees + kGrazingStep, kMostGrazingDegrees, kGrazingCount);
    std::vector<Task> tasks;
    for (std::size_t row = 0; row < roughnesses.size(); ++row) {
        for (const ScorePlace& place : nodesNear(table, roughnesses[row], views)) {
            tasks.push_back({place, row, PlaceKind::atNode});
        }
        for (const double cosine : views) {
            tasks.push_back({{roughnesses[row], cosine}, row, PlaceKind::betweenNodes});
        }
        for (const double cosine : grazing) {
            tasks.push_back({{roughnesses[row], cosine}, row, PlaceKind::grazing});
        }
    }
    return tasks;
}

PlaceResult scoreTask(const brdf::Brdf& brdf, const ltc::Table& table, const Task& task,
                      std::uint64_t seed, const FullScoreOptions& options) {
    const auto [roughness, cosThetaView] = task.place;
    const ltc::TableEntry entry = table.lookup(roughness, cosThetaView);
    PlaceResult result;
    if (task.kind != PlaceKind::grazing) {
        const std::vector<Rectangle> rectangles = randomRectangles(seed, options.rectangleCount);
        result = scoreLobes(brdf, task.place, entry, rectangles, options.resolution);
    }
    const brdf::Reflectance truth = brdf.reflectance(roughness, cosThetaView);
    result.albedo = std::abs(entry.albedo - truth.albedo);
    result.fresnel = std::abs(entry.fresnel - truth.fresnel);
    return result;
}

/// The sums that make one ScoreRow.
struct RowSums {
    ErrorSums atNodes;
    ErrorSums betweenNodes;
    ErrorSums grazing;  // And all between nodes.

    void add(PlaceKind kind, const PlaceResult& result) {
        if (kind == PlaceKind::atNode) atNodes.add(result);
        if (kind == PlaceKind::betweenNodes) betweenNodes.add(result);
        if (kind != PlaceKind::atNode) grazing.add(result);
    }

    ScoreRow row(double roughness) const {
        return {roughness,
                atNodes.lobes(),
                betweenNodes.lobes(),
                atNodes.reflectance(),
                betweenNodes.reflectance(),
                grazing.reflectance()};
    }
};

FullScore scoreInArena(const brdf::Brdf& brdf, const ltc::Table& table,
                       const FullScoreOptions& options, Progress& progress) {
    const std::vector<double> roughnesses = scoredRoughnesses(table, kScoredRoughnessCount);
    const std::vector<Task> tasks = tasksOf(table, roughnesses);
    std::vector<PlaceResult> results(tasks.size());
    StepCounter counter(progress, tasks.size());
    tbb::parallel_for(std::size_t{0}, tasks.size(), [&](std::size_t i) {
        // Each place has rectangles of its own, whichever thread comes to it.
        results[i] = scoreTask(brdf, table, tasks[i], options.seed * 1000003 + i, options);
        counter.step();
    });
    // In a fixed order, so that sums are the same for any number of threads.
    std::vector<RowSums> rows(roughnesses.size());
    RowSums overall;
    for (std::size_t i = 0; i < tasks.size(); ++i) {
        rows[tasks[i].row].add(tasks[i].kind, results[i]);
        overall.add(tasks[i].kind, results[i]);
    }
    FullScore score;
    for (std::size_t i = 0; i < rows.size(); ++i) score.rows.push_back(rows[i].row(roughnesses[i]));
    score.overall = overall.row(0.0);
    return score;
}

}  // namespace

FullScore computeFullScore(const brdf::Brdf& brdf, const ltc::Table& table,
                           const FullScoreOptions& options, Progress& progress) {
    return runOnThreads(options.threadCount,
                        [&] { return scoreInArena(brdf, table, options, progress); });
}

LobeErrors placeErrors(const brdf::Brdf& brdf, double roughness, double cosThetaView,
                       const ltc::TableEntry& entry, const FullScoreOptions& options) {
    const std::vector<Rectangle> rectangles =
        randomRectangles(options.seed, options.rectangleCount);
    ErrorSums sums;
    sums.add(scoreLobes(brdf, {roughness, cosThetaView}, entry, rectangles, options.resolution));
    return sums.lobes();
}

}  // namespace polylume::fit
