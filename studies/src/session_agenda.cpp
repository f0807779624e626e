#include "session_agenda.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace deixis::studies {

namespace {

/// What the two stages have in common, for the agenda.
struct StageTexts {
    StageKind kind;
    const char* name;
    const char* part;
    int break_every;
    const std::string& question;
    const std::string& instructions;
    const std::string& practice_instructions;
};

std::vector<const Trial*> trialsOf(const StudyPlan& plan, StageKind stage, bool practice) {
    std::vector<const Trial*> trials;
    for (const Trial& trial : plan.trials)
        if (trial.stage == stage && trial.practice == practice) trials.push_back(&trial);
    return trials;
}

/// A short first paragraph of a text is its title.
AgendaPage titledPage(PageKind kind, const char* otherwise, const std::string& text) {
    constexpr std::size_t longest_title = 60;
    const std::size_t stop = text.find("\n\n");
    if (stop == std::string::npos || stop > longest_title) return {kind, otherwise, text};
    return {kind, text.substr(0, stop), text.substr(stop + 2)};
}

class AgendaBuilder {
  public:
    AgendaBuilder(const Study& study, const StudyPlan& plan, const std::set<int>& answered)
        : study_(study), plan_(plan), answered_(answered) {}

    std::vector<AgendaItem> build() {
        const StageTexts stages[] = {
            {StageKind::naturalness, "naturalness", "Part 1", study_.rating.break_every,
             study_.rating.question, study_.rating.instructions, study_.rating.practice_instructions},
            {StageKind::game, "game", "Part 2", study_.game.break_every, study_.game.question,
             study_.game.instructions, study_.game.practice_instructions}};

        const bool anything_left = std::any_of(plan_.trials.begin(), plan_.trials.end(),
                                               [this](const Trial& trial) { return open(trial); });
        const bool begun = std::any_of(plan_.trials.begin(), plan_.trials.end(), [this](const Trial& trial) {
            return !trial.practice && answered_.count(trial.index) > 0;
        });
        if (!begun) {
            page({PageKind::welcome, study_.title.empty() ? "Welcome" : study_.title, study_.welcome});
        } else if (anything_left) {
            page({PageKind::welcome_back, "Welcome back",
                  "You go on where you stopped. Your earlier answers are kept.",
                  questionOfBegunStage(stages[0], stages[1])});
        }
        for (const StageTexts& stage : stages) addStage(stage);
        page({PageKind::goodbye, "Thank you", study_.goodbye, "", "Finish"});
        placeAll();
        return std::move(items_);
    }

  private:
    const Study& study_;
    const StudyPlan& plan_;
    const std::set<int>& answered_;
    std::vector<AgendaItem> items_;

    [[nodiscard]] bool open(const Trial& trial) const {
        return !trial.practice && answered_.count(trial.index) == 0;
    }

    /// Somebody who comes back into a stage reads no instructions again: the question reminds of the task.
    [[nodiscard]] std::string questionOfBegunStage(const StageTexts& first, const StageTexts& second) const {
        for (const StageTexts* stage : {&first, &second}) {
            const auto trials = trialsOf(plan_, stage->kind, false);
            const auto left = std::count_if(trials.begin(), trials.end(),
                                            [this](const Trial* trial) { return open(*trial); });
            if (left == 0) continue;
            return left < static_cast<std::ptrdiff_t>(trials.size()) ? stage->question : "";
        }
        return "";
    }

    void page(AgendaPage content) {
        AgendaItem item;
        item.status = content.title;
        item.page = std::move(content);
        items_.push_back(std::move(item));
    }

    void trial(const Trial& trial, std::string status) {
        AgendaItem item;
        item.trial = &trial;
        item.status = std::move(status);
        items_.push_back(std::move(item));
    }

    void addStage(const StageTexts& stage) {
        const auto scored = trialsOf(plan_, stage.kind, false);
        const auto left =
            std::count_if(scored.begin(), scored.end(), [this](const Trial* one) { return open(*one); });
        if (left == 0) return;
        const std::size_t first_item = items_.size();
        const bool begun = left < static_cast<std::ptrdiff_t>(scored.size());
        if (!begun) addIntroduction(stage);
        addScored(stage, scored, left);
        items_[first_item].starts_stage = begun ? fmt::format("{}, continued", stage.name) : stage.name;
    }

    void addIntroduction(const StageTexts& stage) {
        AgendaPage instructions = titledPage(PageKind::instructions, stage.part, stage.instructions);
        instructions.emphasis = stage.question;
        page(std::move(instructions));
        const auto practice = trialsOf(plan_, stage.kind, true);
        if (practice.empty()) return;
        page({PageKind::practice, "Practice",
              stage.practice_instructions.empty() ? "First, a few for practice. They do not count."
                                                  : stage.practice_instructions});
        for (std::size_t i = 0; i < practice.size(); ++i)
            trial(*practice[i], fmt::format("{} practice {}/{}", stage.name, i + 1, practice.size()));
        page({PageKind::begin, "Now it counts",
              "The practice is over. From here on your answers are kept. If something is unclear, ask now."});
    }

    void addScored(const StageTexts& stage, const std::vector<const Trial*>& scored, std::ptrdiff_t left) {
        for (std::size_t i = 0; i < scored.size(); ++i) {
            if (!open(*scored[i])) continue;
            trial(*scored[i], fmt::format("{} {}/{}", stage.name, i + 1, scored.size()));
            --left;
            // Breaks follow the place in the stage, so that they fall where they would have without a resume.
            const bool due =
                stage.break_every > 0 && (i + 1) % static_cast<std::size_t>(stage.break_every) == 0;
            if (due && left > 0)
                page({PageKind::rest, "Time for a break",
                      study_.break_text.empty() ? "Rest as long as you like." : study_.break_text});
        }
    }

    [[nodiscard]] const Layout* layoutOf(const Trial& trial) const {
        const Layout* layout = study_.findLayout(trial.layout);
        if (layout == nullptr)
            throw std::invalid_argument(
                fmt::format("trial {} of the plan is laid out '{}', which study '{}' lacks", trial.index,
                            trial.layout, study_.name));
        return layout;
    }

    /// A page already stands where the next trial is, so that the person has moved before it starts.
    void placeAll() {
        const Layout* last = study_.findLayout(study_.rating.layout);
        for (const AgendaItem& item : items_)
            if (item.trial != nullptr) last = layoutOf(*item.trial);
        if (last == nullptr && !study_.layouts.empty()) last = &study_.layouts.front();
        if (last == nullptr) throw std::invalid_argument("study '" + study_.name + "' has no layout");
        for (auto item = items_.rbegin(); item != items_.rend(); ++item) {
            if (item->trial != nullptr) last = layoutOf(*item->trial);
            item->layout = last;
        }
    }
};

}  // namespace

std::string_view pageName(PageKind kind) {
    switch (kind) {
        case PageKind::welcome:
            return "welcome";
        case PageKind::welcome_back:
            return "welcome-back";
        case PageKind::instructions:
            return "instructions";
        case PageKind::practice:
            return "practice";
        case PageKind::begin:
            return "begin";
        case PageKind::rest:
            return "break";
        case PageKind::goodbye:
            return "goodbye";
    }
    return "";
}

std::vector<AgendaItem> buildAgenda(const Study& study, const StudyPlan& plan,
                                    const std::set<int>& answered) {
    return AgendaBuilder(study, plan, answered).build();
}

}  // namespace deixis::studies
