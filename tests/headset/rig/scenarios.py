"""The scenarios: the real program, a real OpenXR runtime and somebody who takes part."""

import re
import time
from pathlib import Path

import checks
from checks import Database, require
from participant import PAGES, Choices, Participant
from processes import Rig, until

HERE = Path(__file__).parent
STUDY = HERE / "short.toml"
STORAGE_DELAY_S = 0.2  # in the soak, of each transaction


class Settings:
    """What the command line said."""

    def __init__(self, program, runs, pictures, soak_s):
        self.program = Path(program)
        self.runs = Path(runs)
        self.pictures = Path(pictures)
        self.soak_s = soak_s
        self.usual_work_s = None  # what frames took in the study scenario

    def rig(self, name, **more):
        return Rig(self.runs / name, self.program, **more)


def changed_study(rig, name, *changes, without=None):
    """The short study with parts of its text replaced, and without stages of a kind."""
    head, *stages = STUDY.read_text().split("[[stages]]")
    text = "[[stages]]".join([head, *(one for one in stages if f'kind = "{without}"' not in one)])
    for old, new in changes:
        require(old in text, f"'{old}' is not in {STUDY}")
        text = text.replace(old, new)
    path = rig.folder / f"{name}.toml"
    path.write_text(text)
    return path


def tiny_study(rig):
    """2 ratings and 4 choices, no practice, no break."""
    return changed_study(
        rig, "tiny", ("items = 2", "items = 1"), ("items = 4", "items = 2"),
        ('break_every = 4\nbreak_text = "A short break."\n', ""), without="practice",
    )


def long_study(rig, seconds):
    """About so long: the short study takes a minute."""
    times = max(1, round(seconds / 60.0))
    return changed_study(
        rig, "long", ('"rating"\nitems = 2', f'"rating"\nitems = {2 * times}'), ("items = 4", f"items = {4 * times}"),
        ("count = 30", f"count = {30 * times}"), ("break_every = 4", f"break_every = {4 * times}"),
    )


def require_valid(rig, run=1):
    """The validation layer was there in that run, and had nothing to complain of."""
    path = rig.folder / f"validation-{run}.txt"
    require(path.exists(), f"run {run} left no file of the validation layer")
    errors = [line for line in path.read_text(errors="replace").splitlines() if "[VALID_ERROR" in line]
    require(not errors, f"the validation layer found {len(errors)} errors, the first: {(errors or [''])[0]}")


def require_clean_end(rig, timeout_s=30.0):
    status = rig.deixis.wait(timeout_s)
    require(status == 0, f"the program ended with status {status}; see {rig.deixis.log}")
    spoken = re.search(r"(?i)^.*\berror\b.*$", rig.deixis.text(), re.MULTILINE)
    require(not spoken, f"the program spoke of an error ({spoken and spoken[0]}); see {rig.deixis.log}")


def begin(rig, database, *options, study=STUDY, **more):
    """Service, participant and program, up to the first page."""
    rig.start_service()
    person = Participant(rig.remote)
    trace = rig.run(study, database, *options, **more)
    trace.wait("first page", lambda line: line["state"] in PAGES, 60.0)
    return person, trace


def whole_study(settings):
    """A whole study with Index controllers: the database holds what was chosen, sane poses and times."""
    with settings.rig("study") as rig:
        database = rig.folder / "short.sqlite"
        person, trace = begin(rig, database)
        person.take_part(trace, Choices())
        require_clean_end(rig)
        count = checks.check_exactly_given(database, person.given)
        require(count == 12, f"{count} answers instead of 12")
        checks.check_balls(database, person.given)
        period = checks.check_times(database, person.given)
        checks.check_heads(database, person.given, person.anchor)
        frames = checks.check_tracking(database)
        checks.check_places(database)
        checks.check_joints(database)
        settings.usual_work_s = checks.work_of_frames(database)
        require(not trace.rays_outside, f"a ray was shown in {sorted(set(trace.rays_outside))}")
        missing = {f"{state}-{layout}" for state in ("waiting", "playing", "pointing", "choosing", "aiming", "chosen")
                   for layout in ("across", "side-by-side")} - set(trace.states)
        require(not missing, f"the session was never in {sorted(missing)}")
        with Database(database) as db:
            profiles = [r["detail"] for r in db.rows("select detail from events where kind = 'input_profile'")]
            require(
                any("index_controller" in profile for profile in profiles), f"the input profiles were {profiles}"
            )
            runtime = db.value("select value from session_properties where name = 'runtime'")
            require("Monado" in runtime, f"the runtime recorded is '{runtime}'")
            require(db.value("select outcome from sessions") == "finished", "the session is not marked as finished")
            station = db.value("select station from sessions")
            require(station == "headset", f"the station recorded is '{station}'")
        require_valid(rig)
        return f"12 answers, {frames} frames, {period * 1e3:.0f} ms a frame"


def simple_controllers(settings):
    """Another driver: a head that wobbles, and simple controllers. The session runs and ends when asked to."""
    with settings.rig("simple", driver="simulated") as rig:
        database = rig.folder / "short.sqlite"
        rig.start_service()
        trace = rig.run(STUDY, database)
        trace.wait("first page", lambda line: line["stage"] == "welcome", 60.0)
        frames = until("100 tracked frames", lambda: tracked_frames(database) > 100 and tracked_frames(database), 60.0)
        rig.close_window("P01")
        status = rig.deixis.wait(30.0)
        require(status == 0, f"the program ended with status {status}; see {rig.deixis.log}")
        with Database(database, tracking=True) as db:
            profiles = [r["detail"] for r in db.rows("select detail from events where kind = 'input_profile'")]
            require(
                any("khr/simple_controller" in profile for profile in profiles), f"the input profiles were {profiles}"
            )
            require(db.value("select outcome from sessions") == "quit", "the session is not marked as ended early")
            moved = db.value("select max(head_x_m) - min(head_x_m) + max(head_y_m) - min(head_y_m) from tracking")
            require(moved > 0.001, "the head did not move")
            require(db.value("select count(*) from responses") == 0, "somebody answered")
        require_valid(rig)
        return f"{frames} frames"


