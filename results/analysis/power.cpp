#include "results/analysis/power.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <tuple>

#include "core/parallel.hpp"
#include "core/random.hpp"
#include "results/analysis/analysis.hpp"
#include "studies/design/plan.hpp"
#include "studies/simulation/assumed_answers.hpp"
#include "studies/study_file/stage_kind.hpp"

namespace deixis::results {

namespace {

/// What tells one test of an analysis from all others.
using ContrastKey = std::tuple<std::string, std::string, std::string, std::string>;

/// Counts of one thread, for one number of participants.
struct PowerCounts {
    std::map<ContrastKey, Found> found;
    std::map<std::string, std::pair<int, int>> families;  ///< any, all

    void add(const PowerCounts& other) {
        for (const auto& [key, count] : other.found) {
            found[key].a_higher += count.a_higher;
            found[key].b_higher += count.b_higher;
        }
        for (const auto& [name, count] : other.families) {
            families[name].first += count.first;
            families[name].second += count.second;
        }
    }
};

/// One test of an analysis. Those of groups without answers have no p, and are none.
struct PowerTest {
    std::string family, measure, system, a, b;
    bool significant = false;
    bool a_higher = false;
};

/// Calls visit(PowerTest) for each test of the analysis, families one after another.
template <typename Visit>
void eachTest(const AnalysisResult& analysis, Visit visit) {
    const auto paired = [&](const AdjustedTest& one, const std::string& measure, const std::string& system,
                            const std::string& a, const std::string& b) {
        visit(PowerTest{one.family, measure, system, a, b, one.significant,
                        one.test.w_plus > one.test.w_minus});
    };
    const auto of_groups = [&](const GroupTest& one, const std::string& measure, const std::string& system) {
        if (one.test.p_two_sided)
            visit(PowerTest{one.family, measure, system, one.a, one.b, one.significant,
                            one.test.cliffs_delta > 0.0});
    };
    for (const Comparison& one : analysis.pairwise) paired(one, one.measure, one.system, one.a, one.b);
    for (const Comparison& one : analysis.level_tests) paired(one, one.measure, one.system, one.a, one.b);
    for (const PreferenceResult& one : analysis.preferences) paired(one, "preference", "", one.a, one.b);
    for (const BetweenResult& one : analysis.between) of_groups(one, one.measure, one.system);
    for (const PreferenceBetweenResult& one : analysis.preferences_between)
        of_groups(one, "preference", fmt::format("{} against {}", one.system, one.other_system));
}

void countFound(const AnalysisResult& analysis, PowerCounts& counts) {
    std::map<std::string, std::pair<int, int>> families;  // significant, tests
    eachTest(analysis, [&](const PowerTest& test) {
        auto& [significant, tests] = families[test.family];
        ++tests;
        if (!test.significant) return;
        ++significant;
        Found& found = counts.found[{test.family, test.system, test.a, test.b}];
        ++(test.a_higher ? found.a_higher : found.b_higher);
    });
    for (const auto& [name, family] : families) {
        counts.families[name].first += family.first > 0 ? 1 : 0;
        counts.families[name].second += family.first == family.second ? 1 : 0;
    }
}

/// The system's levels of the factors that are nested in systems.
const std::map<std::string, std::string>& levelsOf(const studies::Study& study, const std::string& system) {
    return std::find_if(study.systems.begin(), study.systems.end(),
                        [&](const studies::SystemSource& one) { return one.name == system; })
        ->levels;
}

/// All of the table but the rows: what the store reads from a database of the study.
ResponseTable tableOf(const studies::Study& study, const std::vector<studies::StudyMeasure>& measures,
                      const std::vector<studies::PlannedAnswer>& planned) {
    ResponseTable table;
    table.study_name = study.name;
    table.study_hash = study.hash;
    table.alpha = study.alpha;
    std::set<std::string> systems, layouts, distances;
    for (const studies::PlannedAnswer& answer : planned) {
        for (const studies::Stimulus& stimulus : answer.trial->stimuli) systems.insert(stimulus.system);
        if (!studies::declarationOf(answer.trial->kind).balls) continue;
        layouts.insert(answer.trial->layout);
        distances.insert(answer.trial->distance);
    }
    for (const auto& system : study.systems)
        if (systems.contains(system.name)) {
            table.systems.push_back(system.name);
            if (!system.compared) table.not_compared.emplace(system.name, system.remark);
            for (const auto& [factor, level] : system.levels) addLevel(table.within, factor, level);
        }
    for (const auto& layout : study.layouts)
        if (layouts.contains(layout.name)) table.layouts.push_back(layout.name);
    for (const auto& distance : study.distances)
        if (distances.contains(distance.name)) table.distances.push_back(distance.name);
    for (const studies::StudyMeasure& measure : measures) {
        const MeasureKind kind = measure.kind == studies::AnswerKind::accuracy     ? MeasureKind::accuracy
                                 : measure.kind == studies::AnswerKind::preference ? MeasureKind::preference
                                                                                   : MeasureKind::rating;
        table.measures.push_back({measure.name, kind, static_cast<double>(measure.low),
                                  static_cast<double>(measure.high), measure.balls, 0, measure.balls});
    }
    return table;
}

ResponseRow rowOf(const studies::PlannedAnswer& answer, const std::vector<studies::StudyMeasure>& measures,
                  const std::string& participant, const studies::Study& study, const ResponseTable& table) {
    const studies::Trial& trial = *answer.trial;
    const studies::StudyMeasure& measure = measures[answer.measure];
    ResponseRow row;
    row.participant = participant;
    row.measure = measure.name;
    row.system = trial.stimuli[answer.stimulus].system;
    row.layout = trial.layout;
    row.distance = trial.distance;
    row.target_id = trial.stimuli[answer.stimulus].item;
    row.trial = trial.index;
    if (measure.kind == studies::AnswerKind::preference) row.other_system = trial.stimuli[1].system;
    const auto& levels = levelsOf(study, row.system);
    for (const Factor& factor : table.within) {
        const auto level = levels.find(factor.name);
        row.within.push_back(level == levels.end() ? "" : level->second);
    }
    row.synthetic = true;
    return row;
}

}  // namespace

struct PowerAnalysis::Impl {
    studies::Study study;
    std::vector<studies::StudyPlan> plans;
    std::optional<studies::AssumedAnswers> answers;
    ResponseTable table;            ///< without rows
    std::vector<ResponseRow> rows;  ///< of all participants, without values
    PowerResult result;
    std::map<ContrastKey, std::size_t> contrasts;  ///< place in the result

