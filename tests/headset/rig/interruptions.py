"""What happens to a headset in the midst of a session: nobody wears it yet, taken off and put on, another program in
front, sight of the room lost, its space recentred. The conditions layer brings it about."""

import math

import checks
from attention import choosing, require_unanswered
from checks import Database, require
from geometry import Pose, angle_between_deg, length, multiply, subtract, turned_about_x, turned_about_y
from participant import FIRST_RATING, PAGES, Choices, Participant
from processes import until
from scenarios import require_clean_end, require_valid, tiny_study

GUESS_S = 0.5  # a guess too short to pause for
UNSEEN_S = 0.8  # longer than that
GAZE_DEG = (12.0, -8.0)  # left and up of straight ahead


def require_paused_until_resumed(rig, person, condition, reason, unfocused=True):
    """Under the condition the session is paused and takes no input; after it the participant resumes."""
    trace = rig.trace
    rig.conditions.say(condition)
    trace.wait(f"pause: {reason}", lambda line: line["state"] == "paused" and line["status"].endswith(reason))
    if unfocused:
        for pressed in (True, False):
            person.trigger(pressed, "right")
            person.button("b_click", pressed)
            trace.settle(0.3)
        require(trace.now["state"] == "paused", f"a press while '{reason}' has ended the pause")
        require(trace.now["ray"] is None, f"a ray is shown while '{reason}'")
    else:
        trace.settle(UNSEEN_S)
    rig.conditions.say("head tracked" if condition.startswith("head") else "state focused")
    trace.settle(0.4)
    require(trace.now["state"] == "paused", f"the session went on by itself after '{reason}'")
    person.resume(trace)


def require_frames_paired(rig):
    """Every frame begun was ended, and none had a picture that was not wanted."""
    counts = rig.conditions.counts()
    require(counts["begun"] == counts["ended"] > 50, f"frames begun and ended: {counts}")
    require(counts["pictures_in_hidden"] == 0, f"pictures were handed over that nobody wanted: {counts}")
    return counts


def interrupted_participant(settings):
    """One session: not worn at first, taken off, out of focus, sight lost, recentred by the runtime."""
    with settings.rig("interrupted") as rig:
        database = rig.folder / "tiny.sqlite"
        rig.start_service()
        person = Participant(rig.remote)
        trace = rig.run(tiny_study(rig), database, conditions=["state synchronized"])
        until("opened station", lambda: "headset station" in rig.deixis.text(), 60.0)
        trace.settle(0.7)
        require(trace.now is None, "the session began though nobody wore the headset")
        rig.conditions.say("state focused")
        trace.wait("first page", lambda line: line["state"] in PAGES)
        choices = Choices()

        def play(until_line):
            person.take_part(trace, choices, stop=until_line)

        # During the clip: it starts over.
        play(lambda line: line["state"] == "playing")
        off = trace.now["trial"]
        require_paused_until_resumed(rig, person, "state synchronized", "headset taken off")
        trace.wait("clip from its beginning", lambda line: line["state"] == "playing" and line["trial"] == off)
        # With the answer open: it is opened again.
        play(lambda line: line["state"] == "rating" and line["trial"] != off)
        unfocused = trace.now["trial"]
        person.hover_button(trace, FIRST_RATING)
        require_paused_until_resumed(rig, person, "state visible", "focus lost")
        require(trace.now["state"] == "rating", f"after the pause came '{trace.now['state']}', not the rating")

        play(choosing)
        lost = trace.now["trial"]
        blink(rig, trace, "lost")
        blink(rig, trace, "turning")
        rig.conditions.say("head guessed")
        trace.settle(GUESS_S)
        rig.conditions.say("head tracked")
        trace.settle(0.3)
        require(choosing(trace.now), f"a short loss of sight has led to '{trace.now['state']}'")
        require_paused_until_resumed(rig, person, "head lost", "tracking lost", unfocused=False)
        require_unanswered(trace, "resuming")

        play(lambda line: choosing(line) and line["trial"] > lost)
        guessed = trace.now["trial"]
        require_paused_until_resumed(rig, person, "head guessed", "tracking lost", unfocused=False)
        play(lambda line: choosing(line) and line["trial"] > guessed)
        recentred = trace.now["trial"]
        shift = recentre(rig, person, trace)
        play(None)
        require_clean_end(rig)
        count = checks.check_exactly_given(database, person.given)
        require(count == 6, f"{count} answers instead of 6")
        checks.check_balls(database, person.given)
        checks.check_places(database)
        counts = require_frames_paired(rig)
        with Database(database, tracking=True) as db:
            reasons = [r["detail"] for r in db.rows("select detail from events where kind = 'pause' order by id")]
            wanted = ["headset taken off", "focus lost", "tracking lost", "tracking lost"]
            require(reasons == wanted, f"the pauses are {reasons}")
            pauses = {r["trial_index"]: r["pauses"] for r in db.rows("select * from responses")}
            want = {trial: int(trial in (off, unfocused, lost, guessed)) for trial in pauses}
            require(pauses == want, f"the trials' interruptions are {pauses}, not {want}")
            unseen = check_lost_tracking(db, lost)
            check_hidden(db, off, counts)
            check_recentred(db, recentred)
        require_valid(rig)
        hidden = counts["hidden"]
        return f"{count} answers, {hidden} frames hidden, {unseen} without a head, recentred by {shift:.2f} m"


