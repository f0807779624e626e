#include "claims.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>

#include "paper_figures.hpp"
#include "results/page/number_text.hpp"
#include "results/statistics/descriptive.hpp"
#include "results/statistics/holm.hpp"
#include "results/statistics/rank_sum.hpp"

namespace deixis::results {

namespace {

/// Correlations of the paper's Table 2 are strong (.718) or at most this.
constexpr double weak_rho = 0.15;
constexpr double strong_rho = 0.5;

using Values = std::map<std::string, double>;  ///< by system

/// "a .620 > b .590", from the highest.
std::string order(const Values& values, const std::function<std::string(double)>& text) {
    std::vector<std::pair<double, std::string>> sorted;
    for (const auto& [system, value] : values) sorted.emplace_back(value, system);
    std::stable_sort(sorted.begin(), sorted.end(),
                     [](const auto& a, const auto& b) { return a.first > b.first; });
    std::string out;
    for (const auto& [value, system] : sorted)
        out += fmt::format("{}{} {}", out.empty() ? "" : " > ", system, text(value));
    return out;
}

std::string three(double value) {
    return fixedText(value, 3);
}
std::string two(double value) {
    return fixedText(value, 2);
}
std::string percent(double value) {
    return fixedText(100.0 * value, 1) + "\u00a0%";
}

/// Of those systems that the paper has a value of.
Values paperValues(const std::function<std::optional<double>(const PaperSystem&)>& read) {
    Values out;
    for (const PaperSystem& one : paper_systems)
        if (const auto value = read(one)) out[std::string(one.system)] = *value;
    return out;
}

/// Whether ours has all of the paper's systems, and every two of them the same way round.
Verdict sameOrder(const Values& paper, const Values& ours) {
    for (const auto& [system, value] : paper)
        if (!ours.contains(system)) return Verdict::unknown;
    for (const auto& [a, value_a] : paper)
        for (const auto& [b, value_b] : paper)
            if (value_a > value_b && !(ours.at(a) > ours.at(b))) return Verdict::differs;
    return Verdict::agrees;
}

Values onlyOf(const Values& paper, const Values& ours) {
    Values out;
    for (const auto& [system, value] : ours)
        if (paper.contains(system)) out[system] = value;
    return out;
}

Verdict verdictOf(bool agrees) {
    return agrees ? Verdict::agrees : Verdict::differs;
}

class Claims {
  public:
    explicit Claims(const ReproductionInput& input) : input_(input) {}

    std::vector<Claim> all() {
        for (const GridFigures& grid : input_.grids) objective(grid);
        for (const StudyFigures& study : input_.studies) perceptual(study);
        hands();
        sizes();
        return std::move(out_);
    }

  private:
    void add(Claim claim) {
        if (claim.verdict != Verdict::differs) claim.why.clear();
        if (claim.verdict != Verdict::unknown) out_.push_back(std::move(claim));
    }

    void objective(const GridFigures& grid) {
        Values means, rhos;
        std::map<std::string, const GridFigures::System*> systems;
        for (const GridFigures::System& one : grid.systems) {
            systems[one.system] = &one;
            if (one.mean) means[one.system] = *one.mean;
            if (one.density_rho) rhos[one.system] = *one.density_rho;
        }
        const Values paper = paperValues([](const PaperSystem& one) { return one.equation_2; });
        add({"3.2", "Systems in order of Equation 2.", order(paper, two), grid.grid,
             order(onlyOf(paper, means), three), sameOrder(paper, means),
             "The demonstrations are others: synthetic ones, which point by eye and fingertip, so that their "
             "forearms, which Equation 2 measures, are 18 degrees beside their targets. MoGlow learns that; "
             "policies are rewarded for something else than they are shown."});
        clusters(grid, systems);
        if (!rhos.contains("moglow")) return;
        double others = 0.0;
        for (const auto& [system, rho] : rhos)
            if (system != "moglow" && paperSystem(system) != nullptr)
                others = std::max(others, std::abs(rho));
        add({"3.2, Table 2",
             "Only MoGlow's accuracy is strongly correlated with the density of training targets.",
             fmt::format("MoGlow .718, others at most {:.2f}", weak_rho), grid.grid,
             fmt::format("moglow {}, others at most {}", two(rhos["moglow"]), two(others)),
             verdictOf(rhos["moglow"] >= strong_rho && others <= weak_rho),
             "Ours are spread evenly over a half-cylinder. Far from all of them is near the body, where "
             "nobody has pointed: any system is worse there, and any system's correlation is a part of "
             "that."});
    }