    /// How many rows the first `participants` have.
    [[nodiscard]] std::size_t rowsOf(int participants) const {
        const auto& planned = answers->planned();
        return static_cast<std::size_t>(
            std::lower_bound(planned.begin(), planned.end(), static_cast<std::size_t>(participants),
                             [](const studies::PlannedAnswer& answer, std::size_t participant) {
                                 return answer.participant < participant;
                             }) -
            planned.begin());
    }
    [[nodiscard]] AnalysisResult analysisOf(int participants) const {
        AnalysisResult out;
        out.options.alpha = result.alpha;
        out.table = table;
        out.table.rows.assign(rows.begin(), rows.begin() + static_cast<std::ptrdiff_t>(rowsOf(participants)));
        return out;
    }
    /// The tests do not depend on the answers: those of a study in which all were 0 name them.
    void listContrasts() {
        AnalysisResult all = analysisOf(static_cast<int>(plans.size()));
        runTests(all);
        eachTest(all, [&](const PowerTest& test) {
            contrasts[{test.family, test.system, test.a, test.b}] = result.contrasts.size();
            result.contrasts.push_back({test.family, test.measure, test.system, test.a, test.b});
            auto family = std::find_if(result.families.begin(), result.families.end(),
                                       [&](const FamilyPower& one) { return one.name == test.family; });
            if (family == result.families.end())
                family = result.families.insert(result.families.end(), FamilyPower{test.family});
            ++family->tests;
        });
    }
    /// Simulates studies one after another, each analysed for all sizes, and counts what is found.
    class Worker {
      public:
        Worker(const Impl& power, const std::vector<int>& sizes, std::vector<PowerCounts>& counts)
            : power_(power), counts_(counts), values_(power.rowsOf(sizes.back())) {
            analyses_.reserve(sizes.size());
            for (const int size : sizes) analyses_.push_back(power.analysisOf(size));
        }
        void operator()(std::size_t study) {
            power_.answers->draw(deriveSeed(power_.result.options.seed, fmt::format("study {}", study)),
                                 values_);
            for (std::size_t i = 0; i < analyses_.size(); ++i) {
                auto& rows = analyses_[i].table.rows;
                for (std::size_t row = 0; row < rows.size(); ++row) rows[row].value = values_[row];
                runTests(analyses_[i]);
                countFound(analyses_[i], counts_[i]);
            }
        }

