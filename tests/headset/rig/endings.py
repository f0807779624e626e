"""How a session ends before its end, by the runtime: no headset, its menu, session or instance lost. Each time the same
command goes on, in whatever spaces the runtime has. The conditions layer brings it about."""

import math

import checks
from attention import choosing
from checks import Database, require
from participant import PAGES, Choices, Participant
from processes import until
from scenarios import require_clean_end, require_valid, tiny_study

SMALL_M = 1.40  # the participant's eyes; the study assumes them at ASSUMED_M where no floor is known
ASSUMED_M = 1.65


class Sessions:
    """One participant's runs of the same command."""

    def __init__(self, rig):
        self.rig = rig
        self.database = rig.folder / "tiny.sqlite"
        study = tiny_study(rig)
        self.study = rig.folder / "unseen.toml"  # asks for no gaze, whatever the headset offers
        self.study.write_text(study.read_text().replace("record_gaze = true", "record_gaze = false"))
        self.choices = Choices()
        self.person = Participant(rig.remote, eye_height_m=SMALL_M)
        self.runs = 0
        self.answered = []

    def run(self, *conditions):
        self.runs += 1
        return self.rig.run(self.study, self.database, conditions=conditions)

    def resume(self, *conditions):
        """Up to the first page; all answers so far are there."""
        trace = self.run(*conditions)
        trace.wait("first page", lambda line: line["state"] in PAGES, 60.0)
        first = "welcome-back" if self.answered else "instructions"
        require(trace.now["state"] == first, f"run {self.runs} began with '{trace.now['state']}'")
        require(checks.answers(self.database) == self.answered, "earlier answers are not as they were")
        return trace

    def answer_one(self, trace):
        """Answers a trial, and goes on into the next one's clip. Its index."""
        before = len(self.person.given)
        self.person.take_part(
            trace, self.choices,
            stop=lambda line: len(self.person.given) > before and line["state"].startswith("playing"),
        )
        return trace.now["trial"]

    def require_ended(self, why, outcome="quit"):
        """With status 1 and a message; the answers are kept, and the session says how it ended."""
        log = self.rig.deixis.log
        status = self.rig.deixis.wait(30.0)
        said = self.rig.deixis.text()
        require(status == 1, f"run {self.runs} ended with status {status}; see {log}")
        message = said[said.rfind("deixis: error:"):].strip()
        require("deixis: error:" in said and why in message, f"run {self.runs} said '{message}'; see {log}")
        require("same command" in message, f"run {self.runs} did not say how to go on: '{message}'")
        self.answered = checks.answers(self.database)
        require(len(self.answered) == len(self.person.given), f"run {self.runs} has kept {self.answered}")
        counts = self.rig.conditions.counts()
        require(counts["pictures_in_hidden"] == 0, f"run {self.runs}: {counts}")
        with Database(self.database) as db:
            ended = db.value("select outcome from sessions order by id desc limit 1")
            require(ended == outcome, f"run {self.runs} is recorded as '{ended}'")
            reason = db.value("select detail from events where kind = 'quit' order by id desc limit 1")
            require("runtime" in reason, f"run {self.runs} is recorded as ended by '{reason}'")
        return counts

    def notes(self, kind):
        """Of the last session."""
        with Database(self.database) as db:
            last = "select max(id) from sessions"
            rows = db.rows(f"select detail from events where kind = ? and session = ({last}) order by id", kind)
        return [row["detail"] for row in rows]

    def space(self):
        with Database(self.database) as db:
            rows = db.rows("select * from session_properties where session = (select max(id) from sessions)")
        return {row["name"]: row["value"] for row in rows}


