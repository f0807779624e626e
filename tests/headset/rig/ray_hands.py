"""Points at what a board shows and pulls the trigger, in place of the desktop's mouse."""

import time

import desktop  # noqa: F401
from geometry import angle_deg, length, rotate, scaled, subtract
from hands import Hands, board, field

FIRST_OPTION, FIRST_FIELD = 1000, 5000  # as in studies/session.hpp
ERASE, POINT, MINUS = 10, 11, 12  # keys of a number's pad: panel_layout.hpp
ON_POINT_M = 0.004
EYES_TURN_DEG = 40.0  # off straight ahead: for less nobody turns the head
PUSHED_S = 0.4
SEEN_FRAMES = 2  # until the program has surely seen the trigger


def off_ray_m(line, point):
    """How far the ray that is shown passes the point by."""
    if line["ray"] is None:
        return float("inf")
    away = subtract(point, line["ray"]["origin"])
    along = sum(a * d for a, d in zip(away, line["ray"]["direction"]))
    return length(subtract(away, scaled(line["ray"]["direction"], along)))


def aside_deg(line, point):
    """How far off straight ahead, as somebody stands who stands as asked."""
    ahead = rotate(tuple(line["stage_from_viewer"][3:]), (0.0, 0.0, -1.0))
    return angle_deg(ahead, subtract(point, line["head"][:3]))


class Trigger:
    """Of the participant's hand, where the desktop has a mouse's button. wait(what, condition): a RayHands'."""

    def __init__(self, body, wait):
        self._body = body
        self._wait = wait
        self._moved_utc_s = 0.0
        self._first_frame = None  # that was to be shown after it was moved

    def press(self):
        self._wait("the trigger let go", self.seen)
        return self._move(True)

    def release(self):
        return self._move(False)

    def _move(self, down):
        begun = self._body.trigger(down)
        self._moved_utc_s, self._first_frame = time.time(), None
        return begun, self._moved_utc_s

    def turn_wheel(self, notches):
        """A headset has a stick in its place."""
        self._wait("the press", self.seen)
        self._body.push_stick(1.0 if notches > 0 else -1.0)
        time.sleep(PUSHED_S)
        return self._body.push_stick(0.0)

    def seen(self, line):
        """Whether the program has seen what the trigger did last."""
        if self._first_frame is None and line["utc_s"] > self._moved_utc_s:
            self._first_frame = line["frame"]
        return self._first_frame is not None and line["frame"] >= self._first_frame + SEEN_FRAMES


class RayHands(Hands):
    """`body`: a Participant. `watch(line)` is told of every line, and `before_press(line)` before a press."""

    def __init__(self, trace, body, watch=None, before_press=None):
        super().__init__(trace, Trigger(body, self.wait))
        self.body = body
        self._watch = watch or (lambda line: None)
        self._before_press = before_press or (lambda line: None)
        self.slips = 0  # made and mended while typing numbers

    def _notice_board(self):
        super()._notice_board()
        self._watch(self.trace.now)

    def point_at(self, what, point, there):
        """Points at it, from another side where it does not light up. Whether it was found."""
        for _ in self.body.reaches():
            at = point(self.look())
            if at is None:
                return False
            placement = None
            while self.trace.placement is not placement:
                placement = self.trace.placement
                self.body.aim(self.trace, at, look=aside_deg(self.trace.now, at) > EYES_TURN_DEG)
                self.wait(f"ray on {what}", lambda now: point(now) is None or off_ray_m(now, at) < ON_POINT_M)
            if self._soon(lambda now: point(now) is None or there(now), 1.0):
                return point(self.look()) is not None
        return False

    def click(self):
        """Pulls the trigger until the program has seen it; then looks ahead again, hands down."""
        line = self.look()
        self._before_press(line)
        begun, _ = self.mouse.press()
        # What comes of it may be there for a moment only, and the caller waits for it: none of it is passed over.
        self.wait("the press", lambda now: board(now) != board(line) or self.mouse.seen(now))
        _, ended = self.mouse.release()
        self.body.stand()
        return begun, ended

    def drag_slider(self, number, value):
        super().drag_slider(number, value)
        self.body.stand()

    def carry_ball(self, to, notches):
        super().carry_ball(to, notches)
        # Until it is seen that the trigger is free, the ball goes where the hand goes.
        line = self.wait("letting go", self.mouse.seen)
        self.body.stand()
        return tuple(line["balls"][0]["centre"])

    def press_key(self, name, done):
        raise AssertionError(f"key {name}: there is no keyboard in a headset")

    def type_into(self, number, text):
        """On the pad of keys beside a number; the first time with a slip, which is erased again."""
        first = FIRST_OPTION + 100 * (number - FIRST_FIELD)

        def press(key, wanted):
            self.click_button(first + key, lambda now: field(now, number)["text"] == wanted)

        typed = ""
        for character in text:
            if typed and not self.slips:
                self.slips += 1
                press(7, typed + "7")
                press(ERASE, typed)
            press({".": POINT, "-": MINUS}.get(character) or int(character), typed + character)
            typed += character
