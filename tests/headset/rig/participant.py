"""A scripted participant: stands somewhere in the room, reads pages, rates and chooses, and knows what it chose."""

import time
from dataclasses import dataclass

from geometry import Pose, add, looking_along, multiply, subtract, turned_about_x, turned_about_y
from session_trace import TraceTimeout

GO_ON = 1  # ids of buttons on panels
RESUME = 2
FIRST_RATING = 101

PAGES = ("instructions", "break", "welcome-back", "practice-again", "attention", "closing")
READING_S = 0.5  # a page takes no input right after it came up
AIMING_S = 3.0  # until what is aimed at must have lit up


@dataclass
class Given:
    """An answer as the participant gave it."""

    trial: int
    rating: int = 0
    place: int = -1
    ball: tuple = ()  # centre of the ball that it aimed at
    pressed_utc_s: float = 0.0
    head: Pose = None  # in the room, when it answered


class Participant:
    """Its places and poses are in the room's coordinates, which are the program's tracking space at first."""

    def __init__(self, remote, place=(0.35, -0.2), heading_deg=25.0, eye_height_m=1.62):
        self.remote = remote
        # The program takes the place and the heading from the head as it first sees it: this is where it must lie.
        self._body = Pose((place[0], 0.0, place[1]), turned_about_y(heading_deg))
        self._eye_height_m = eye_height_m
        self.room_from_tracking = Pose()  # the program's space, where the runtime has put it elsewhere
        self.anchor = self._body
        self.hand = "right"
        self._reach = 0
        self.given = {}  # by trial
        self.before_press = lambda trace: None  # told when the ray is where it is wanted
        self.head = None
        self.stand()

    # Moving.

    def stand(self, lean=(0.0, 0.0, 0.0), turn_deg=0.0, nod_deg=0.0):
        """Head over the place, moved by `lean` (right, up, back) and turned; both hands at rest."""
        orientation = multiply(
            multiply(self._body.orientation, turned_about_y(turn_deg)), turned_about_x(nod_deg)
        )
        self.head = Pose(self._body.point(add((0.0, self._eye_height_m, 0.0), lean)), orientation)
        self.remote.state.head.centre.set(self.head)
        self.rest_hands()

    def rest_hands(self):
        for hand in ("left", "right"):
            self._put(hand, self._hand_rest(hand), turned_about_x(-60.0))
        self.remote.send()

    def _hand_rest(self, hand):
        side = 0.22 if hand == "right" else -0.22
        return (side, self._eye_height_m - 0.55, -0.3)

    # Where a hand may be held: one of them sees each ball past the others.
    _REACHES = ((0.0, 0.0), (0.12, 0.2), (-0.2, 0.3), (0.25, -0.15), (-0.3, 0.0))

    def reaches(self):
        """Holds the hand in one place after the other."""
        for self._reach in range(len(self._REACHES)):
            yield self._reach

    def _hand_position(self, hand):
        right, up = self._REACHES[self._reach % len(self._REACHES)]
        return add(self._hand_rest(hand), (right, up + 0.15, -0.1))

    def _put(self, hand, offset, orientation):
        pose = Pose(self._body.point(offset), multiply(self._body.orientation, orientation))
        getattr(self.remote.state, hand).pose.set(pose)

    def aim(self, trace, stage_point, hand=None, look=True):
        """Points the hand at a point of the stage, and looks there."""
        hand = hand or self.hand
        position = self._body.point(self._hand_position(hand))
        target = self.room_from_tracking.point(trace.placement.to_tracking(tuple(stage_point)))
        getattr(self.remote.state, hand).pose.set(Pose(position, looking_along(subtract(target, position))))
        if look:
            self.head = Pose(self.head.position, looking_along(subtract(target, self.head.position)))
            self.remote.state.head.centre.set(self.head)
        self.remote.send()

    def aim_away(self, hand=None):
        """Points the hand steeply up, where nothing is."""
        hand = hand or self.hand
        self._put(hand, self._hand_position(hand), turned_about_x(80.0))
        self.remote.send()

    def trigger(self, down, *hands):
        """Pulls or lets go the trigger of the hands named, or of the one in use. Returns when (UTC)."""
        for hand in hands or (self.hand,):
            getattr(self.remote.state, hand).pull_trigger(down)
        self.remote.send()
        return time.time()

    def step_aside(self, right_m):
        """Moves the whole body; the place stays where it was."""
        self._body = Pose(self.anchor.point((right_m, 0.0, 0.0)), self.anchor.orientation)
        self.stand()

    def push_stick(self, forward, hand=None):
        """The thumbstick, from -1 (towards the participant) to 1."""
        getattr(self.remote.state, hand or self.hand).thumbstick[1] = forward
        self.remote.send()

    def button(self, name, down, hand="right"):
        setattr(getattr(self.remote.state, hand), name, down)
        self.remote.send()

    def awake(self, active, *hands):
        for hand in hands or ("left", "right"):
            getattr(self.remote.state, hand).active = active
        self.remote.send()

    # Taking part.

    def hover_button(self, trace, button):
        """Aims at an enabled button until it lights up."""

        def found(line):
            return next((b for b in line["buttons"] if b["id"] == button and b["enabled"]), None)

        def lit(line):
            return found(line) is not None and found(line)["hovered"]

        trace.wait(f"button {button}", found)
        self._aim_until(trace, f"light on button {button}", lambda: found(trace.now)["centre"], lit)

    def hover_ball(self, trace, place):
        """Aims at a ball until it lights up; its centre."""
        trace.wait("balls to choose from", lambda line: line["state"].startswith(("choosing", "aiming")))
        centre = trace.now["balls"][place]["centre"]
        self._aim_until(
            trace, f"light on ball {place}", lambda: centre, lambda line: line["balls"][place]["look"] == "hovered"
        )
        return centre

    def _aim_until(self, trace, what, centre, lit):
        """Holds the hand elsewhere where something is in the way; aims anew where the scene was moved around the
        participant, which is told a frame after it is seen."""
        for attempt in self.reaches():
            try:
                placement = None
                while trace.placement is not placement:
                    placement = trace.placement
                    self.aim(trace, centre())
                    trace.wait(what, lambda line: lit(line) or trace.placement is not placement, AIMING_S)
                return
            except TraceTimeout:
                if attempt + 1 == len(self._REACHES):
                    raise

    def press_until(self, trace, what, condition):
        """Pulls the trigger until the program has answered to it, then lets go. Returns when it was pulled (UTC)."""
        self.before_press(trace)
        at = self.trigger(True)
        try:
            trace.wait(what, condition, 10.0)
        finally:
            self.trigger(False)
        return at

    def leave_page(self, trace):
        page = self._key(trace.now)
        end = time.monotonic() + READING_S
        self.hover_button(trace, GO_ON)
        trace.settle(max(0.0, end - time.monotonic()))
        self.press_until(trace, f"something after page {page}", lambda now: self._key(now) != page)
        self.rest_hands()

    def resume(self, trace):
        """Leaves the board of a pause."""
        self.hover_button(trace, RESUME)
        trace.settle(READING_S)
        self.press_until(trace, "end of the pause", lambda line: line["state"] != "paused")
        self.rest_hands()

    def rate(self, trace, rating):
        trial = trace.now["trial"]
        self.hover_button(trace, FIRST_RATING + rating - 1)
        at = self.press_until(trace, "rated", lambda now: now["state"] == "rated")
        self.has_given(trial, rating=rating, pressed_utc_s=at)
        self.rest_hands()

    def choose(self, trace, place):
        trial = trace.now["trial"]
        centre = self.hover_ball(trace, place)
        at = self.press_until(trace, "chosen", lambda now: now["state"].startswith("chosen"))
        self.has_given(trial, place=place, ball=tuple(centre), pressed_utc_s=at)
        self.rest_hands()

    def has_given(self, trial, **answer):
        self.given[trial] = Given(trial, head=self.head, **answer)

    def take_part(self, trace, choices, stop=None, watch=None):
        """Goes on until the session is over or stop(line) says so. `choices`: a Choices. watch(line) is told of
        every state before the participant acts on it."""
        while True:
            line = trace.now
            if stop and stop(line):
                return
            if watch:
                watch(line)
                if trace.now is not line:
                    continue  # the watcher took its time
            state = line["state"]
            if state == "over":
                return
            if state in PAGES:
                self.leave_page(trace)
                continue
            if state == "rating":
                self._move(line["trial"])
                self.rate(trace, choices.rating(line["trial"]))
                continue
            if state.startswith(("choosing", "aiming")):
                self._move(line["trial"])
                self.choose(trace, choices.place(line["trial"]))
                continue
            if state == "paused":
                raise AssertionError(f"paused unexpectedly: {trace.describe()}")
            if state.startswith("waiting"):
                self.stand()  # and look at the avatar
            key = self._key(line)
            trace.wait(f"something after '{state}'", lambda now, key=key: self._key(now) != key, 40.0)

    @staticmethod
    def _key(line):
        return line["state"], line["stage"], line["trial"], line["status"]

    def _move(self, trial):
        """People do not stand still: another small lean and turn for each trial."""
        self.stand(
            lean=(0.03 * (trial % 3 - 1), -0.02 * (trial % 2), 0.03 * (trial % 4 - 1.5)),
            turn_deg=6.0 * (trial % 3 - 1),
            nod_deg=-5.0 * (trial % 2),
        )


class Choices:
    """Fixed lists, gone through in the order in which trials are met; the same answer for a trial met again."""

    RATINGS = (4, 2, 5, 1, 3)
    PLACES = (0, 2, 1, 1, 0, 2, 2, 0, 1, 2)

    def __init__(self):
        self._ratings = {}
        self._places = {}

    def rating(self, trial):
        return self._ratings.setdefault(trial, self.RATINGS[len(self._ratings) % len(self.RATINGS)])

    def place(self, trial):
        return self._places.setdefault(trial, self.PLACES[len(self._places) % len(self.PLACES)])