def ended_by_runtime(settings):
    """No headset; then the runtime's menu, both announced losses, sudden ones; each time the same command goes on."""
    with settings.rig("endings") as rig:
        rig.start_service()
        sessions = Sessions(rig)

        sessions.run("headset missing")
        status = rig.deixis.wait(30.0)
        said = rig.deixis.text()
        require(status == 1, f"without a headset the program ended with status {status}")
        require("finds no headset" in said, f"it did not say that there is no headset; see {rig.deixis.log}")

        # A runtime that knows no floor; its menu ends the session.
        trace = sessions.resume(f"spaces local {SMALL_M}", "gaze seen 0 0")
        require("no floor" in rig.deixis.text(), f"nobody was told that no floor is known; see {rig.deixis.log}")
        sessions.answer_one(in_local_space(sessions.person, trace))
        rig.conditions.say("exit")
        counts = sessions.require_ended("ended the session")
        require(counts["begun"] == counts["ended"], f"frames begun and ended: {counts}")
        require(sessions.notes("xr_state")[-1] == "exiting", f"states: {sessions.notes('xr_state')}")
        properties = sessions.space()
        require(properties["space"] == "local", f"the space recorded is '{properties['space']}'")
        assumed = properties.get("assumed_eye_height_m")
        require(assumed and abs(float(assumed) - ASSUMED_M) < 1e-6, f"the eye height recorded is {assumed}")
        require(properties["eye_gaze"] == "no", "the study asks for no gaze")
        check_eye_height(sessions, ASSUMED_M)

        # A runtime with a floor and no stage; it announces the loss of the session.
        sessions.person.room_from_tracking.position = (0.0, 0.0, 0.0)
        trace = sessions.resume("spaces local_floor", "gaze seen 0 0")
        sessions.answer_one(trace)
        require(sessions.space()["space"] == "local floor", f"the space is {sessions.space()['space']}")
        require("assumed_eye_height_m" not in sessions.space(), "an eye height is assumed though a floor is known")
        rig.conditions.say("announce session-loss")
        counts = sessions.require_ended("was lost")
        require("loss pending" in sessions.notes("xr_state"), f"states: {sessions.notes('xr_state')}")
        check_eye_height(sessions, SMALL_M)

        # Lost without a word, with a frame open.
        trace = sessions.resume()
        sessions.person.take_part(trace, sessions.choices, stop=choosing)
        rig.conditions.say("lose instance xrEndFrame")
        sessions.require_ended("XR_ERROR_INSTANCE_LOST")

        # Nobody has put it on yet.
        trace = sessions.run("state synchronized")
        until("opened station", lambda: "headset station" in rig.deixis.text(), 60.0)
        rig.conditions.say("exit")
        sessions.require_ended("ended the session")

        trace = sessions.resume()
        sessions.answer_one(trace)
        rig.conditions.say("announce instance-loss")
        sessions.require_ended("was lost")
        require("instance loss pending" in sessions.notes("xr_state"), f"states: {sessions.notes('xr_state')}")

        trace = sessions.resume()
        sessions.answer_one(trace)
        rig.conditions.say("lose session xrSyncActions")
        sessions.require_ended("XR_ERROR_SESSION_LOST")

        trace = sessions.resume()
        sessions.person.take_part(trace, sessions.choices)
        require_clean_end(rig)
        count = checks.check_exactly_given(sessions.database, sessions.person.given)
        require(count == 6, f"{count} answers instead of 6")
        with Database(sessions.database, tracking=True) as db:
            seen = db.value("select count(*) from tracking where gaze_validity is not null")
            require(seen == 0, f"{seen} frames say something of a gaze that the study did not ask for")
        for run in range(2, sessions.runs + 1):
            require_valid(rig, run)
        return f"{count} answers in {sessions.runs - 1} sessions"


def in_local_space(person, trace):
    """The program takes the floor to be as far below the eyes as it assumes."""
    person.room_from_tracking.position = (0.0, SMALL_M - ASSUMED_M, 0.0)
    return trace


def check_eye_height(sessions, height_m):
    """The last session's heads are that high, within what the participant leans."""
    with Database(sessions.database, tracking=True) as db:
        rows = db.rows(
            "select head_y_m from tracking where session = (select max(id) from sessions) and head_validity = 7"
        )
    middle = sum(row["head_y_m"] for row in rows) / max(1, len(rows))
    require(rows and math.isclose(middle, height_m, abs_tol=0.03), f"the eyes are at {middle:.2f} m, not {height_m} m")
