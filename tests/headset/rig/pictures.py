"""Pictures of what the lenses would show: the runtime's real compositor in an X window."""

import subprocess

from checks import require
from participant import PAGES
from processes import until

SCREEN = "1920x1080"  # the compositor's window fills it
# Drawn by the processor: at full resolution a frame would take a second. Text has its own resolution.
DRAWN_SMALLER = ("--resolution-scale", "0.3")


class Camera:
    """Takes pictures of the compositor's window, into a folder that holds no others."""

    def __init__(self, rig, folder):
        self._rig = rig
        self._folder = folder
        self._window = until("the compositor's window", lambda: rig.windows("Monado|OpenXR"))[0]
        self.taken = set()
        folder.mkdir(parents=True, exist_ok=True)
        for old in folder.glob("*.png"):
            old.unlink()

    def clear_view(self):
        """The experimenter's window must not lie over the other: beside the screen."""
        for window in self._rig.windows("P01"):
            beside = SCREEN.split("x")[0]
            self._run("xdotool", "windowmove", str(window), beside, "0")

    def take(self, name):
        self.taken.add(name)
        quick = ("-define", "png:compression-level=1")
        self._run("import", "-window", str(self._window), *quick, str(self._folder / f"{name}.png"))

    def _run(self, *command):
        subprocess.run(command, env=self._rig.environment, check=True)

    def require_lit(self):
        """A lit room with an avatar: many colours, and hardly any black but beyond the lenses' edges."""
        for picture in self._folder.glob("*.png"):
            seen = subprocess.run(
                ["identify", "-format", "%k %[fx:mean]", str(picture)], capture_output=True, text=True, check=True
            ).stdout.split()
            require(int(seen[0]) > 1000 and float(seen[1]) > 0.4, f"{picture} shows no lit room")


class Photographer:
    """Takes the wanted pictures, each once: of states as they come up, and of boards ("-answered") when a press leaves
    them."""

    # When the compositor shows it; a movement must have begun.
    SHOWN_S = {"playing": 0.8, "pointing": 0.3}

    def __init__(self, camera, trace, wanted):
        self._camera = camera
        self._trace = trace
        self._wanted = wanted

    def came_up(self, line):
        """Told of all lines."""
        self._take(line, "")

    def before_press(self, line):
        ways_on = [button for button in line["buttons"] if button["role"] == "go_on"]
        ways_on = ways_on or [button for button in line["buttons"] if button["role"] == "option"]
        if any(button["hovered"] for button in ways_on):
            self._take(line, "-answered")

    def _take(self, line, suffix):
        state = line["state"]
        name = name_of(line) + suffix
        if name in self._camera.taken or name not in self._wanted:
            return
        self._trace.settle(self.SHOWN_S.get(state.split("-")[0], 0.5))
        # The compositor is late: it may still show what is over.
        if self._trace.now["state"] == state or state.startswith("feedback"):
            self._camera.take(name)


def name_of(line):
    """What the picture of a state is called."""
    if line["state"] in PAGES:
        return line["stage"]
    number = f"-{line['trial']}" if line["state"] == "questionnaire" else ""
    return f"{line['stage']}-{line['state']}{number}"