    void clusters(const GridFigures& grid, const std::map<std::string, const GridFigures::System*>& systems) {
        Values means;
        std::map<std::string, int> outliers;
        for (const char* one : {"amp-pfnn-1", "amp-pfnn-3", "amp-pfnn-8"}) {
            const auto found = systems.find(one);
            if (found == systems.end() || !found->second->mean) return;
            means[one] = *found->second->mean;
            outliers[one] = lowOutliers(found->second->accuracies);
        }
        add({"3.2", "Eight clusters are slightly more accurate than one or three.",
             "no numbers but .62 of eight", grid.grid, order(means, three),
             verdictOf(means["amp-pfnn-8"] > means["amp-pfnn-1"] &&
                       means["amp-pfnn-8"] > means["amp-pfnn-3"]),
             "Each policy of eight has an eighth of the demonstrations to learn from, and as much time as "
             "the one policy of one cluster."});
        add({"3.2", "Eight clusters have fewer outliers than one or three.", "a box plot without numbers",
             grid.grid,
             fmt::format("1: {}, 3: {}, 8: {} of {} points", outliers["amp-pfnn-1"], outliers["amp-pfnn-3"],
                         outliers["amp-pfnn-8"], grid.points),
             verdictOf(outliers["amp-pfnn-8"] < outliers["amp-pfnn-1"] &&
                       outliers["amp-pfnn-8"] < outliers["amp-pfnn-3"]),
             "What is an outlier depends on how wide the box is: the more alike a system is at most points, "
             "the more of the others stand out."});
    }

    void perceptual(const StudyFigures& study) {
        const std::string reader =
            "Simulated participants answer, who read an arm by assumption; which lines they read moves right "
            "choices as much as the systems do. The paper's answers are people's.";
        const std::string rater =
            "Simulated ratings follow speed profile, participation of the body and steadiness; what an eye "
            "would see in a movement they do not know.";
        const auto ours = [&](const char* measure) {
            Values out;
            for (const StudyFigures::Score& one : study.scores)
                if (one.measure == measure) out[one.system] = one.mean;
            return out;
        };
        const Values accuracy = paperValues([](const PaperSystem& one) { return one.accuracy; });
        const Values naturalness = paperValues([](const PaperSystem& one) { return one.naturalness; });
        const Values our_accuracy = ours("accuracy"), our_naturalness = ours("naturalness");
        const std::string& kind = study.participants_kind;
        add({"3.1", "Systems in order of right choices.", order(accuracy, percent), kind,
             order(onlyOf(accuracy, our_accuracy), percent), sameOrder(accuracy, our_accuracy), reader});
        add({"3.1", "Systems in order of naturalness.", order(naturalness, two), kind,
             order(onlyOf(naturalness, our_naturalness), two), sameOrder(naturalness, our_naturalness),
             rater});
        pairs(study, "accuracy", reader);
        pairs(study, "naturalness", rater);
        if (study.layout_tests > 0)
            add({"3.1, Table 1", "No significant difference between across and side by side, for any system.",
                 fmt::format("0 of 4 at {:g}", paper_alpha), kind,
                 fmt::format("{} of {} at {:g}", study.layouts_that_differ, study.layout_tests, study.alpha),
                 verdictOf(study.layouts_that_differ == 0), reader});
        for (const GridFigures& grid : input_.grids) {
            Values means;
            for (const GridFigures::System& one : grid.systems)
                if (one.mean && accuracy.contains(one.system) && one.system != "gt-nn")
                    means[one.system] = *one.mean;
            if (means.size() < 3) continue;
            add({"3.2", "The objective evaluation has the systems in the order of people's right choices.",
                 "the same for MoGlow, AMP base and AMP-pfnn", fmt::format("{}; {}", kind, grid.grid),
                 fmt::format("{}; {}", order(onlyOf(means, our_accuracy), percent), order(means, three)),
                 sameOrder(means, our_accuracy), reader});
        }
    }

