#include "studies/simulation/simulated_participant.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "core/random.hpp"
#include "simulated_author.hpp"
#include "simulated_boards.hpp"
#include "simulated_choice.hpp"
#include "simulated_hand.hpp"
#include "simulated_placing.hpp"
#include "simulated_rater.hpp"
#include "simulated_watching.hpp"

namespace deixis::studies {

namespace {

constexpr double look_away_s = 0.3;       ///< after an answer: until then it does not watch the avatar
constexpr double effect_s = 0.1;          ///< after a press: until then it waits for what comes of it
constexpr double drag_share = 0.5;        ///< of sliders are dragged into place after the first press
constexpr double drag_range_share = 0.2;  ///< of its range a slider is at first off at most
constexpr const char* text_answer = "simulated answer";

/// What the frame asks of whoever sees it.
enum class Situation : unsigned char { watching, board, choosing };

bool anyBall(const PresentedFrame& frame, BallLook look) {
    return std::any_of(frame.balls.begin(), frame.balls.end(),
                       [look](const BallView& ball) { return ball.look == look; });
}

/// A single ball beside a board that is to be confirmed is to be put somewhere; else it is to be chosen.
bool placesBall(const PresentedFrame& frame) {
    return frame.balls.size() == 1 && frame.panel &&
           std::any_of(frame.panel->buttons.begin(), frame.panel->buttons.end(),
                       [](const PanelButton& one) { return one.role == ButtonRole::go_on; });
}

Situation situationOf(const PresentedFrame& frame, const BoardReading& board) {
    if (board.open()) return Situation::board;
    const bool answered = anyBall(frame, BallLook::chosen) || anyBall(frame, BallLook::revealed);
    if (!answered && (anyBall(frame, BallLook::selectable) || anyBall(frame, BallLook::hovered)))
        return Situation::choosing;
    if (board.go_on != nullptr || !board.plays.empty()) return Situation::board;
    return Situation::watching;
}

}  // namespace

struct SimulatedParticipant::State {
    State(const SimulatedParameters& given, const motion::Skeleton& avatar, std::uint64_t seed,
          bool has_keyboard)
        : parameters(given),
          keyboard(has_keyboard),
          head_joint(motion::mapByVrmNames(avatar)[motion::Bone::head]),
          traits(given, seed),
          rater(given, traits, seed),
          watcher(avatar, given.observer.reading, rater),
          chooser(traits.observer, seed),
          placer(traits.observer, seed),
          author(seed),
          reactions(seed, "reactions"),
          sliding(seed, "sliding") {}

    SimulatedParameters parameters;
    bool keyboard;
    int head_joint;
    Traits traits;
    SimulatedRater rater;
    Watcher watcher;
    BallChooser chooser;
    BallPlacer placer;
    SimulatedAuthor author;
    Random reactions, sliding;

    Situation situation = Situation::watching;
    double since_s = 0.0;
    std::vector<int> board_parts;      ///< of the board seen last
    std::optional<BallChoice> choice;  ///< among the balls that are open
    std::optional<double> margin_rad;  ///< of the choice just made, until it has said how sure it is
    std::optional<double> felt_confidence;

    DecidedAnswers decided;
    SimulatedHand hand;
    std::optional<std::size_t> play_to_press;
    bool leaves_page = false;
    std::string to_type;
    int to_erase = 0;
    double not_before_s = 0.0;  ///< it decides on nothing sooner

    SimulatedHead head;
    Pose stage_from_viewer{};

    [[nodiscard]] Vec3 eyes() const {
        return stage_from_viewer.position + Vec3(0.0, parameters.eye_height_m, 0.0);
    }

    double reactionTime() {
        const double mean = parameters.reaction_mean_s;
        const double variation = parameters.reaction_sd_s / mean;
        const double variance = std::log1p(variation * variation);
        return std::exp(std::log(mean) - variance / 2.0 + std::sqrt(variance) * reactions.normal());
    }

    void see(const PresentedFrame& frame, double time_s) {
        stage_from_viewer = frame.stage_from_viewer;
        if (frame.state == PresentedState::authoring) {
            author.see(frame, time_s);
            situation = Situation::watching;
            since_s = time_s;
            dropPlan();
            return;
        }
        const BoardReading board = frame.panel ? readBoard(*frame.panel) : BoardReading{};
        if (watcher.expecting()) {
            if (watcher.watchPlay(frame, board, time_s)) {
                decided.forget();
                not_before_s = time_s;
            }
        } else {
            watchOrAnswer(frame, board, time_s);
        }
        lookAround(frame, board, time_s);
    }

    void dropPlan() {
        hand.drop();
        play_to_press.reset();
        leaves_page = false;
    }

