"""A virtual display with the program's window on it, and a mouse and a keyboard, which are xdotool's."""

import re
import struct
import subprocess
import time

import borrowed  # noqa: F401
from processes import Rig, RigError, until
from session_trace import Trace

PARTICIPANT = "P1"


class Desktop(Rig):
    """One scenario's folder, display and program. A context manager: all ends with it."""

    open = []  # those that have processes

    def __init__(self, folder, program, size, screen="1280x800"):
        super().__init__(folder, program, driver="none", screen=screen)
        self.open.append(self)
        self._size = size
        self.mouse = None

    def close(self):
        super().close()
        self.open.remove(self)

    def run(self, study, database, *options):
        """Starts `deixis run` and follows its trace, once its window has come up."""
        self._runs += 1
        path = self.folder / f"trace-{self._runs}.jsonl"
        self.deixis = self._start(
            [self._program, "run", study, "--station", "desktop", "--participant", PARTICIPANT, "--db", database]
            + ["--trace", path, "--size", self._size, *options],
            f"deixis-{self._runs}",
            cwd=self.folder,
        )
        self.trace = Trace(path, self.deixis.alive)
        self.mouse = Mouse(self.environment, lambda: self.windows(PARTICIPANT)[0])
        # The clips of the built-in systems are made before the window opens.
        until("window", lambda: self.windows(PARTICIPANT) or not self.deixis.alive(), 180.0)
        if not self.deixis.alive():
            raise RigError(f"the program ended before its window came up: {self.deixis.text().strip()}")
        # There is no window manager to give it the keyboard.
        self.focus()
        self.trace.wait("first page", lambda line: line["buttons"], 60.0)
        self.focus()  # the one before may have come before the window could take it
        return self.trace

    def focus(self):
        for window in self.windows(PARTICIPANT):
            self.mouse.do("windowfocus", window)

    def window_size(self):
        """Width and height on the screen."""
        return self.mouse.window_size()

    def screen(self):
        """What is shown, as rows of pixels (blue, green, red, unused), in a window-sized cut."""
        left, top, width, height = self.mouse.window_geometry()
        return Screen(self.folder / "Xvfb_screen0").cut(left, top, width, height)


class Screen:
    """The display's own picture: an XWD file, which Xvfb keeps up to date."""

    def __init__(self, path):
        data = path.read_bytes()
        header = struct.unpack(">25I", data[:100])
        self._stride, colours = header[12], header[19]
        if header[11] != 32:
            raise RigError(f"{path}: {header[11]} bits a pixel, expected 32")
        self._pixels = data[header[0] + 12 * colours:]

    def cut(self, left, top, width, height):
        rows = (self._stride * y + 4 * left for y in range(top, top + height))
        return [self._pixels[row: row + 4 * width] for row in rows]


class Mouse:
    """And the keyboard. All that the scripted person can do."""

    def __init__(self, environment, find_window):
        self._environment = environment
        self._find_window = find_window
        self._window = None

    def window_geometry(self):
        """Left, top, width and height on the screen."""
        if self._window is None:
            self._window = self._find_window()
        said = subprocess.run(
            ["xdotool", "getwindowgeometry", "--shell", str(self._window)],
            env=self._environment, capture_output=True, text=True, check=True,
        ).stdout
        values = dict(line.split("=") for line in said.split())
        return tuple(int(values[key]) for key in ("X", "Y", "WIDTH", "HEIGHT"))

    def window_size(self):
        return self.window_geometry()[2:]

    def move_to(self, x, y):
        """A pixel of the window."""
        self.window_geometry()
        return self.do("mousemove", "--window", self._window, x, y)

    def resize(self, width, height):
        """The window, as its frame would."""
        self.window_geometry()
        return self.do("windowsize", self._window, width, height)

    def look_around(self, right_px, down_px):
        """With the right button held."""
        self.do("mousedown", 3)
        time.sleep(0.3)  # the cursor is put elsewhere meanwhile
        self.move(right_px, down_px)
        time.sleep(0.3)
        return self.do("mouseup", 3)

    def do(self, *arguments):
        """Returns when the command began and when it had ended (UTC)."""
        begun = time.time()
        subprocess.run(
            ["xdotool", *(str(a) for a in arguments)], env=self._environment, check=True, timeout=60.0,
            stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
        )
        return begun, time.time()

    def move(self, right_px, down_px):
        return self.do("mousemove_relative", "--", right_px, down_px)

    def click(self):
        return self.do("click", 1)

    def click_in_passing(self):
        """And goes on at once: what was aimed at is meant."""
        return self.do("click", 1, "mousemove_relative", "--", 300, -120)

    def press(self):
        return self.do("mousedown", 1)

    def release(self):
        return self.do("mouseup", 1)

    def turn_wheel(self, notches):
        """Away from the person where they are positive."""
        return self.do("click", "--repeat", abs(notches), "--delay", 60, 4 if notches > 0 else 5)

    def key(self, name):
        return self.do("key", name)

    def hold_key(self, name, down):
        return self.do("keydown" if down else "keyup", name)

    def type(self, text):
        """What is on no key gets one for 0.6 s: long enough for a slow frame to see it, and shorter than what
        the display takes for a key that is held, and repeats."""
        for part in re.findall(r"[ -~]+|[^ -~]", text):
            self.do("type", "--delay", 60 if part.isascii() else 2400, "--", part)
