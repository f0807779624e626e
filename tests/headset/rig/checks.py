"""What the database must hold after a session whose participant knows what it did."""

import json
import sqlite3
import statistics
from dataclasses import dataclass

import tracked
from geometry import Pose, angle_between_deg, length, subtract, turned_about_y


class Check(AssertionError):
    pass


def require(condition, message):
    if not condition:
        raise Check(message)


class Database:
    """Read only, while the program may still write. `tracking`: tracked frames are unpacked, into a table of that
    name."""

    def __init__(self, path, tracking=False):
        self._connection = sqlite3.connect(f"file:{path}?mode=ro", uri=True, timeout=5.0)
        self._connection.row_factory = sqlite3.Row
        if tracking:
            tracked.unpack(self._connection)

    def rows(self, query, *values):
        return self._connection.execute(query, values).fetchall()

    def value(self, query, *values):
        return self._connection.execute(query, values).fetchone()[0]

    def close(self):
        self._connection.close()

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.close()


# With what single ratings and choices came to.
RESPONSES = (
    "select r.*, t.stage, t.practice, a.value as rating, g.chosen_place from responses r "
    "join trials t on t.participant = r.participant and t.trial_index = r.trial_index "
    "left join game_choices g on g.response = r.id "
    "left join answers a on a.response = r.id and a.question = 'rating'"
)


def answers(path):
    """(trial, rating or place) of every stored answer, in order."""
    with Database(path) as db:
        return [
            (row["trial_index"], row["rating"] if row["rating"] is not None else row["chosen_place"])
            for row in db.rows(f"{RESPONSES} order by r.trial_index")
        ]


def frame_period_s(db):
    """The median time between the frames of all sessions."""
    times = [row[0] for row in db.rows("select display_time_s from tracking order by session, frame")]
    steps = [b - a for a, b in zip(times, times[1:]) if b > a]
    require(len(steps) > 20, f"only {len(steps) + 1} frames were tracked")
    return statistics.median(steps)


def check_exactly_given(path, given):
    """The answers are the participant's, one for one, those of the practice too. How many are scored."""
    with Database(path) as db:
        stored = {row["trial_index"]: row for row in db.rows(RESPONSES)}
        require(
            set(stored) == set(given),
            f"answers to the trials {sorted(stored)} are stored, to {sorted(given)} they were given",
        )
        require(db.value("select count(*) from responses") == len(stored), "a trial was answered twice")
        for index, row in stored.items():
            want = given[index]
            got = (row["rating"] or 0, row["chosen_place"] if row["chosen_place"] is not None else -1)
            require(
                got == (want.rating, want.place),
                f"trial {index}: rating and place {got} are stored, {(want.rating, want.place)} were given",
            )
            require(row["status"] == "answered", f"trial {index} is {row['status']}")
            require(row["input"] == "ray", f"trial {index} was answered by '{row['input']}'")
        scored = db.value("select count(*) from responses_flat where scored = 1")
        require(
            scored == sum(not row["practice"] for row in stored.values()),
            f"{scored} answers are scored of {len(stored)}",
        )
        return scored


def check_balls(path, given):
    """The chosen place is the ball that the participant saw and aimed at; `correct` follows from it."""
    with Database(path) as db:
        for row in db.rows(
            "select trial_index, balls, target_place, chosen_place, correct from game_trials join game_choices "
            "using (participant, trial_index)"
        ):
            balls = json.loads(row["balls"])
            aimed = given[row["trial_index"]].ball
            apart = length(subtract(balls[row["chosen_place"]], aimed))
            require(apart < 1e-3, f"trial {row['trial_index']}: the ball chosen is {apart:.3f} m from the one aimed at")
            require(
                row["correct"] == (row["chosen_place"] == row["target_place"]),
                f"trial {row['trial_index']}: 'correct' does not follow from the places",
            )


def check_times(path, given):
    """Onset, end of the motion and answer in order; response times those of the presses."""
    with Database(path, tracking=True) as db:
        period = frame_period_s(db)
        for row in db.rows("select * from responses"):
            trial = row["trial_index"]
            require(
                row["onset_s"] < row["motion_end_s"] < row["answered_s"],
                f"trial {trial}: onset {row['onset_s']}, motion end {row['motion_end_s']}, answer {row['answered_s']}",
            )
            between = row["answered_s"] - row["motion_end_s"] - row["paused_s"]
            require(
                abs(row["response_time_s"] - between) < 1e-6,
                f"trial {trial}: response time {row['response_time_s']} s, but {between} s from motion end to answer",
            )
            late = row["answered_utc_s"] - given[trial].pressed_utc_s
            require(
                -0.005 <= late <= 2.5 * period,
                f"trial {trial}: the trigger was pulled {late * 1e3:.0f} ms before the stored answer, "
                f"a frame takes {period * 1e3:.0f} ms",
            )
        return period


