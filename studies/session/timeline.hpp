// What a session goes through in order: which page or trial comes next.
//
// Nothing is laid out in advance. What comes next follows from what has been answered, so that a session that
// broke off, a practice that is done again and a trial that the operator wants repeated all go the same way.
#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "studies/design/plan.hpp"
#include "studies/session/session.hpp"
#include "studies/study_file/study.hpp"

namespace deixis::studies {

enum class PageKind : unsigned char { instructions, rest, welcome_back, practice_again, attention, closing };

[[nodiscard]] PresentedState pageState(PageKind kind);

struct TimelinePage {
    PageKind kind = PageKind::instructions;
    std::string name{};     ///< as notes name it; a page that has been read does not come again
    bool of_study = false;  ///< a stage of its own, which may be called as one of the program's pages is
    std::string title{};
    std::string body{};
    std::string emphasis{};  ///< a line under the body, such as the question
    std::string button{};
    double minimum_s = 0.0;
};

/// A trial, or a page where `trial` is null.
struct TimelineItem {
    const Trial* trial = nullptr;
    const Stage* stage = nullptr;  ///< of both; null: a page outside stages
    TimelinePage page{};
    const Layout* layout =
        nullptr;  ///< where the participant stands; of a page: where the next trial needs it
    SessionStatus status{};
};

/// The trials of one practice attempt.
struct Attempt {
    int trials = 0;
    int answered = 0;
    int correct = 0;
    [[nodiscard]] bool complete() const { return answered == trials; }
    [[nodiscard]] double share() const { return trials > 0 ? static_cast<double>(correct) / trials : 1.0; }
    [[nodiscard]] bool met(double criterion) const { return complete() && share() >= criterion - 1e-9; }
};

/// Attempts 0, 1, ... of a practice stage.
[[nodiscard]] std::vector<Attempt> practiceAttempts(const StudyPlan& plan, const Stage& stage,
                                                    const std::map<int, bool>& answered);

/// What a stage asks: its own, or for practice that of the stage practised.
[[nodiscard]] const Stage& taskOf(const Study& study, const Stage& stage);

/// A short first paragraph of a text is its title, else `otherwise`: title and rest.
[[nodiscard]] std::pair<std::string, std::string> titledText(const std::string& text,
                                                             const std::string& otherwise);

class Timeline {
  public:
    /// Throws std::invalid_argument where the plan names a stage or layout that the study lacks. Both must
    /// outlive the timeline.
    Timeline(const Study& study, const StudyPlan& plan, std::map<int, bool> answered, double gap_s);

    /// What comes now; none: the visit is over. The same again until it has been read or answered, but for
    /// a warning.
    [[nodiscard]] std::optional<TimelineItem> next();

    void read(const TimelinePage& page) { (page.of_study ? read_stages_ : read_).insert(page.name); }
    void answer(int trial, bool correct);
    void supersede(int trial) { answered_.erase(trial); }
    void warn() { warning_ = true; }
    /// What is left is not done: a closing page of that outcome (declined, excluded, or quit where
    /// nothing more can be kept), and the end.
    void close(SessionOutcome outcome) { closing_ = outcome; }
    /// What the visit comes to.
    [[nodiscard]] SessionOutcome closing() const { return closing_.value_or(SessionOutcome::finished); }
    [[nodiscard]] bool closingEarly() const { return closing_.has_value(); }

    [[nodiscard]] const std::map<int, bool>& answered() const { return answered_; }
    [[nodiscard]] bool begun(const Stage& stage) const;  ///< whether a trial of it has been answered
    /// A practice whose last attempt failed, which ends the session; null: none.
    [[nodiscard]] const Stage* failedPractice() const;
    /// Share of this visit's trials that have been answered, practice aside.
    [[nodiscard]] double share() const;
    [[nodiscard]] std::vector<StageProgress> progress(std::string_view current) const;

  private:
    const Study& study_;
    const StudyPlan& plan_;
    std::map<int, bool> answered_;
    double gap_s_;
    int visit_ = 1;  ///< Stage::session
    bool welcomes_back_ = false;
    bool warning_ = false;
    std::optional<SessionOutcome> closing_{};
    std::optional<int> last_answered_{};   ///< in this visit
    std::string begun_at_start_{};         ///< the stage in which the visit goes on; empty: at a new one
    std::set<std::string> read_{};         ///< the program's pages
    std::set<std::string> read_stages_{};  ///< stages that are a page
    std::vector<const Stage*> stages_{};   ///< of the plan, in order
    std::set<std::string> with_trials_{};  ///< names of those that have any

    [[nodiscard]] const Trial* nextTrial() const;
    [[nodiscard]] const Layout& layoutOf(const Trial& trial) const;
    [[nodiscard]] const Layout& layoutAt(const Trial* next) const;
    [[nodiscard]] const Layout& anyLayout() const;
    [[nodiscard]] std::size_t placeOf(std::string_view stage) const;
    [[nodiscard]] bool unread(const std::string& name) const { return read_.count(name) == 0; }
    [[nodiscard]] bool unread(const Stage& page) const { return read_stages_.count(page.name) == 0; }
    [[nodiscard]] std::vector<const Stage*> pagesBefore(std::size_t stage) const;
    [[nodiscard]] std::vector<const Stage*> pagesFor(const Trial& trial) const;
    [[nodiscard]] std::optional<TimelinePage> pageFor(const Trial& trial) const;
    [[nodiscard]] TimelinePage stagePage(const Stage& stage, bool last) const;
    [[nodiscard]] TimelinePage welcomeBack(const Trial& trial) const;
    [[nodiscard]] TimelineItem pageItem(TimelinePage page, const Stage* stage, const Trial* next) const;
    [[nodiscard]] TimelineItem trialItem(const Trial& trial) const;
    [[nodiscard]] std::optional<TimelineItem> closingItem() const;
};

}  // namespace deixis::studies
