#include "timeline.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <limits>
#include <stdexcept>
#include <utility>

#include "studies/study_file/stage_kind.hpp"

namespace deixis::studies {

namespace {

bool isPage(const Stage& stage) {
    return !declarationOf(stage.kind).answered;
}

const Stage& stageOf(const Study& study, std::string_view name) {
    const Stage* stage = study.findStage(name);
    if (stage == nullptr)
        throw std::invalid_argument(
            fmt::format("the plan names stage '{}', which is not in study '{}'", name, study.name));
    return *stage;
}

/// Place of a trial among those of its stage and attempt, from 0, and how many these are.
std::pair<int, int> placeInStage(const StudyPlan& plan, const Trial& trial) {
    std::pair<int, int> place{0, 0};
    for (const Trial& one : plan.trials) {
        if (one.stage != trial.stage || one.attempt != trial.attempt) continue;
        if (one.index < trial.index) ++place.first;
        ++place.second;
    }
    return place;
}

}  // namespace

PresentedState pageState(PageKind kind) {
    switch (kind) {
        case PageKind::instructions:
            return PresentedState::instructions;
        case PageKind::rest:
            return PresentedState::rest;
        case PageKind::welcome_back:
            return PresentedState::welcome_back;
        case PageKind::practice_again:
            return PresentedState::practice_again;
        case PageKind::attention:
            return PresentedState::attention;
        case PageKind::closing:
            return PresentedState::closing;
    }
    throw std::logic_error("a page without a kind");
}

std::vector<Attempt> practiceAttempts(const StudyPlan& plan, const Stage& stage,
                                      const std::map<int, bool>& answered) {
    std::vector<Attempt> attempts;
    for (const Trial& trial : plan.trials) {
        if (trial.stage != stage.name) continue;
        const auto number = static_cast<std::size_t>(trial.attempt);
        if (attempts.size() <= number) attempts.resize(number + 1);
        ++attempts[number].trials;
        const auto found = answered.find(trial.index);
        if (found == answered.end()) continue;
        ++attempts[number].answered;
        if (found->second) ++attempts[number].correct;
    }
    return attempts;
}

const Stage& taskOf(const Study& study, const Stage& stage) {
    return stage.practice ? stageOf(study, stage.practice->of) : stage;
}

std::pair<std::string, std::string> titledText(const std::string& text, const std::string& otherwise) {
    constexpr std::size_t longest_title = 60;
    const std::size_t stop = text.find("\n\n");
    if (stop == std::string::npos || stop > longest_title) return {otherwise, text};
    return {text.substr(0, stop), text.substr(stop + 2)};
}

std::vector<int> trialsLeft(const Study& study, const StudyPlan& plan, const std::map<int, bool>& answered) {
    std::set<std::string> begun;
    for (const Trial& trial : plan.trials)
        if (answered.count(trial.index) > 0) begun.insert(trial.stage);
    std::map<std::string, int> attempts_wanted;  // by practice stage
    const auto wanted = [&](const Trial& trial) {
        if (!trial.practice) return true;
        const auto known = attempts_wanted.find(trial.stage);
        if (known != attempts_wanted.end()) return trial.attempt < known->second;
        const Stage& stage = stageOf(study, trial.stage);
        const double criterion = stage.practice ? stage.practice->criterion : 0.0;
        int count = 0;
        if (!stage.practice || begun.count(stage.practice->of) == 0) {
            count = std::numeric_limits<int>::max();
            const std::vector<Attempt> attempts = practiceAttempts(plan, stage, answered);
            for (std::size_t i = attempts.size(); i-- > 0;)
                if (attempts[i].met(criterion)) count = static_cast<int>(i) + 1;
        }
        attempts_wanted.emplace(trial.stage, count);
        return trial.attempt < count;
    };
    std::vector<int> left;
    int visit = std::numeric_limits<int>::max();
    for (const Trial& trial : plan.trials) {
        if (answered.count(trial.index) > 0 || !wanted(trial)) continue;
        const int session = stageOf(study, trial.stage).session;
        if (session > visit) continue;
        if (session < visit) left.clear();
        visit = session;
        left.push_back(trial.index);
    }
    return left;
}

Timeline::Timeline(const Study& study, const StudyPlan& plan, std::map<int, bool> answered, double gap_s)
    : study_(study), plan_(plan), answered_(std::move(answered)), gap_s_(gap_s) {
    for (const std::string& name : plan.stages) stages_.push_back(&stageOf(study, name));
    for (const Trial& trial : plan.trials) {
        const Stage& stage = stageOf(study, trial.stage);
        if (std::find(stages_.begin(), stages_.end(), &stage) == stages_.end())
            throw std::invalid_argument(fmt::format("trial {} is in stage '{}', which the plan does not list",
                                                    trial.index, trial.stage));
        (void)taskOf(study, stage);
        (void)layoutOf(trial);
        with_trials_.insert(trial.stage);
    }
    const std::vector<int> left = trialsLeft(study, plan, answered_);
    if (!left.empty()) {
        const Stage& stage = stageOf(study, plan.trials[static_cast<std::size_t>(left.front())].stage);
        visit_ = stage.session;
        if (begun(stage)) begun_at_start_ = stage.name;
        welcomes_back_ = std::any_of(answered_.begin(), answered_.end(), [this](const auto& one) {
            return stageOf(study_, plan_.trials[static_cast<std::size_t>(one.first)].stage).session == visit_;
        });
    } else {
        for (const Stage* stage : stages_) visit_ = std::max(visit_, stage->session);
    }
}

bool Timeline::begun(const Stage& stage) const {
    return std::any_of(plan_.trials.begin(), plan_.trials.end(), [&](const Trial& trial) {
        return trial.stage == stage.name && answered_.count(trial.index) > 0;
    });
}

void Timeline::answer(int trial, bool correct) {
    answered_[trial] = correct;
    last_answered_ = trial;
}

const Trial* Timeline::nextTrial() const {
    const std::vector<int> left = trialsLeft(study_, plan_, answered_);
    if (left.empty()) return nullptr;
    const Trial& trial = plan_.trials[static_cast<std::size_t>(left.front())];
    return stageOf(study_, trial.stage).session == visit_ ? &trial : nullptr;
}

const Layout& Timeline::layoutOf(const Trial& trial) const {
    if (trial.layout.empty()) return anyLayout();
    const Layout* layout = study_.findLayout(trial.layout);
    if (layout == nullptr)
        throw std::invalid_argument(
            fmt::format("trial {} of the plan has the layout '{}', which is not in study '{}'", trial.index,
                        trial.layout, study_.name));
    return *layout;
}

/// A page already stands where the next trial is, so that the person has moved before it starts.
const Layout& Timeline::layoutAt(const Trial* next) const {
    if (next != nullptr) return layoutOf(*next);
    return plan_.trials.empty() ? anyLayout() : layoutOf(plan_.trials.back());
}

/// Of a study that asks questions alone.
const Layout& Timeline::anyLayout() const {
    static const Layout before_the_avatar{"before the avatar", 0.0, 3.4, 180.0};
    return study_.layouts.empty() ? before_the_avatar : study_.layouts.front();
}

std::size_t Timeline::placeOf(std::string_view stage) const {
    std::size_t place = 0;
    while (stages_[place]->name != stage) ++place;
    return place;
}

/// The pages that stand directly before a stage of this visit, or before the end (`stage` is one past the
/// last).
std::vector<const Stage*> Timeline::pagesBefore(std::size_t stage) const {
    std::vector<const Stage*> pages;
    while (stage-- > 0) {
        const Stage& one = *stages_[stage];
        if (one.session != visit_ && pages.empty() && one.session > visit_) continue;
        if (one.session != visit_ || with_trials_.count(one.name) > 0) break;
        if (isPage(one)) pages.push_back(&one);
    }
    std::reverse(pages.begin(), pages.end());
    return pages;
}

/// Pages of a stage that has begun are not shown again, but for the instructions where the visit continues in
/// it after a long time.
std::vector<const Stage*> Timeline::pagesFor(const Trial& trial) const {
    const std::size_t place = placeOf(trial.stage);
    if (!begun(*stages_[place])) return pagesBefore(place);
    if (trial.stage != begun_at_start_ || gap_s_ <= study_.instructions_again_after_s) return {};
    std::vector<const Stage*> pages = pagesBefore(place);
    // Practice stands between a stage and its instructions.
    for (std::size_t i = 0; i < place; ++i) {
        const Stage& before = *stages_[i];
        if (!before.practice || before.practice->of != trial.stage || before.session != visit_) continue;
        const std::vector<const Stage*> more = pagesBefore(i);
        pages.insert(pages.begin(), more.begin(), more.end());
    }
    pages.erase(std::remove_if(pages.begin(), pages.end(),
                               [](const Stage* page) { return declarationOf(page->kind).is_break; }),
                pages.end());
    return pages;
}

/// The break or the word before a further attempt that comes before a trial.
std::optional<TimelinePage> Timeline::pageFor(const Trial& trial) const {
    const Stage& stage = *stages_[placeOf(trial.stage)];
    const LanguageTable& words = study_.words;
    const int place = placeInStage(plan_, trial).first;
    const std::string name = fmt::format("{} {}.{}", stage.name, trial.attempt, place);
    if (!unread(name)) return std::nullopt;
    if (stage.practice) {
        if (trial.attempt == 0 || place > 0) return std::nullopt;
        const std::string& text = stage.practice->again_text;
        auto [title, body] =
            titledText(text.empty() ? words("practice_again_text") : text, words("practice_again_title"));
        return TimelinePage{PageKind::practice_again, name, false, title, body, "", words("continue"), 0.0};
    }
    // Breaks follow the place in the stage, so that they fall where they would have without a resume.
    const bool due = stage.break_every > 0 && place > 0 && place % stage.break_every == 0;
    const bool came_from_here =
        last_answered_ && plan_.trials[static_cast<std::size_t>(*last_answered_)].stage == stage.name;
    if (!due || !came_from_here) return std::nullopt;
    auto [title, body] =
        titledText(stage.break_text.empty() ? words("break_text") : stage.break_text, words("break_title"));
    return TimelinePage{PageKind::rest,       name, false, title, body, "", words("continue"),
                        stage.break_minimum_s};
}

TimelinePage Timeline::stagePage(const Stage& stage, bool last) const {
    const LanguageTable& words = study_.words;
    const bool rest = declarationOf(stage.kind).is_break;
    std::string otherwise = words(rest ? "break_title" : last ? "thank_you_title" : "instructions_title");
    if (!rest && !last && &stage == stages_.front() && !study_.title.empty()) otherwise = study_.title;
    auto [title, body] = titledText(rest && stage.text.empty() ? words("break_text") : stage.text, otherwise);
    return {rest ? PageKind::rest : PageKind::instructions,
            stage.name,
            true,
            title,
            body,
            stage.emphasis,
            words(last ? "finish" : "continue"),
            stage.minimum_s};
}

/// The question of a begun stage reminds of the task.
TimelinePage Timeline::welcomeBack(const Trial& trial) const {
    const Stage& stage = *stages_[placeOf(trial.stage)];
    return {PageKind::welcome_back,
            std::string(presentedStateName(PresentedState::welcome_back)),
            false,
            study_.words("welcome_back_title"),
            study_.words("welcome_back_text"),
            begun(stage) ? taskOf(study_, stage).question : "",
            study_.words("continue"),
            0.0};
}

TimelineItem Timeline::pageItem(TimelinePage page, const Stage* stage, const Trial* next) const {
    TimelineItem item;
    item.stage = stage;
    item.status.part = stage != nullptr ? stage->name : std::string(presentedStateName(pageState(page.kind)));
    if (stage != nullptr && page.kind != PageKind::instructions && !isPage(*stage))
        item.status.remark = presentedStateName(pageState(page.kind));
    item.page = std::move(page);
    item.layout = &layoutAt(next);
    return item;
}

TimelineItem Timeline::trialItem(const Trial& trial) const {
    TimelineItem item;
    item.trial = &trial;
    item.stage = stages_[placeOf(trial.stage)];
    item.layout = &layoutOf(trial);
    const auto [place, of] = placeInStage(plan_, trial);
    item.status = {trial.stage, static_cast<int>(place) + 1, static_cast<int>(of)};
    return item;
}

/// The end's own page: the study's where it has one, else the program's.
std::optional<TimelineItem> Timeline::closingItem() const {
    const LanguageTable& words = study_.words;
    const std::string name(presentedStateName(PresentedState::closing));
    if (!closing_) {
        const std::vector<const Stage*> pages = pagesBefore(stages_.size());
        for (const Stage* page : pages)
            if (unread(*page)) return pageItem(stagePage(*page, page == pages.back()), page, nullptr);
        if (!pages.empty()) return std::nullopt;
    }
    if (!unread(name)) return std::nullopt;
    const bool more = std::any_of(stages_.begin(), stages_.end(),
                                  [this](const Stage* stage) { return stage->session > visit_; });
    std::string title = words("thank_you_title");
    std::string body = words(more ? "session_over_text" : "thank_you_text");
    if (closing_) {
        const std::string why = *closing_ == SessionOutcome::declined ? "declined"
                                : *closing_ == SessionOutcome::quit   ? "stopped"
                                                                      : "excluded";
        title = words(why + "_title");
        body = words(why + "_text");
    }
    return pageItem({PageKind::closing, name, false, title, body, "", words("finish"), 0.0}, nullptr,
                    nullptr);
}

std::optional<TimelineItem> Timeline::next() {
    if (closing_) return closingItem();
    const LanguageTable& words = study_.words;
    const Trial* trial = nextTrial();
    if (std::exchange(warning_, false)) {
        const Stage* stage =
            last_answered_ ? stages_[placeOf(plan_.trials[static_cast<std::size_t>(*last_answered_)].stage)]
                           : nullptr;
        return pageItem(
            {PageKind::attention, std::string(presentedStateName(PresentedState::attention)), false,
             words("attention_title"), words("attention_text"), "", words("continue"), 0.0},
            stage, trial);
    }
    if (trial == nullptr) return closingItem();
    // A consent that is asked again comes before all else.
    const bool consent = declarationOf(trial->kind).asks_consent;
    if (welcomes_back_ && !consent && unread(std::string(presentedStateName(PresentedState::welcome_back))))
        return pageItem(welcomeBack(*trial), nullptr, trial);
    for (const Stage* page : pagesFor(*trial))
        if (unread(*page)) return pageItem(stagePage(*page, false), page, trial);
    if (std::optional<TimelinePage> page = pageFor(*trial))
        return pageItem(std::move(*page), stages_[placeOf(trial->stage)], trial);
    return trialItem(*trial);
}

const Stage* Timeline::failedPractice() const {
    for (const Stage* stage : stages_) {
        if (!stage->practice || !stage->practice->end_if_failed || stage->session != visit_) continue;
        const std::vector<Attempt> attempts = practiceAttempts(plan_, *stage, answered_);
        const double criterion = stage->practice->criterion;
        const bool failed =
            !attempts.empty() && std::all_of(attempts.begin(), attempts.end(), [&](const Attempt& one) {
                return one.complete() && !one.met(criterion);
            });
        if (failed && !begun(taskOf(study_, *stage))) return stage;
    }
    return nullptr;
}

double Timeline::share() const {
    int of = 0;
    int done = 0;
    for (const Trial& trial : plan_.trials) {
        if (trial.practice || stageOf(study_, trial.stage).session != visit_) continue;
        ++of;
        if (answered_.count(trial.index) > 0) ++done;
    }
    return of > 0 ? static_cast<double>(done) / of : 1.0;
}

std::vector<StageProgress> Timeline::progress(std::string_view current) const {
    std::vector<StageProgress> progress;
    for (const Stage* stage : stages_) {
        StageProgress one{stage->name, 0, 0, stage->name == current};
        for (const Trial& trial : plan_.trials) {
            if (trial.stage != stage->name) continue;
            const bool done = answered_.count(trial.index) > 0;
            if (done) ++one.done;
            // Further attempts at a practice are counted once they have begun.
            if (!trial.practice || trial.attempt == 0 || done) ++one.of;
        }
        if (with_trials_.count(stage->name) == 0 && !unread(*stage)) one.done = 1;
        progress.push_back(std::move(one));
    }
    return progress;
}

}  // namespace deixis::studies