    void watchOrAnswer(const PresentedFrame& frame, const BoardReading& board, double time_s) {
        const Situation now = situationOf(frame, board);
        if (now == situation && board.parts != board_parts) {
            dropPlan();  // what it was about to press is gone
            not_before_s = time_s;
        }
        board_parts = board.parts;
        if (now != situation) {
            situation = now;
            since_s = time_s;
            dropPlan();
            choice.reset();
            placer.forget();
            if (now == Situation::watching) {
                watcher.forget();
                decided.forget();
            }
            not_before_s = time_s;
        }
        if (board.plays.empty()) watcher.forgetPlays();
        if (now == Situation::watching) {
            const bool watches = time_s - since_s >= look_away_s;
            // What it had chosen is past when the next movement is on.
            const bool another = anyBall(frame, BallLook::waiting) && !anyBall(frame, BallLook::chosen);
            if (another || (watches && frame.balls.empty())) margin_rad.reset();
            watcher.readSign(frame);
            if (watches) watcher.watch(frame, time_s);
        } else if (!hand.busy() && time_s >= not_before_s) {
            if (now == Situation::choosing && placesBall(frame))
                placeBall(frame, board, time_s);
            else if (now == Situation::choosing)
                chooseBall(frame, time_s);
            else
                answerBoard(frame, board, time_s);
        }
    }

    // Answering.

    void chooseBall(const PresentedFrame& frame, double time_s) {
        if (!choice) {
            const double bias_rad = radiansFromDegrees(parameters.elevation_bias_deg);
            choice = chooser.choose({raised(watcher.gesture().lines, bias_rad), eyes()}, frame.balls);
        }
        margin_rad = choice->margin_rad;
        felt_confidence.reset();
        hand.press(aimAtBall(frame, choice->place), frame.balls[choice->place].centre,
                   time_s + reactionTime());
    }

    /// A single ball is to be put somewhere, until the board is confirmed.
    void placeBall(const PresentedFrame& frame, const BoardReading& board, double time_s) {
        const double bias_rad = radiansFromDegrees(parameters.elevation_bias_deg);
        const SeenArm arm{raised(watcher.gesture().lines, bias_rad), eyes()};
        if (!placer.plan(frame, arm, hand, time_s + reactionTime()) && board.go_on != nullptr)
            pressButton(frame, *board.go_on, time_s);
    }

    void answerBoard(const PresentedFrame& frame, const BoardReading& board, double time_s) {
        const Ask* const ask = nextAsk(board);
        if (ask != nullptr) {
            answer(frame, board, *ask, time_s);
        } else if (const auto play = nextPlay(board, board.go_on == nullptr)) {
            play_to_press = play;
            pressButton(frame, *board.plays[*play], time_s);
        } else if (board.go_on != nullptr) {
            leaves_page = true;
            pressButton(frame, *board.go_on, time_s);
        }
    }

    /// The first thing that it can answer and has not. Of a movement it must have seen that, and of a pair
    /// both.
    const Ask* nextAsk(const BoardReading& board) const {
        for (const Ask& ask : board.asks) {
            if (!ask.enabled || decided.done(ask)) continue;
            const bool typed = ask.kind == AskKind::text || ask.kind == AskKind::number;
            if (typed && !keyboard && ask.buttons.empty()) continue;
            const bool seen = board.plays.empty() ||
                              (board.pair() ? watcher.sawAll(board) : watcher.timesSeen(ask.number) > 0);
            if (seen) return &ask;
        }
        return nullptr;
    }

    /// A movement that it has not seen; `again`: else one that it has seen least often, should the board
    /// still wait for one.
    std::optional<std::size_t> nextPlay(const BoardReading& board, bool again) const {
        std::optional<std::size_t> next;
        int min = 0;
        for (std::size_t i = 0; i < board.plays.size(); ++i) {
            const int times = watcher.timesSeen(i);
            if (!board.plays[i]->enabled || (times > 0 && !again) || (next && times >= min)) continue;
            next = i;
            min = times;
        }
        return next;
    }

    void answer(const PresentedFrame& frame, const BoardReading& board, const Ask& ask, double time_s) {
        switch (ask.kind) {
            case AskKind::options: {
                const auto known = decided.values.try_emplace(ask.id, 0);
                if (known.second) known.first->second = static_cast<int>(chosenOption(board, ask));
                const auto place = static_cast<std::size_t>(known.first->second);
                pressButton(frame, *ask.buttons[std::min(place, ask.buttons.size() - 1)], time_s);
                break;
            }
            case AskKind::slider: {
                const auto known = decided.values.try_emplace(ask.id, 0);
                if (known.second)
                    known.first->second = valueFor(board, ask, ask.slider->low, ask.slider->high);
                slide(frame, *ask.slider, known.first->second, time_s);
                break;
            }
            case AskKind::number:
            case AskKind::text:
                type(frame, ask, time_s);
                break;
        }
    }

    int valueFor(const BoardReading& board, const Ask& ask, int low, int high) {
        if (!ask.of_movement) return onScale(rater.questionnaireAnswer(), low, high);
        if (!board.plays.empty()) return watcher.impressionOf(ask.number).on(low, high);
        if (margin_rad) {
            if (!felt_confidence) felt_confidence = rater.confidence(*margin_rad);
            return onScale(*felt_confidence, low, high);
        }
        return watcher.impression().on(low, high);
    }