def check_heads(path, given, anchor):
    """The heads are stored where the participant held them: at the place of the trial's layout, looking its way, as
    far off it as they were held off `anchor`, the place in the room."""
    with Database(path) as db:
        for row in db.rows(
            "select r.*, l.viewer_x_m, l.viewer_z_m, l.heading_deg from responses r join trials t on "
            "t.participant = r.participant and t.trial_index = r.trial_index join layouts l on l.name = t.layout"
        ):
            trial = row["trial_index"]
            # A heading turns from +z, a person looks along -z.
            viewer = Pose((row["viewer_x_m"], 0.0, row["viewer_z_m"]), turned_about_y(row["heading_deg"] + 180.0))
            held = viewer * anchor.inverse() * given[trial].head
            apart = length(subtract((row["head_x_m"], row["head_y_m"], row["head_z_m"]), held.position))
            require(apart < 0.02, f"trial {trial}: the stored head is {apart:.3f} m from where it was held")
            stored = (row["head_qw"], row["head_qx"], row["head_qy"], row["head_qz"])
            turned = angle_between_deg(stored, held.orientation)
            require(turned < 1.0, f"trial {trial}: the stored head is turned {turned:.2f} degrees from how it was held")


def check_tracking(path):
    """A row a frame, times going up, the head measured throughout."""
    with Database(path, tracking=True) as db:
        rows = db.rows("select * from tracking order by session, frame")
        require(len(rows) > 100, f"only {len(rows)} frames were tracked")
        for before, after in zip(rows, rows[1:]):
            if before["session"] != after["session"]:
                continue
            require(
                after["display_time_s"] > before["display_time_s"] and after["begun_s"] > before["begun_s"],
                f"frame {after['frame']} is not later than the one before",
            )
            require(
                before["begun_s"] <= before["submitted_s"] <= after["begun_s"] + 1e-3,
                f"frame {before['frame']} was begun and submitted out of order",
            )
        untracked = sum(row["head_validity"] != 7 for row in rows)
        require(untracked <= 5, f"the head was not tracked in {untracked} of {len(rows)} frames")
        missing = db.value("select coalesce(sum(samples_missing), 0) from trial_tracking")
        require(missing == 0, f"{missing} samples went missing")
        return len(rows)


def check_places(path):
    """In each trial's frames the head is as far from the place of the trial's layout as is recorded."""
    with Database(path, tracking=True) as db:
        for row in db.rows(
            "select k.*, l.viewer_x_m, l.viewer_z_m from tracking k join sessions s on s.id = k.session "
            "join trials t on t.participant = s.participant and t.trial_index = k.trial_index "
            "join layouts l on l.name = t.layout where k.head_validity = 7"
        ):
            away = (row["head_x_m"] - row["viewer_x_m"], row["head_z_m"] - row["viewer_z_m"])
            require(
                abs(length(away) - row["off_place_m"]) < 0.01,
                f"frame {row['frame']} of trial {row['trial_index']}: the head is {length(away):.2f} m from the place, "
                f"{row['off_place_m']:.2f} m are recorded",
            )


@dataclass
class Work:
    """What frames took, from their beginning to their handing over, in seconds."""

    median: float
    slow: float  # longer than in 99 of 100 frames
    longest: float

    def __str__(self):
        return f"{self.median * 1e3:.0f} ms, 99 % within {self.slow * 1e3:.0f} ms, at most {self.longest * 1e3:.0f} ms"


def work_of_frames(path):
    with Database(path, tracking=True) as db:
        rows = db.rows("select submitted_s - begun_s as work_s from tracking order by session, frame")
    work_s = sorted(row["work_s"] for row in rows[20:])  # the first ones load things
    return Work(statistics.median(work_s), work_s[len(work_s) * 99 // 100], work_s[-1])


def check_joints(path):
    """Hands of 26 joints were recorded, all within an arm's length of their controller."""
    with Database(path) as db:
        count = db.value("select count(*) from hand_joints where length(flags) = 26")
        require(count > 100, f"only {count} hands were recorded")