      private:
        const Impl& power_;
        std::vector<PowerCounts>& counts_;
        std::vector<double> values_;
        std::vector<AnalysisResult> analyses_;
    };
    void take(int size, const PowerCounts& counts) {
        result.participants.push_back(size);
        std::sort(result.participants.begin(), result.participants.end());
        for (ContrastPower& contrast : result.contrasts) contrast.found[size];
        for (const auto& [key, found] : counts.found) result.contrasts[contrasts.at(key)].found[size] = found;
        for (FamilyPower& family : result.families) {
            const auto counted = counts.families.find(family.name);
            const bool met = counted != counts.families.end();
            family.any[size] = met ? counted->second.first : 0;
            family.all[size] = met ? counted->second.second : 0;
        }
    }
};

PowerAnalysis::PowerAnalysis(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
PowerAnalysis::PowerAnalysis(PowerAnalysis&&) noexcept = default;
PowerAnalysis::~PowerAnalysis() = default;

Result<PowerAnalysis> PowerAnalysis::make(const studies::Study& study,
                                          const std::vector<studies::TargetItem>& targets,
                                          const studies::AssumedEffects& effects, int max_participants,
                                          const PowerOptions& options) {
    auto impl = std::make_unique<Impl>();
    impl->study = study;
    studies::GroupSizes taken;
    for (int number = 1; number <= max_participants; ++number) {
        const studies::Groups groups = studies::assignGroups(study, taken, number);
        const int in_cell = ++taken[groups];
        auto plan = studies::buildPlan(study, targets, fmt::format("S{:04}", number), number, groups,
                                       study.between.empty() ? std::nullopt : std::optional(in_cell));
        if (!plan) return tl::unexpected(plan.error());
        impl->plans.push_back(std::move(*plan));
    }
    impl->answers.emplace(impl->study, effects, impl->plans);
    const auto& measures = impl->answers->measures();
    impl->table = tableOf(study, measures, impl->answers->planned());
    for (const studies::BetweenFactor& factor : study.between)
        impl->table.between.push_back({factor.name, factor.levels});
    for (const studies::StudyPlan& plan : impl->plans) impl->table.groups[plan.participant] = plan.groups;
    for (const studies::PlannedAnswer& answer : impl->answers->planned())
        impl->rows.push_back(
            rowOf(answer, measures, impl->plans[answer.participant].participant, study, impl->table));
    PowerResult& result = impl->result;
    result.study_name = study.name;
    result.study_hash = study.hash;
    result.options = options;
    result.alpha = options.alpha.value_or(study.alpha);
    for (const studies::StudyMeasure& asked : studies::studyMeasures(study))
        if (std::none_of(measures.begin(), measures.end(),
                         [&](const studies::StudyMeasure& one) { return one.name == asked.name; }))
            result.not_simulated.push_back(asked.name);
    impl->listContrasts();
    return PowerAnalysis(std::move(impl));
}

const PowerResult& PowerAnalysis::result() const {
    return impl_->result;
}

void PowerAnalysis::simulate(const std::vector<int>& participants, const PowerProgress& progress) {
    const std::set<int> known(impl_->result.participants.begin(), impl_->result.participants.end());
    std::set<int> wanted(participants.begin(), participants.end());
    for (const int size : known) wanted.erase(size);
    if (wanted.empty()) return;
    const std::vector<int> sizes(wanted.begin(), wanted.end());
    const auto studies = static_cast<std::size_t>(impl_->result.options.studies);
    const unsigned threads = std::max(1U, impl_->result.options.threads);
    std::vector<std::vector<PowerCounts>> counts(threads, std::vector<PowerCounts>(sizes.size()));
    takeInTurn(
        studies, threads, [&](unsigned thread) { return Impl::Worker(*impl_, sizes, counts[thread]); },
        progress);
    for (std::size_t i = 0; i < sizes.size(); ++i) {
        PowerCounts sum;
        for (const auto& of_thread : counts) sum.add(of_thread[i]);
        impl_->take(sizes[i], sum);
    }
}

Proportion PowerResult::share(int count) const {
    return proportion(count, options.studies, options.level, std::nullopt);
}

std::optional<int> participantsFor(const PowerResult& result, const ContrastPower& contrast, double goal) {
    for (const auto& [participants, found] : contrast.found)
        if (*result.share(found.either()).estimate >= goal) return participants;
    return std::nullopt;
}

void searchParticipants(PowerAnalysis& analysis, double goal, const PowerProgress& progress) {
    for (;;) {
        const PowerResult& result = analysis.result();
        std::set<int> between;
        for (const ContrastPower& contrast : result.contrasts) {
            const auto enough = participantsFor(result, contrast, goal);
            if (!enough) continue;
            const auto at = std::lower_bound(result.participants.begin(), result.participants.end(), *enough);
            // A single participant can never be enough for a test.
            const int too_few = at == result.participants.begin() ? 1 : *(at - 1);
            if (*enough - too_few > 1) between.insert(too_few + (*enough - too_few) / 2);
        }
        if (between.empty()) return;
        analysis.simulate({between.begin(), between.end()}, progress);
    }
}

}  // namespace deixis::results
