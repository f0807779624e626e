"""A scripted person at the desktop: reads boards, answers what they ask, and remembers what was meant."""

import random
import re
from dataclasses import dataclass, field

from hands import Hands, board, button
from hands import field as field_of
from hands import slider as slider_of

# Ids of buttons, sliders and fields: studies/session.hpp.
GO_ON, RESUME, AGREE = 1, 2, 7
FIRST_RATING, FIRST_PLAY, FIRST_SLIDER, FIRST_OPTION, FIRST_FIELD = 101, 201, 301, 1000, 5000

PAGES = ("instructions", "break", "welcome-back", "practice-again", "attention", "closing")
CLIP_S = 60.0  # until a clip that was asked for has ended
WORDS = (
    "It was the hand, 50 % sure", "the arm; then the head!", "Hände über Kreuz", "손을 보았다", "'Nothing' \"special\"",
)


@dataclass
class Meant:
    """What the person meant to answer to one trial."""

    place: int = -1
    ball: tuple = ()  # centre of the ball that was aimed at
    placed: tuple = ()  # where the ball was put
    answers: list = field(default_factory=list)  # Said, in order
    number_shown: dict = field(default_factory=dict)  # stimulus -> what its sign said
    pressed_utc_s: tuple = ()  # from and to, of the press that answered
    by: str = "ray"


@dataclass
class Said:
    """One answer: a slider's value, options picked or a text. `question`: the place on its page."""

    question: int
    value: int = None
    options: tuple = ()
    text: str = None
    stimulus: int = None


