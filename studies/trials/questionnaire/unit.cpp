// A page of a questionnaire: shown on as many boards as it needs, kept as one response.
#include <utility>

#include "question_form.hpp"
#include "session_unit.hpp"

namespace deixis::studies {

namespace {

class QuestionnaireUnit : public TrialUnit {
  public:
    QuestionnaireUnit(SessionCore& core, const TimelineItem& item) : TrialUnit(core, item) {
        const Questionnaire& all = stage_.questionnaire;
        int before = 0;  // the participant counts boards
        int boards = 0;
        for (int page = 0; page < all.pages(); ++page) {
            const int count = static_cast<int>(boardsOf(page).size());
            if (page < trial_.page) before += count;
            boards += count;
        }
        for (std::vector<const Question*>& questions : boardsOf(trial_.page)) {
            const bool first = forms_.empty();
            FormSetting setting{first ? all.title : "", first ? all.text : "",
                                before + static_cast<int>(forms_.size()), boards};
            forms_.emplace_back(core, std::move(questions), std::move(setting));
        }
    }

    void enter(const InputFrame& input, bool /*moved*/) override {
        core_.standAlone();
        core_.poser.blendTo(core_.idle, core_.now.time_s);
        core_.view.show(PresentedState::questionnaire);
        if (forms_.empty()) {  // only texts, and no keyboard
            give(input, core_.now.time_s, "");
            complete();
            return;
        }
        open(input);
    }

    void resume(const InputFrame& input, double away_s) override {
        draft_.paused_s += away_s;
        ++draft_.pauses;
        core_.poser.blendTo(core_.idle, core_.now.time_s);
        core_.view.show(PresentedState::questionnaire);
        open(input);
    }

    void step(const InputFrame& input) override {
        const auto left = forms_[board_].step(input);
        if (!left || !onset_known_) return;
        if (board_ + 1 < forms_.size()) {
            ++board_;
            open(input);
            return;
        }
        give(input, left->at_s, left->by);
        for (const QuestionForm& form : forms_)
            for (Answer& answer : form.answers()) draft_.answers.push_back(std::move(answer));
        core_.view.confirmButton(button_id::go_on);
        complete();
    }

    void shown(std::uint64_t frame, const Moment& at) override {
        if (onset_known_ || frame < opened_) return;
        draft_.onset = draft_.motion_end = at;
        onset_known_ = true;
    }

    [[nodiscard]] bool wantsPointer() const override { return !done_; }

  private:
    std::vector<QuestionForm> forms_{};
    std::size_t board_ = 0;
    std::uint64_t opened_ = 0;

    /// The questions of a page of the plan, by boards.
    [[nodiscard]] std::vector<std::vector<const Question*>> boardsOf(int of_plan) const {
        Questionnaire page = stage_.questionnaire;
        page.questions.clear();
        for (const Question* question : stage_.questionnaire.page(of_plan))
            page.questions.push_back(*question);
        auto boards = questionnairePages(page, core_.keyboard, core_.words());
        for (auto& board : boards)
            for (const Question*& question : board) question = stage_.questionnaire.find(question->id);
        return boards;
    }

    void open(const InputFrame& input) {
        if (!onset_known_) opened_ = core_.view.frame.number;
        forms_[board_].open(input);
    }
};

}  // namespace

extern const UnitDeclaration questionnaire_unit{makeUnitOf<QuestionnaireUnit>};

}  // namespace deixis::studies