def blink(rig, trace, kind):
    """A loss of sight of a single frame: too short to pause for."""
    rig.conditions.say(f"head {kind}", "wait 1", "head tracked")
    trace.settle(0.4)


def recentre(rig, person, trace):
    """The participant stands off the place and is out of sight for a moment, which brings nobody back; the runtime
    moves its space; this is the place from then on."""
    person.step_aside(0.6)
    trace.wait("request to step back", lambda line: "back" in line["notice"].lower())
    blink(rig, trace, "lost")
    placed = len(trace.note("placement"))
    rig.conditions.say("recentre 0.5 -0.3 40 300")
    trace.wait("another place", lambda line: len(trace.note("placement")) > placed)
    trace.wait("no notice", lambda line: line["notice"] == "")
    trace.settle(0.3)
    person.room_from_tracking = Pose((0.5, 0.0, -0.3), turned_about_y(40.0))
    person.anchor = Pose(person.anchor.point((0.6, 0.0, 0.0)), person.anchor.orientation)
    person.step_aside(0.0)
    return math.hypot(0.5, 0.3)


def check_lost_tracking(db, trial):
    """Frames without a head say so and hold no pose, and none of them had a picture; guesses are marked."""
    rows = db.rows("select * from tracking where trial_index = ?", trial)
    kinds = {
        0: lambda r: r["head_x_m"] is None and r["head_qw"] is None and not r["rendered"],
        2: lambda r: r["head_x_m"] is None and r["head_qw"] is not None and not r["rendered"],
        3: lambda r: r["head_x_m"] is not None and r["head_qw"] is not None and r["rendered"],
        7: lambda r: r["head_x_m"] is not None and r["head_qw"] is not None and r["rendered"],
    }
    for row in rows:
        kind = row["head_validity"]
        require(kind in kinds and kinds[kind](row), f"frame {row['frame']}: {dict(row)}")
    met = {kind: sum(row["head_validity"] == kind for row in rows) for kind in kinds}
    require(all(met.values()), f"frames by the head's validity: {met}")
    marked = db.value("select head_untracked_frames from trial_tracking where trial_index = ?", trial)
    require(marked == len(rows) - met[7], f"{marked} frames are counted as untracked, {met} were")
    return met[0]


def check_hidden(db, trial, counts):
    """While it was off there was no picture, and no hand was recorded as seen."""
    hidden = db.rows("select * from tracking where trial_index = ? and rendered = 0", trial)
    require(0 < len(hidden) <= counts["hidden"], f"{len(hidden)} of the trial's frames were hidden")
    seen = [row["frame"] for row in hidden if row["right_aim_validity"] or row["left_aim_validity"]]
    require(not seen, f"hands were seen without focus in the frames {seen}")


def check_recentred(db, trial):
    """The participant is off the place, then on it and looks the layout's way; never anywhere else."""
    by = [row["detail"] for row in db.rows("select detail from events where kind = 'recentre'")]
    require(by == ["runtime"], f"the recentrings recorded are {by}")
    layout = db.rows(
        "select l.* from trials t join layouts l on l.name = t.layout where t.trial_index = ?", trial
    )[0]
    kinds = "('off_place', 'back_on_place')"
    told = [r["kind"] for r in db.rows(f"select * from events where kind in {kinds} and trial_index = ?", trial)]
    require(told == ["off_place", "back_on_place"], f"of the place was told {told}")
    query = "select * from tracking where trial_index = ? and head_validity = 7 order by frame"
    rows = db.rows(query, trial)
    strayed = [i for i, row in enumerate(rows) if row["off_place_m"] > 0.5]
    require(strayed, "the participant was never off the place")
    after = rows[strayed[-1] + 1]
    for row in rows:
        off = row["off_place_m"]
        require(off < 0.15 or 0.5 < off < 0.7, f"frame {row['frame']}: the head is {off:.2f} m from the place")
    heading = turned_about_y(layout["heading_deg"] + 180.0)  # it turns from +z, a person looks along -z
    turned = angle_between_deg(quaternion(after, "head"), heading)
    off = after["off_place_m"]
    require(off < 0.01 and turned < 1.0, f"recentred {off:.3f} m and {turned:.1f} degrees off")


def quaternion(row, name):
    return tuple(row[f"{name}_{part}"] for part in ("qw", "qx", "qy", "qz"))


