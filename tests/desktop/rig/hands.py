"""Points at things, clicks them, drags and types, as somebody does who watches the screen: each move of the mouse is
followed by a look at what it led to."""

import math
import time

import borrowed  # noqa: F401
from geometry import Pose, add, angle_deg, length, rotate, scaled, subtract
from session_trace import TraceTimeout

DEG_PER_PIXEL = 0.07  # of the mouse that looks around: look_rad_per_pixel in desktop_station.cpp
AIMING_S = 20.0
ANSWER_S = 20.0  # until a click or a key must have done something; frames may be slow
READING_S = 0.6  # a board takes no input right after it came up
CARRIED_DEG = 1.5  # what is carried is on the ray, and the cursor on a pixel


def head_of(line):
    return Pose(tuple(line["head"][:3]), tuple(line["head"][3:]))


def half_height(line, aspect):
    """Tangent of half the vertical field of view: 60 degrees, in the game as many as its first look needs with a
    twentieth free, up to 84, for 16:9; a narrower window shows as much across."""
    half = math.tan(math.radians(30.0))
    if line["first_look"]:
        _, _, width, height = line["first_look"]
        half = min(max(half, max(height, width * 9.0 / 16.0) / 0.9), math.tan(math.radians(42.0)))
    return half * max(1.0, 16.0 / 9.0 / aspect)


def pixel_of(line, point, size):
    """Where on the window a point of the stage is seen; None behind the viewer."""
    head = head_of(line)
    w, *turn = head.orientation
    x, y, z = rotate((w, *scaled(turn, -1.0)), subtract(point, head.position))
    if z > -1e-6:
        return None
    width, height = size
    half = half_height(line, width / height)
    across, upwards = x / -z / (half * width / height), y / -z / half
    return (across + 1.0) / 2.0 * width - 0.5, (1.0 - upwards) / 2.0 * height - 0.5


def angles_deg(direction):
    """Yaw, positive to the left, and pitch, positive up, of a direction."""
    x, y, z = direction
    return math.degrees(math.atan2(-x, -z)), math.degrees(math.atan2(y, math.hypot(x, z)))


def button(line, number):
    return next((b for b in line["buttons"] if b["id"] == number), None)


def slider(line, number):
    return next((s for s in line["sliders"] if s["id"] == number), None)


def field(line, number):
    return next((f for f in line["fields"] if f["id"] == number), None)


def board(line):
    """What tells one board from another."""
    return (
        line["state"], line["stage"], line["trial"], line["status"].split(",")[0],
        tuple(part["id"] for kind in ("buttons", "sliders", "fields") for part in line[kind]),
    )


