"""Follows the file that `deixis run --trace` writes: a line of JSON whenever what the participant sees changes."""

import json
import time

from geometry import Placement


class TraceTimeout(AssertionError):
    pass


class Trace:
    """`now` is the last line read; `notes` all that the station noted so far, as (kind, detail)."""

    def __init__(self, path, alive):
        self._path = path
        self._alive = alive  # () -> bool: whether the program still runs
        self._file = None
        self._rest = ""
        self.now = None
        self.lines = 0
        self.notes = []
        self.states = []  # as they came, repetitions left out
        self.statuses = []
        self.rays_outside = []  # states other than a page's, an answer's or the pause's in which a ray was shown
        self.placement = None

    def read(self):
        """Takes in the next line, one at a time so that no short state is missed; False where there is none."""
        if self._file is None:
            try:
                self._file = open(self._path, encoding="utf-8")
            except FileNotFoundError:
                return False
        self._rest += self._file.readline()
        if not self._rest.endswith("\n"):
            return False
        self._take(json.loads(self._rest))
        self._rest = ""
        return True

    def _take(self, line):
        self.now = line
        self.lines += 1
        for note in line.get("notes", []):
            self.notes.append((note["kind"], note["detail"]))
            if note["kind"] == "placement":
                detail = json.loads(note["detail"])
                self.placement = Placement(detail["scale"], detail["yaw_deg"], tuple(detail["shift_m"]))
        if not self.states or self.states[-1] != line["state"]:
            self.states.append(line["state"])
        if not self.statuses or self.statuses[-1] != line["status"]:
            self.statuses.append(line["status"])
        silent = ("waiting", "playing", "pointing", "rated", "chosen")
        if line["ray"] is not None and line["state"].split("-")[0] in silent:
            self.rays_outside.append(line["state"])

    def wait(self, what, condition, timeout_s=30.0):
        """Reads until condition(line) holds for a line, the present one included; fails after timeout_s."""
        end = time.monotonic() + timeout_s
        while True:
            if self.now is not None and condition(self.now):
                return self.now
            if self.read():
                continue
            if not self._alive():
                while self.read():
                    if condition(self.now):
                        return self.now
                raise TraceTimeout(f"the program ended before {what}; {self.describe()}")
            if time.monotonic() > end:
                raise TraceTimeout(f"no {what} within {timeout_s:.0f} s; {self.describe()}")
            time.sleep(0.004)

    def settle(self, seconds):
        """Goes on reading for a while."""
        end = time.monotonic() + seconds
        while time.monotonic() < end:
            if not self.read():
                time.sleep(0.004)

    def note(self, kind):
        """Details of all notes of a kind."""
        return [detail for found, detail in self.notes if found == kind]

    def describe(self):
        if self.now is None:
            return "nothing has been traced"
        line = self.now
        buttons = ", ".join(f"{b['id']}{'*' if b['hovered'] else ''}" for b in line["buttons"])
        balls = ", ".join(b["look"] for b in line["balls"])
        return (
            f"the last state is '{line['state']}' (status '{line['status']}', trial {line['trial']}, "
            f"buttons [{buttons}], balls [{balls}], notice '{line['notice']}', ray {line['ray']})"
        )