def repeated_trials(settings):
    """A study that repeats interrupted trials, and asks for the gaze; with tracked eyes."""
    with settings.rig("repeated") as rig:
        database = rig.folder / "tiny.sqlite"
        study = tiny_study(rig)
        text = study.read_text().replace("inter_trial_s = 0.2", 'inter_trial_s = 0.2\nafter_interruption = "repeat"')
        study.write_text(text.replace("items = 2", "items = 1"))  # of the game
        rig.start_service()
        person = Participant(rig.remote)
        yaw, pitch = GAZE_DEG
        trace = rig.run(study, database, conditions=[f"gaze seen {yaw} {pitch}"])
        trace.wait("first page", lambda line: line["state"] in PAGES, 60.0)
        choices = Choices()
        repeated = []

        def interrupt(line, condition, reason):
            repeated.append(line["trial"])
            person.take_part(trace, choices, stop=lambda now: now is line)
            require_paused_until_resumed(rig, person, condition, reason)
            trace.wait("the clip once more", lambda now: now["state"].startswith("playing"))
            require(trace.now["trial"] == repeated[-1], "another trial came after the interruption")

        person.take_part(trace, choices, stop=lambda line: line["state"] == "rating")
        interrupt(trace.now, "state synchronized", "headset taken off")
        person.take_part(trace, choices, stop=choosing)
        interrupt(trace.now, "state visible", "focus lost")
        rig.conditions.say("gaze lost 0 0")
        trace.settle(0.3)
        rig.conditions.say(f"gaze guessed {yaw} {pitch}")
        trace.settle(0.3)
        rig.conditions.say(f"gaze seen {yaw} {pitch}")
        person.take_part(trace, choices)
        require_clean_end(rig)
        count = checks.check_exactly_given(database, person.given)
        require(count == 4, f"{count} answers instead of 4")
        require_frames_paired(rig)
        checks.check_times(database, person.given)
        with Database(database, tracking=True) as db:
            check_repeated(db, repeated)
            gazes = check_gaze(db)
        require_valid(rig)
        return f"{count} answers, trials {repeated} repeated, {gazes} gazes"


def check_repeated(db, repeated):
    """They are marked, were begun twice, and the answer's times are those of the second time."""
    marked = [r["trial_index"] for r in db.rows("select * from events where kind = 'trial_repeated' order by id")]
    require(marked == repeated, f"the trials marked as repeated are {marked}, {repeated} were")
    for row in db.rows("select * from responses"):
        trial = row["trial_index"]
        again = int(trial in repeated)
        onsets = [
            r["time_s"]
            for r in db.rows("select * from events where kind = 'stimulus_onset' order by id")
            if r["trial_index"] == trial
        ]
        require(len(onsets) == 1 + again, f"trial {trial} was begun {len(onsets)} times")
        require(abs(row["onset_s"] - onsets[-1]) < 1e-6, f"trial {trial}: the onset is not that of the last time")
        require(row["pauses"] == again and row["paused_s"] == 0.0, f"trial {trial}: {dict(row)}")


def gaze_off(row, head, turned):
    """Degrees and metres between the gaze and where the head had it."""
    moved = subtract(*[tuple(of[f"{what}_{axis}_m"] for axis in "xyz") for of, what in ((row, "gaze"), (head, "head"))])
    return angle_between_deg(quaternion(row, "gaze"), multiply(quaternion(head, "head"), turned)), length(moved)


def check_gaze(db):
    """Seen, guessed and lost gazes are recorded as such; those seen are turned from the head as the eyes were."""
    asked = db.value("select value from session_properties where name = 'eye_gaze'")
    require(asked == "yes", f"the session's properties say of the gaze: {asked}")
    rows = db.rows("select * from tracking")
    without = {row["frame"] for row in rows if row["gaze_validity"] is None}
    require(not without, f"{len(without)} frames say nothing of the gaze")
    turned = multiply(turned_about_y(GAZE_DEG[0]), turned_about_x(GAZE_DEG[1]))
    met = {}
    for before, row in zip(rows[:1] + rows, rows):
        met[row["gaze_validity"]] = met.get(row["gaze_validity"], 0) + 1
        if row["gaze_validity"] == 0:
            require(row["gaze_x_m"] is None and row["gaze_qw"] is None, f"frame {row['frame']} has a gaze not seen")
            continue
        # The rig's head jumps, perhaps between the program's asking for the gaze and for the head.
        off = [gaze_off(row, head, turned) for head in (row, before)]
        near = any(apart < 0.2 and moved < 0.001 for apart, moved in off)
        require(near, f"frame {row['frame']}: the gaze is off by (degrees, metres) {off}")
    require(set(met) == {0, 3, 7} and met[7] > 100, f"gazes by validity: {met}")
    return met[7]