class Hands:
    def __init__(self, trace, mouse):
        self.trace = trace
        self.mouse = mouse
        self._clicks = 0
        self._board = None
        self._board_since_s = 0.0
        self._tries = 0
        self.turned = 0  # how often something was out of the view

    def look(self):
        """The latest line."""
        while self.trace.read():
            self._notice_board()
        return self.trace.now

    def _notice_board(self):
        if board(self.trace.now) != self._board:
            self._board = board(self.trace.now)
            self._board_since_s = self.trace.now["time_s"]

    def wait(self, what, condition, timeout_s=ANSWER_S):
        def noticing(line):
            self._notice_board()
            return condition(line)

        return self.trace.wait(what, noticing, timeout_s)

    def read(self):
        """Until the board has been there for as long as it takes to read a word."""
        self.wait("time to read", lambda line: line["time_s"] >= self._board_since_s + READING_S)
        return self.look()

    # Pointing.

    def point_at(self, what, point, there):
        """Moves the mouse until `there(line)` holds and the cursor is on the point of the stage. `point(line)`: where
        it is, or None where it is gone. Whether it was found."""
        end = time.monotonic() + AIMING_S
        at = None
        while time.monotonic() < end:
            line = self.look()
            wanted = point(line)
            if wanted is None:
                return False
            size = self.mouse.window_size()
            pixel = pixel_of(line, wanted, size)
            if pixel is None or not all(0.0 <= v <= most - 1 for v, most in zip(pixel, size)):
                self._look_towards(line, wanted)
                continue
            pixel = tuple(round(v) for v in pixel)
            if pixel == at:  # it has been there all the time: as people do, away and back
                self._frames(line, self.mouse.move_to(pixel[0] + (25 if pixel[0] < size[0] / 2 else -25), pixel[1]))
            self._frames(line, self.mouse.move_to(*pixel))
            at = pixel
            if self._soon(lambda now: point(now) is None or there(now), 1.0) and point(self.look()) is not None:
                return True
            if point(self.look()) is not None and self._settled(line):
                return False
        raise TraceTimeout(f"{what} could not be pointed at; {self.trace.describe()}")

    def _settled(self, line):
        """Whether the view is the same as in the line before: then it was pointed at, and hidden or not to be had."""
        now = self.look()
        self._tries = self._tries + 1 if now["head"] == line["head"] else 0
        if self._tries < 3:
            return False
        self._tries = 0
        return True

    def _frames(self, line, moved):
        """Until a frame that began when the cursor had moved, or another board is there. A line is of a frame that was
        drawn with the cursor where it was some time before."""
        def wait_for(condition):
            self._soon(lambda now: condition(now) or board(now) != board(line), 1.5)

        wait_for(lambda now: now["utc_s"] > moved[1])
        frame = self.look()["frame"]
        wait_for(lambda now: now["frame"] > frame)

    def _look_towards(self, line, point):
        head = head_of(line)
        yaw, pitch = angles_deg(rotate(head.orientation, (0.0, 0.0, -1.0)))
        wanted_yaw, wanted_pitch = angles_deg(subtract(point, head.position))
        turn = (yaw - wanted_yaw + 180.0) % 360.0 - 180.0
        moved = self.mouse.look_around(round(turn / DEG_PER_PIXEL), round((pitch - wanted_pitch) / DEG_PER_PIXEL))
        self.turned += 1
        self._frames(line, moved)

    def _soon(self, condition, timeout_s):
        try:
            self.wait("what is expected", condition, timeout_s)
            return True
        except TraceTimeout:
            if not self.trace._alive():
                raise
            return False

    # Doing.

    def click(self):
        """Every third one in passing."""
        self._clicks += 1
        return self.mouse.click_in_passing() if self._clicks % 3 == 0 else self.mouse.click()

    def click_button(self, number, done=None):
        """Waits until it can be pressed, presses it, and waits until done(line), which does not hold before; by
        default, until it has been taken notice of. Returns when it was pressed (UTC, from and to)."""

        def enabled(line):
            found = button(line, number)
            return found is not None and found["enabled"]

        line = self.wait(f"button {number}", enabled)
        before = board(line)
        done = done or (lambda now: board(now) != before or not enabled(now))
        for _ in range(3):
            self.read()
            lit = self.point_at(
                f"button {number}",
                lambda now: tuple(button(now, number)["centre"]) if enabled(now) else None,
                lambda now: button(now, number)["hovered"],
            )
            if not lit:
                if done(self.look()):
                    raise AssertionError(f"button {number} was gone before it was pressed; {self.trace.describe()}")
                continue
            at = self.click()
            if self._soon(done, ANSWER_S):
                return at
        raise TraceTimeout(f"button {number} could not be pressed; {self.trace.describe()}")

    def pick(self, number):
        """Presses one option of several, unless it is picked already, and sees that it is."""
        if button(self.look(), number)["chosen"]:
            return None
        return self.click_button(number, lambda line: (button(line, number) or {}).get("chosen"))

    def press_key(self, name, done):
        self.read()
        for _ in range(3):
            at = self.mouse.key(name)
            if self._soon(done, ANSWER_S):
                return at
        raise TraceTimeout(f"key {name} did nothing; {self.trace.describe()}")

    def drag_slider(self, number, value):
        """Presses somewhere on the track, drags to a value and lets go."""

        def point_at(line, wanted):
            found = slider(line, number)
            share = (wanted - found["low"]) / (found["high"] - found["low"])
            return add(found["left"], scaled(subtract(found["right"], found["left"]), share))

        line = self.wait(f"slider {number}", lambda now: (slider(now, number) or {}).get("enabled"))
        low, high = slider(line, number)["low"], slider(line, number)["high"]
        begin = low + (high - low) * (0.3 if value > (low + high) / 2 else 0.7)
        self.read()
        self.point_at(f"slider {number}", lambda now: point_at(now, begin), lambda now: True)
        at = self.mouse.press()
        try:
            self.wait(
                f"thumb on slider {number}",
                lambda now: now["utc_s"] > at[1] + 0.1 and slider(now, number)["value"] is not None,
            )

            def there(now):
                return slider(now, number)["value"] == value

            for _ in range(4):
                if self.point_at(f"{value} on slider {number}", lambda now: point_at(now, value), there):
                    break
            else:
                raise TraceTimeout(f"slider {number} stays at {slider(self.look(), number)['value']}, not {value}")
        finally:
            at = self.mouse.release()
        # Letting go must not move it.
        self.wait("a frame", lambda now: now["utc_s"] > at[1] + 0.1)
        kept = slider(self.look(), number)["value"]
        if kept != value:
            raise AssertionError(f"slider {number} was let go at {value} and stands at {kept}")

    def carry_ball(self, to, notches):
        """Takes the only ball, carries it in front of a point of the stage, turns the wheel by so many notches, away
        from the person where they are positive, and lets go. Where it lies then."""

        def away_m(line):
            return length(subtract(line["balls"][0]["centre"], line["ray"]["origin"]))

        def in_front(line):
            if line["ray"] is None:
                return False
            ball, wanted = (subtract(point, line["ray"]["origin"]) for point in (line["balls"][0]["centre"], to))
            return angle_deg(ball, wanted) < CARRIED_DEG

        if self.hover_ball(0) is None:
            raise AssertionError(f"the ball could not be taken; {self.trace.describe()}")
        at = self.mouse.press()
        try:
            line = self.wait("the press", lambda now: now["utc_s"] > at[1] + 0.1)
            self.point_at("where the ball is to go", lambda now: to, in_front)
            line = self.wait("the ball there", in_front)
            before_m = away_m(line)
            self.mouse.turn_wheel(notches)
            self.wait("the wheel", lambda now: (away_m(now) - before_m) * notches > 0.02 * notches**2)
        finally:
            at = self.mouse.release()
        line = self.wait("a frame", lambda now: now["utc_s"] > at[1] + 0.1)
        return tuple(line["balls"][0]["centre"])

    def type_into(self, number, text):
        """Clicks the field where it does not take what is typed, types, and sees that it stands there."""
        line = self.wait(f"field {number}", lambda now: field(now, number))
        self.read()
        if not field(line, number)["active"]:
            self.point_at(f"field {number}", lambda now: tuple(field(now, number)["centre"]), lambda now: True)
            self.click()
            self.wait(f"caret in field {number}", lambda now: field(now, number)["active"])
        self.mouse.type(text)
        self.wait(f"'{text}' in field {number}", lambda now: field(now, number)["text"] == text)

    def hover_ball(self, place):
        """Points at a ball until it lights up. Its centre; None where others hide it from here."""

        def ball(line):
            return line["balls"][place] if place < len(line["balls"]) else None

        def choosing(line):
            return line["state"].startswith(("choosing", "aiming"))

        found = ball(self.look())
        for right, up in ((0.0, 0.0), (0.0, 0.7), (0.7, 0.0), (-0.7, 0.0), (0.0, -0.7)):

            def point(line):
                if not choosing(line):
                    return None
                away = subtract(found["centre"], line["head"][:3])
                side = scaled((-away[2], 0.0, away[0]), found["radius_m"] * right / length((away[0], 0.0, away[2])))
                return add(add(found["centre"], side), (0.0, found["radius_m"] * up, 0.0))

            if self.point_at(f"ball {place}", point, lambda line: ball(line)["look"] == "hovered"):
                return tuple(found["centre"])
        return None
