#!/usr/bin/env python3
"""Pictures for the documents that need somebody at the desktop: the experimenter's window, and a replay.

    for_documents.py --program FILE --folder FOLDER

A scripted person takes part in a shortened study. Needs Xvfb, xdotool and ImageMagick's import.
"""

import argparse
import shutil
import subprocess
import tempfile
from pathlib import Path

import borrowed  # noqa: F401
import replays
import studies
from checks import Database
from person import Person
from processes import until
from window import Desktop

STUDY = "pointing2023"
PARTICIPANTS_SIZE, SCREEN = "640x360", "1680x800"  # the experimenter's window has the rest of it
FRAMES_PER_S = 4
EXPERIMENTERS = "experimenter"  # in its title


class Observed(Desktop):
    """A desktop with the experimenter's window beside the participant's, which keeps the keyboard."""

    def windows(self, name):
        experimenters = super().windows(EXPERIMENTERS)
        return experimenters if name == EXPERIMENTERS else [w for w in super().windows(name) if w not in experimenters]


def take_part(settings, rig, picture):
    """The whole study; the picture is taken while a ball of the game itself is chosen."""
    database = rig.folder / f"{STUDY}.sqlite"
    person = Person(rig.run(studies.study_file(settings, rig, STUDY), database, "--operator"), rig.mouse)
    person.take_part(lambda line: line["stage"] == "game" and line["state"].startswith("choosing"))
    person.hands.hover_ball(0)
    window = until("the experimenter's window", lambda: rig.windows(EXPERIMENTERS))[0]
    person.hands.trace.settle(1.5)  # it is drawn less often
    subprocess.run(["import", "-window", str(window), str(picture)], env=rig.environment, check=True)
    person.take_part()
    studies.require_clean_end(rig)
    return database


def show_again(settings, rig, database, picture):
    """The last choice of the game, seen from outside, as it was made."""
    with Database(database) as db:
        trial = db.value("select max(trial_index) from trials where stage = 'game'")
    folder = rig.folder / "replay"
    replays.replay(
        settings, database, "--trial", trial, "--view", "third", "--png", folder, "--force", "--fps", FRAMES_PER_S, "--size", "1280x720",
        environment=rig.environment,
    )
    # The choice, and a second in which it is confirmed, are the end of it.
    shutil.copyfile(sorted(folder.glob("*.png"))[-1 - round(1.0 * FRAMES_PER_S)], picture)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--program", type=Path, required=True)
    parser.add_argument("--folder", type=Path, required=True)
    options = parser.parse_args()
    with tempfile.TemporaryDirectory() as scratch:
        settings = studies.Settings(options.program.resolve(), Path(scratch), shorten=2, size=PARTICIPANTS_SIZE)
        with Observed(settings.runs / STUDY, settings.program, settings.size, SCREEN) as rig:
            database = take_part(settings, rig, options.folder / "operator.png")
            show_again(settings, rig, database, options.folder / "replay.png")


if __name__ == "__main__":
    main()