def tracked_frames(database):
    try:
        with Database(database) as db:
            return db.value("select coalesce(sum(frames), 0) from tracking_blocks")
    except Exception:  # the file or its tables are not made yet
        return 0


def runtime_killed(settings):
    """monado-service is killed in the midst of a trial, started again, and the command run again."""
    with settings.rig("killed") as rig:
        database = rig.folder / "tiny.sqlite"
        study = tiny_study(rig)
        person, trace = begin(rig, database, study=study)
        choices = Choices()
        person.take_part(
            trace, choices, stop=lambda line: line["state"].startswith("playing-") and len(person.given) == 4
        )
        killed_in = trace.now["trial"]
        before = checks.answers(database)
        rig.kill_service()
        status = rig.deixis.wait(30.0)
        require(status == 1, f"without its runtime the program ended with status {status}; see {rig.deixis.log}")
        said = rig.deixis.text()
        require("deixis: error:" in said and "runtime" in said, f"it did not say why it ended; see {rig.deixis.log}")
        require(len(before) == 4 and checks.answers(database) == before, "answers before the kill are not there")

        again, trace = begin(rig, database, study=study)
        again.given = person.given
        require(trace.now["state"] == "welcome-back", f"the first page was '{trace.now['state']}'")
        again.take_part(trace, choices, stop=lambda line: line["trial"] >= 0)
        require(trace.now["trial"] == killed_in, f"it went on at trial {trace.now['trial']}, not at {killed_in}")
        again.take_part(trace, choices)
        require_clean_end(rig)
        require(checks.answers(database)[: len(before)] == before, "an earlier answer was changed")
        count = checks.check_exactly_given(database, person.given)
        require(count == 6, f"{count} answers instead of 6")
        require_valid(rig, 2)
        return f"killed in trial {killed_in} after {len(before)} answers"


def no_runtime(settings):
    """With no OpenXR service the program says so and ends; nothing is kept of the participant."""
    with settings.rig("no-runtime") as rig:
        database = rig.folder / "short.sqlite"
        rig.run(STUDY, database, environment={"XR_ENABLE_API_LAYERS": None})
        status = rig.deixis.wait(60.0)
        said = rig.deixis.text()
        require(status == 1, f"the program ended with status {status}; see {rig.deixis.log}")
        require("deixis: error:" in said and "OpenXR" in said, f"it did not say why; see {rig.deixis.log}")
        require("desktop" not in said.split("deixis: error:")[0], "it fell back to the desktop")
        with Database(database) as db:
            for table in ("participants", "sessions"):
                require(db.value(f"select count(*) from {table}") == 0, f"something is kept in {table}")
        return said.strip().splitlines()[-1]


def soak(settings):
    """A long session, its storage slowed: memory stays flat, and no frame waits for the disk."""
    if settings.usual_work_s is None:
        whole_study(settings)
    with settings.rig("soak") as rig:
        database = rig.folder / "soak.sqlite"
        slow = {"DEIXIS_STORAGE_DELAY_S": str(STORAGE_DELAY_S)}
        person, trace = begin(rig, database, study=long_study(rig, settings.soak_s), environment=slow)
        start = time.monotonic()
        resident = []  # (seconds, kB)

        def watch(_):
            resident.append((time.monotonic() - start, rig.deixis.resident_kb()))

        person.take_part(trace, Choices(), watch=watch)
        require_clean_end(rig)
        spent_s = resident[-1][0]
        (rig.folder / "memory.csv").write_text("".join(f"{at:.1f},{kb}\n" for at, kb in resident))
        warm_up_s = min(60.0, spent_s / 2)
        checks.check_exactly_given(database, person.given)
        late = [kb for at, kb in resident if at >= warm_up_s]
        # From peak to peak: memory that is given back for a while and taken again is no leak.
        half = len(late) // 2
        grown_mb = (max(late[half:]) - max(late[:half])) / 1024.0
        # SQLite's page cache, of 2 MB, is still filling in a short soak.
        flat_mb = 1.0 if spent_s - warm_up_s >= 60.0 else 2.0
        require(grown_mb <= flat_mb, f"memory grew by {grown_mb:.1f} MB after the first {warm_up_s:.0f} s")
        frames = checks.check_tracking(database)
        work_s = checks.work_of_frames(database)
        # Each answer and each event makes the writer busy for 0.2 s, and there are more of them than one in a hundred
        # frames: had frames waited for it, the slowest hundredth would show it. A single one is the machine's unrest.
        usual_s = settings.usual_work_s
        require(
            work_s.slow <= max(1.5 * usual_s.slow, STORAGE_DELAY_S)
            and work_s.median <= usual_s.median + STORAGE_DELAY_S / 4,
            f"frames took {work_s} with slow storage, and {usual_s} without",
        )
        require_valid(rig)
        return (
            f"{spent_s:.0f} s, {frames} frames of {work_s} (usually {usual_s}), "
            f"memory {grown_mb:+.2f} MB"
        )