class Person:
    def __init__(self, trace, mouse, seed=1):
        self.hands = Hands(trace, mouse)
        self.meant = {}  # by trial
        self.pages = []  # read and left
        self.replayed = 0
        self._random = random.Random(seed)
        self._acts = {page: self._leave_page for page in PAGES} | {
            "consent": self._consent,
            "questionnaire": self._fill_in,
            "reasons": self._fill_in,
            "rating": self._rate,
            "confidence": self._rate,
            "choosing": self._choose,
            "aiming": self._choose,
            "watching": self._watch_and_rate,
            "comparing": self._compare,
            "paused": self._go_on_after_pause,
        }

    def sits_down_again(self, trace, mouse):
        """Another run of the program, the same person."""
        self.hands = Hands(trace, mouse)

    def take_part(self, stop=None):
        """Until the last page was left, or stop(line) says so."""
        trace = self.hands.trace
        while True:
            line = self.hands.look()
            if stop and stop(line):
                return
            if line["state"] == "over" or (line["state"] == "closing" and not trace._alive()):
                return
            act = self._acts.get(line["state"].split("-")[0]) or self._acts.get(line["state"])
            if not (act and act(line)):
                seen = line["frame"]
                self.hands.wait("another frame", lambda now: now["frame"] > seen or now["state"] == "over", 60.0)

    def _by_key(self, share):
        """Whether a key is pressed where one would do, in such a share of cases."""
        return self._random.random() < share

    # Pages. Each act tells whether there was anything to do.

    def _leave_page(self, line):
        go_on = button(line, GO_ON)
        if not go_on or not go_on["enabled"]:
            return False
        before = board(line)

        def left(now):
            return board(now) != before

        if self._by_key(0.4):
            self.hands.press_key(self._random.choice(("Return", "space")), left)
        else:
            self.hands.click_button(GO_ON, left)
        self.pages.append(before[:2])
        return True

    def _go_on_after_pause(self, line):
        self.hands.click_button(RESUME, lambda now: now["state"] != "paused")
        return True

    def _consent(self, line):
        agree = button(line, AGREE)
        if not agree or not agree["enabled"]:
            return False
        at = self.hands.click_button(AGREE)
        self.meant[line["trial"]] = Meant(answers=[Said(0, value=1)], pressed_utc_s=at)
        return True

    # Questions.

    def _fill_in(self, line):
        go_on = button(line, GO_ON)
        parts = [b for b in line["buttons"] if b["role"] == "option"] + line["sliders"] + line["fields"]
        asks = any(part["enabled"] for part in line["buttons"] + line["sliders"])
        if not go_on or not (asks or any(not empty["text"] for empty in line["fields"])):
            return False  # answered, and confirmed
        answered = self.meant.setdefault(line["trial"], Meant())
        before = sum(said.question >= 0 for said in answered.answers)
        questions = sorted({self._question(part["id"]) for part in parts})
        for question in questions:
            said = self._answer(question)
            said.question += before
            answered.answers.append(said)

        def left(now):
            now_go_on = button(now, GO_ON)
            return board(now) != board(line) or not now_go_on or not now_go_on["enabled"]

        self.hands.wait("way on", lambda now: (button(now, GO_ON) or {}).get("enabled"))
        if self._by_key(0.3):
            at, by = self.hands.press_key("Return", left), "key"
        else:
            at, by = self.hands.click_button(GO_ON, left), "ray"
        if line["state"] != "reasons":  # these follow an answer that has its time already
            answered.pressed_utc_s, answered.by = at, by
        return True

    @staticmethod
    def _question(number):
        return number - FIRST_FIELD if number >= FIRST_FIELD else (number - FIRST_OPTION) // 100

    def _answer(self, question):
        line = self.hands.look()
        if slider_of(line, FIRST_FIELD + question):
            return Said(question, value=self._set_slider(FIRST_FIELD + question))
        if field_of(line, FIRST_FIELD + question):
            return Said(question, text=self._type(FIRST_FIELD + question))
        return Said(question, options=self._pick_options(question))

    def _pick_options(self, question):
        first = FIRST_OPTION + 100 * question
        options = [b["id"] for b in self.hands.look()["buttons"] if first <= b["id"] < first + 100]
        one = self._random.choice(options)
        self.hands.pick(one)
        if self._random.random() < 0.4:  # another one too, or rather another one: the board shows which
            another = self._random.choice([o for o in options if o != one])
            self.hands.pick(another)
            if button(self.hands.look(), one)["chosen"]:
                return tuple(sorted((one - first, another - first)))
            one = another
        return (one - first,)

    def _set_slider(self, number, value=None):
        found = slider_of(self.hands.look(), number)
        if value is None:
            value = self._random.randint(found["low"], found["high"])
        self.hands.drag_slider(number, value)
        return value

    def _type(self, number):
        """A number where two are named, the least and the greatest; words elsewhere."""
        ends = re.findall(r"-?\d+", field_of(self.hands.look(), number)["hint"])
        if len(ends) == 2:
            text = str(self._random.randint(int(ends[0]), int(ends[1])))
        else:
            text = self._random.choice(WORDS)
        self.hands.type_into(number, text)
        return text

    # Trials.

    def _steps(self, line):
        return [b for b in line["buttons"] if FIRST_RATING <= b["id"] < FIRST_PLAY]

    def _rate(self, line):
        steps = self._steps(line)
        if not steps or not all(step["enabled"] for step in steps):
            return False
        state = line["state"]
        place = self._random.randrange(len(steps))

        def done(now):
            return now["state"] != state or not any(b["enabled"] for b in now["buttons"])

        confidence = state.startswith("confidence")
        meant = self.meant[line["trial"]] if confidence else Meant()
        label = steps[place]["label"]
        if label.isdigit() and self._by_key(0.3):
            at, by = self.hands.press_key(label, done), "key"
        else:
            at, by = self.hands.click_button(steps[place]["id"], done), "ray"
        meant.answers.append(Said(0, options=(place,)))
        if not confidence:
            meant.pressed_utc_s, meant.by = at, by
        self.meant[line["trial"]] = meant
        return True

    def _choose(self, line):
        if button(line, GO_ON):
            return self._place(line)
        places = list(range(len(line["balls"])))
        self._random.shuffle(places)
        for place in places:
            ball = self.hands.hover_ball(place)
            if ball is not None:
                break
        else:
            raise AssertionError(f"no ball could be aimed at; {self.hands.trace.describe()}")
        at = self.hands.click()
        self.hands.wait("chosen ball", lambda now: not now["state"].startswith(("choosing", "aiming")))
        self.meant[line["trial"]] = Meant(place=place, ball=ball, pressed_utc_s=at)
        return True

    def _place(self, line):
        """Puts the ball somewhere near the avatar, now and then once more, and confirms."""
        for _ in range(1 + (self._random.random() < 0.3)):
            where = (self._random.uniform(-0.8, 0.8), self._random.uniform(0.5, 1.7), self._random.uniform(0.5, 1.5))
            placed = self.hands.carry_ball(where, self._random.choice((-3, 4)))

        def confirmed(now):
            return not now["state"].startswith(("choosing", "aiming"))

        if self._by_key(0.3):
            at, by = self.hands.press_key("Return", confirmed), "key"
        else:
            at, by = self.hands.click_button(GO_ON, confirmed), "ray"
        self.meant[line["trial"]] = Meant(placed=placed, pressed_utc_s=at, by=by)
        return True

    def play(self, stimulus):
        """Watches one clip to its end. The number that its sign showed, or None."""
        number = FIRST_PLAY + stimulus
        state = self.hands.look()["state"]
        self.hands.click_button(number, lambda now: now["state"] != state)
        shown = []

        def over(now):
            if now["sign"]:
                shown.append(now["sign"])
            return now["state"] == state

        self.hands.wait("end of the clip", over, CLIP_S)
        return int(shown[-1].splitlines()[-1]) if shown else None

    def _plays(self, line):
        plays = [b for b in line["buttons"] if FIRST_PLAY <= b["id"] < FIRST_SLIDER]
        return len(plays) if plays and all(b["enabled"] for b in plays) else 0

    def _watch_and_rate(self, line):
        count = self._plays(line)
        if not count:
            return False
        meant = Meant()
        ratings = {}

        def play(stimulus):
            shown = self.play(stimulus)
            if shown is not None:
                meant.number_shown[stimulus] = shown

        def rate(stimulus):
            ratings[stimulus] = self.rate_on_page(stimulus, meant.number_shown.get(stimulus))

        order = list(range(count))
        self._random.shuffle(order)
        at_once = self._random.random() < 0.5
        for stimulus in order:
            play(stimulus)
            if at_once:
                rate(stimulus)
        if not at_once:
            for stimulus in order:
                rate(stimulus)
        if self._random.random() < 0.2:
            self.play(order[0])
            self.replayed += 1
        meant.answers = [ratings[stimulus] for stimulus in range(count)]
        state = line["state"]
        meant.pressed_utc_s = self.hands.click_button(GO_ON, lambda now: now["state"] != state)
        self.meant[line["trial"]] = meant
        return True

    def rate_on_page(self, stimulus, wanted=None):
        first = FIRST_OPTION + 100 * stimulus
        if slider_of(self.hands.look(), FIRST_SLIDER + stimulus):
            value = self._set_slider(FIRST_SLIDER + stimulus, wanted)
            return Said(0, value=value, stimulus=stimulus)
        options = [b["id"] for b in self.hands.look()["buttons"] if first <= b["id"] < first + 100]
        option = self._random.choice(options)
        self.hands.pick(option)
        return Said(0, options=(option - first,), stimulus=stimulus)

    def _compare(self, line):
        if not self._plays(line):
            return False
        for stimulus in (0, 1):
            self.play(stimulus)
        if self._random.random() < 0.2:
            self.play(self._random.randrange(2))
            self.replayed += 1
        self.hands.wait("answers", lambda now: all(b["enabled"] for b in self._steps(now)))
        preference = self._random.randrange(len(self._steps(self.hands.look())))
        state = line["state"]

        def done(now):
            return now["state"] != state

        if self._by_key(0.3):
            at, by = self.hands.press_key(str(preference + 1), done), "key"
        else:
            at, by = self.hands.click_button(FIRST_RATING + preference, done), "ray"
        self.meant[line["trial"]] = Meant(answers=[Said(-1, value=preference - 2)], pressed_utc_s=at, by=by)
        return True