    std::size_t chosenOption(const BoardReading& board, const Ask& ask) {
        const std::size_t count = ask.buttons.size();
        if (board.pair())
            return preference(parameters, watcher.impressionOf(0).judgement,
                              watcher.impressionOf(1).judgement, count);
        if (isNumbered(ask.buttons)) {
            const int low = *numberOn(*ask.buttons.front());
            const int value = valueFor(board, ask, low, *numberOn(*ask.buttons.back()));
            return static_cast<std::size_t>(value - low);
        }
        if (!ask.of_movement && !isScale(ask.buttons)) return rater.anyOption(count);
        return static_cast<std::size_t>(valueFor(board, ask, 0, static_cast<int>(count) - 1));
    }

    // Moving the hand.

    void pressAt(const PresentedFrame& frame, const PanelRect& box, double time_s) {
        const Vec3 centre = pointOnPanel(*frame.panel, box.x + box.width / 2.0, box.y + box.height / 2.0);
        hand.press(aimAtBoard(frame, centre), centre, time_s + reactionTime());
    }

    void pressButton(const PresentedFrame& frame, const PanelButton& button, double time_s) {
        pressAt(frame, button.box, time_s);
    }

    void slide(const PresentedFrame& frame, const PanelSlider& slider, int value, double time_s) {
        const PanelRect track = slider.track();
        const double range = std::max(1.0, static_cast<double>(slider.high - slider.low));
        const auto at = [&](double share) {
            return pointOnPanel(*frame.panel, track.x + std::clamp(share, 0.0, 1.0) * track.width,
                                track.y + track.height / 2.0);
        };
        const double share = (value - slider.low) / range;
        const bool drags = sliding.uniform() < drag_share;
        const double off = sliding.uniform(-drag_range_share, drag_range_share);
        const double press_at_s = time_s + reactionTime();
        const Vec3 goal = at(share);
        if (!drags) {
            hand.press(aimAtBoard(frame, goal), goal, press_at_s);
            return;
        }
        const Vec3 first = at(share + off);
        hand.drag(aimAtBoard(frame, first), aimAtBoard(frame, goal), goal, press_at_s);
    }

    void type(const PresentedFrame& frame, const Ask& ask, double time_s) {
        const auto known = decided.texts.try_emplace(ask.id, text_answer);
        std::string& wanted = known.first->second;
        if (known.second && ask.kind == AskKind::number)
            wanted = numberFor(*ask.field, (rater.questionnaireAnswer() - 1.0) / 4.0);
        if (!ask.buttons.empty()) {
            const PanelButton* const key = nextKey(ask, wanted);
            if (key != nullptr) pressButton(frame, *key, time_s);
        } else if (ask.field->active) {
            if (ask.field->text.empty())
                to_type = wanted;
            else
                to_erase = static_cast<int>(ask.field->text.size());
            not_before_s = time_s + effect_s;
        } else {
            pressAt(frame, ask.field->box, time_s);
        }
    }

    /// Eyes on what it is about to press, on the board, or between the avatar and the balls.
    void lookAround(const PresentedFrame& frame, const BoardReading& board, double time_s) {
        const bool page = board.plays.empty() && std::none_of(board.asks.begin(), board.asks.end(),
                                                              [](const Ask& ask) { return ask.of_movement; });
        const bool reads = situation == Situation::board && page;
        const auto pressed = hand.lookedAt(time_s);
        const Vec3 towards = pressed ? *pressed : placeToLook(frame, eyes(), head_joint, reads);
        head.turn(frame, eyes(), towards, time_s);
    }

    InputFrame act(double time_s) {
        InputFrame input;
        input.time_s = time_s;
        input.utc_s = time_s;
        input.stage_from_head = {eyes(), head.orientation()};
        input.typed = std::exchange(to_type, {});
        input.erased = std::exchange(to_erase, 0);
        if (hand.act(stage_from_viewer, input)) pressed(time_s);
        input.farther_m = placer.farther_m(hand, input);
        input.work = author.tell(time_s);
        input.notes = author.takeNotes();
        return input;
    }

    void pressed(double time_s) {
        // Should the press not take, it decides again, and the same.
        not_before_s = time_s + effect_s;
        if (play_to_press) {
            watcher.expect(*play_to_press, time_s);
            play_to_press.reset();
        } else if (leaves_page) {
            decided.forget();
            watcher.forgetPlays();
        }
        leaves_page = false;
    }
};

SimulatedParticipant::SimulatedParticipant(const SimulatedParameters& parameters,
                                           const motion::Skeleton& avatar, std::uint64_t seed, bool keyboard)
    : state_(std::make_unique<State>(parameters, avatar, seed, keyboard)) {}

SimulatedParticipant::~SimulatedParticipant() = default;
SimulatedParticipant::SimulatedParticipant(SimulatedParticipant&&) noexcept = default;

void SimulatedParticipant::see(const PresentedFrame& frame, double time_s) {
    state_->see(frame, time_s);
}

InputFrame SimulatedParticipant::act(double time_s) {
    return state_->act(time_s);
}

}  // namespace deixis::studies
