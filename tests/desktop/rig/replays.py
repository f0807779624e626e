"""What was recorded at the desktop, shown again."""

import re
import shutil
import subprocess

import borrowed  # noqa: F401
from checks import Database, require
from window import PARTICIPANT

SIZE = "480x270"
FRAMES_PER_S = 2
SPEED = 2  # a frame for each second of the trial


def replay(settings, database, *options, environment=None):
    done = subprocess.run(
        [settings.program, "replay", database, "--participant", PARTICIPANT, *(str(o) for o in options)],
        env=environment, capture_output=True, text=True, check=False,
    )
    require(done.returncode == 0, f"replay {' '.join(str(o) for o in options)}: {done.stderr.strip()}")
    return done.stdout


def check_choices(settings, database, games):
    """The recorded rays, and the tracked hand, give the choices that were made."""
    said = replay(settings, database, "--choices")
    found = re.search(r"(\d+) choices: (\d+) the same .*; (\d+) of (\d+) from the tracked hand", said)
    require(found, f"replay --choices said: {said}")
    choices, same, tracked_same, tracked = (int(n) for n in found.groups())
    require(choices == games, f"{choices} choices are replayed, {games} were made")
    require(same == games, f"{same} of {games} choices are those of the ray kept with the answer")
    require(
        tracked_same == tracked == games,
        f"{tracked_same} of {tracked} choices are those of the tracked hand, {games} were made",
    )
    return f"{games} choices replayed"


def check_pictures(settings, rig, database):
    """The last trial that showed a movement, by the person's eyes and from outside; a film where ffmpeg is there."""
    drawing = ("--fps", FRAMES_PER_S, "--speed", SPEED, "--size", SIZE)
    with Database(database) as db:
        trial = db.value("select max(trial_index) from trial_stimuli join responses using (participant, trial_index)")
    made = {}
    for view in ("first", "third"):
        folder = rig.folder / f"replay-{view}"
        said = replay(
            settings, database, "--trial", trial, "--view", view, "--png", folder, "--force", *drawing,
            environment=rig.environment,
        )
        pictures = [path.read_bytes() for path in sorted(folder.glob("*.png"))]
        require(f"{len(pictures)} frames" in said, f"{len(pictures)} pictures; replay said: {said}")
        require(len(set(pictures)) >= 3, f"nothing moves in {folder}")
        made[view] = pictures
    require(len(made["first"]) == len(made["third"]), "the two views are not of the same length")
    require(not set(made["first"]) & set(made["third"]), "both views show the same")
    said = f"{len(made['first'])} frames of trial {trial} drawn from both views"
    if shutil.which("ffmpeg") is None:
        return said + " (no ffmpeg: no film)"
    film = rig.folder / "replay.mp4"
    replay(settings, database, "--trial", trial, "--mp4", film, "--force", *drawing, environment=rig.environment)
    require(film.read_bytes()[4:8] == b"ftyp", f"{film} is no film")
    return said + " and filmed"
