"""The scenarios: whole studies at the desktop, broken off and gone on with, replayed."""

import re
import time
from dataclasses import dataclass
from pathlib import Path

import borrowed  # noqa: F401
import kept
import replays
from checks import Database, require
from person import Person
from shortened import shortened
from window import Desktop

HERE = Path(__file__).resolve().parent
REPOSITORY = HERE.parents[2]
STUDIES = REPOSITORY / "assets/data/studies"


@dataclass
class Settings:
    """What the command line said."""

    program: Path
    runs: Path
    shorten: int = 0  # items in each stage; 0: all
    size: str = "960x540"

    def desktop(self, name):
        return Desktop(self.runs / name, self.program, self.size)


def study_file(settings, rig, name, shorten=None):
    items = settings.shorten if shorten is None else shorten
    if items == 0:
        return STUDIES / f"{name}.toml"
    path = rig.folder / f"{name}.toml"
    path.write_text(shortened((STUDIES / f"{name}.toml").read_text(), items))
    return path


def require_clean_end(rig):
    status = rig.deixis.wait(60.0)
    require(status == 0, f"the program ended with status {status}; see {rig.deixis.log}")
    spoken = re.search(r"(?i)^.*\berror\b.*$", rig.deixis.text(), re.MULTILINE)
    require(not spoken, f"the program spoke of an error ({spoken and spoken[0]}); see {rig.deixis.log}")


def whole_study(name, language):
    """A study that ships, from the first page to the last, in one of its languages."""

    def scenario(settings):
        with settings.desktop(name) as rig:
            database = rig.folder / f"{name}.sqlite"
            begun = time.monotonic()
            trace = rig.run(study_file(settings, rig, name), database, "--language", language)
            opened = time.monotonic()
            person = Person(trace, rig.mouse)
            person.take_part()
            require_clean_end(rig)
            took_s = time.monotonic() - opened
            answers = kept.check_whole_session(database, person.meant)
            games = sum(meant.place >= 0 for meant in person.meant.values())
            said = f"{answers} answers in {took_s:.0f} s after {opened - begun:.0f} s, {frames(database)}"
            if games:
                said += ", " + replays.check_choices(settings, database, games)
            return said + ", " + replays.check_pictures(settings, rig, database)

    return scenario


def questions(settings):
    """Every kind of question, answered several times over."""
    count = 0
    for seed in range(1, 4):
        with settings.desktop("questions") as rig:
            database = rig.folder / "questions.sqlite"
            person = Person(rig.run(HERE / "questions.toml", database), rig.mouse, seed)
            person.take_part()
            require_clean_end(rig)
            kept.check_whole_session(database, person.meant)
            count += sum(len(meant.answers) for meant in person.meant.values())
    return f"{count} answers"


def frames(database):
    with Database(database) as db:
        count, seconds = db.rows(
            "select sum(frames), sum(last_display_time_s - first_display_time_s) from trial_tracking"
        )[0]
        return f"{count} frames in trials, {count / seconds:.0f} a second"