    void pairs(const StudyFigures& study, const std::string& measure, const std::string& why) {
        std::vector<std::string> alike;
        int tests = 0;
        bool right_pair = false;
        for (const StudyFigures::Pair& one : study.pairs) {
            if (one.measure != measure) continue;
            ++tests;
            if (one.significant) continue;
            alike.push_back(fmt::format("{} / {}", one.a, one.b));
            const auto [low, high] = std::minmax(one.a, one.b);
            right_pair = low == paper_alike_a && high == paper_alike_b;
        }
        if (tests != 6) return;
        const bool accuracy = measure == "accuracy";
        const bool agrees = accuracy ? alike.size() == 1 && right_pair : alike.empty();
        add({"3.1",
             accuracy ? "All pairs of systems differ in right choices, but for AMP base and GT-nn."
                      : "All pairs of systems differ in naturalness.",
             fmt::format("{} of 6 at {:g}", accuracy ? 5 : 6, paper_alpha), study.participants_kind,
             fmt::format("{} of 6 at {:g}{}", 6 - alike.size(), study.alpha,
                         alike.empty() ? "" : fmt::format("; not {}", fmt::join(alike, ", "))),
             verdictOf(agrees), why});
    }

    void hands() {
        const auto compared = compareHands(input_.demonstrations);
        if (compared.empty()) return;
        std::vector<std::string> texts;
        bool none = true;
        for (const HandsCompared& one : compared) {
            texts.push_back(fmt::format("{}: p = {}", one.measure, pWords(one.p_holm)));
            none = none && one.p_holm > paper_alpha;
        }
        add({"2.1",
             "No significant difference between the demonstrations of the dominant and the other hand.",
             "no test named", "demonstrations", inSentence(texts), verdictOf(none),
             "Both hands are made by the same formulas; chance remains."});
    }

    void sizes() {
        long long moglow = 0, largest_policy = 0;
        for (const TrainedSystem& one : input_.trained) {
            if (one.system == "moglow") moglow = one.numbers;
            if (one.system.starts_with("amp-") && paperSystem(one.system) != nullptr)
                largest_policy = std::max(largest_policy, one.numbers);
        }
        if (moglow == 0 || largest_policy == 0) return;
        add({"1", "The policies are considerably more lightweight than the supervised system.", "no numbers",
             "weights",
             fmt::format("moglow {:.1f} million numbers, the largest policies {:.2f} million",
                         static_cast<double>(moglow) / 1e6, static_cast<double>(largest_policy) / 1e6),
             verdictOf(largest_policy * 2 < moglow), ""});
    }

    const ReproductionInput& input_;
    std::vector<Claim> out_;
};

}  // namespace

int lowOutliers(const std::vector<double>& values) {
    const double q25 = quantile(values, 0.25), q75 = quantile(values, 0.75);
    const double fence = q25 - 1.5 * (q75 - q25);
    return static_cast<int>(std::ranges::count_if(values, [&](double one) { return one < fence; }));
}

std::vector<HandsCompared> compareHands(const std::vector<DemonstrationFigures>& demonstrations) {
    std::vector<HandsCompared> out;
    std::vector<double> p;
    for (const auto& [measure, read] :
         {std::pair{"accuracy (Eq. 2)", &DemonstrationFigures::equation_2},
          std::pair{"peak speed of the hand (m/s)", &DemonstrationFigures::peak_speed_m_s}}) {
        std::vector<double> values[2];
        std::vector<Rational> exact[2];
        for (const DemonstrationFigures& one : demonstrations) {
            values[one.left ? 0 : 1].push_back(one.*read);
            exact[one.left ? 0 : 1].push_back(Rational::fromShortestDecimal(one.*read));
        }
        if (values[0].empty() || values[1].empty()) return {};
        const RankSumTest test = rankSumTest(exact[0], exact[1]);
        out.push_back({measure, test.n_a, test.n_b, quantile(values[0], 0.5), quantile(values[1], 0.5),
                       test.p_two_sided.value_or(1.0)});
        p.push_back(out.back().p);
    }
    const auto corrected = holm(p);
    for (std::size_t i = 0; i < out.size(); ++i) out[i].p_holm = corrected[i];
    return out;
}

std::vector<Claim> paperClaims(const ReproductionInput& input) {
    return Claims(input).all();
}

}  // namespace deixis::results
