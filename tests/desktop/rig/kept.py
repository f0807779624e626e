"""What the database must hold after a session whose person knows what was meant."""

import json

import borrowed  # noqa: F401
from checks import Database, require
from geometry import angle_deg, length, subtract

AVATAR_EYES = (0.0, 1.6, 0.1)
LATE_S = 3.0  # from the end of xdotool's press to the stored answer: frames are slow


class Study:
    """What the study asks, as the database says it."""

    def __init__(self, db):
        self.questions = {}
        for row in db.rows("select * from questions order by stage, position"):
            self.questions.setdefault(row["stage"], []).append(row)
        self.stages = {row["name"]: row for row in db.rows("select * from stages")}

    def task(self, stage):
        """The stage of which this one is the practice, or itself."""
        return self.stages[stage]["practice_of"] or stage


def check_whole_session(path, meant, station="desktop"):
    """Every planned unit was answered once, as it was meant, and the study is finished. How many."""
    with Database(path) as db:
        study = Study(db)
        outcomes = [row["outcome"] for row in db.rows("select outcome from sessions order by id")]
        require(outcomes and outcomes[-1] == "finished", f"the outcomes of the sessions are {outcomes}")
        kinds = {(row["station"], row["synthetic"]) for row in db.rows("select station, synthetic from sessions")}
        require(kinds == {(station, 0)}, f"the stations recorded are {sorted(kinds)}")
        trials = {
            row["trial_index"]: row
            for row in db.rows("select * from trials left join game_trials using (participant, trial_index)")
        }
        responses = {}
        for row in db.rows(
            "select r.*, g.chosen_place, g.correct from responses as r left join game_choices as g on g.response = r.id "
            "where r.superseded is null order by r.id"
        ):
            require(row["trial_index"] not in responses, f"trial {row['trial_index']} was answered twice")
            responses[row["trial_index"]] = row
        require(
            set(responses) == set(meant),
            f"answered: {sorted(responses)}; meant to be: {sorted(meant)}",
        )
        left = [t["trial_index"] for t in trials.values() if t["trial_index"] not in responses]
        spare = [i for i in left if trials[i]["practice"] and trials[i]["attempt"] > 0]
        require(left == spare, f"planned and not answered: {sorted(set(left) - set(spare))}")
        for index, response in sorted(responses.items()):
            check_answer(db, study, trials[index], response, meant[index])
        check_tracking(db, [i for i in responses if trials[i]["kind"] not in ("consent", "questionnaire")])
        return len(responses)


def check_answer(db, study, trial, response, meant):
    index = trial["trial_index"]
    require(response["status"] == "answered", f"trial {index} is {response['status']}")
    require(response["input"] == meant.by, f"trial {index} was answered by {meant.by}, not by {response['input']}")
    require(
        response["onset_s"] <= response["motion_end_s"] <= response["answered_s"],
        f"trial {index}: onset {response['onset_s']}, end {response['motion_end_s']}, answer {response['answered_s']}",
    )
    begun, ended = meant.pressed_utc_s
    require(
        begun - 0.05 <= response["answered_utc_s"] <= ended + LATE_S,
        f"trial {index} was answered {response['answered_utc_s'] - begun:.2f} s after the press began",
    )
    if meant.place >= 0:
        check_choice(trial, response, meant)
    else:
        require(response["chosen_place"] is None, f"trial {index}: a ball was chosen")
    rows = db.rows("select * from answers where response = ? order by position", response["id"])
    if meant.placed:
        check_placed(db, trial, response, meant, rows)
        return
    require(
        len(rows) == len(meant.answers), f"trial {index}: {len(rows)} answers instead of {len(meant.answers)}"
    )
    if trial["kind"] == "questionnaire":
        asked = [question["question"] for question in study.questions[trial["stage"]]]
        first = asked.index(rows[0]["question"])
        require(
            [row["question"] for row in rows] == asked[first : first + len(rows)],
            f"trial {index}: answers to {[row['question'] for row in rows]}, asked were {asked}",
        )
    for row, said in zip(rows, meant.answers):
        check_one(study, trial, row, said)
    if trial["check_kind"] == "number":
        shown = meant.number_shown.get(trial["check_stimulus"])
        require(shown == trial["check_expected"], f"trial {index}: the sign said {shown}")
        require(response["check_passed"] == 1, f"trial {index}: the number was given, and the check failed")
    else:
        require(not meant.number_shown, f"trial {index}: a sign was shown, {meant.number_shown}")


def check_choice(trial, response, meant):
    index = trial["trial_index"]
    balls = json.loads(trial["balls"])
    require(
        response["chosen_place"] == meant.place,
        f"trial {index}: ball {response['chosen_place']} is stored, {meant.place} was chosen",
    )
    apart = length(subtract(balls[meant.place], meant.ball))
    require(apart < 1e-3, f"trial {index}: the ball chosen is {apart:.3f} m from the one aimed at")
    require(
        response["correct"] == (meant.place == trial["target_place"]),
        f"trial {index}: 'correct' does not follow from the places",
    )


def check_placed(db, trial, response, meant, rows):
    """The ball lies where it was let go; distance and angle are those between there and the target."""
    index = trial["trial_index"]
    (kept,) = db.rows("select * from placements where response = ?", response["id"])
    placed = tuple(kept[f"placed_{axis}_m"] for axis in "xyz")
    require(
        length(subtract(placed, meant.placed)) < 1e-3,
        f"trial {index}: the ball is stored at {placed}, it was let go at {meant.placed}",
    )
    target = tuple(trial[f"target_{axis}_m"] for axis in "xyz")
    measured = {row["question"]: row["value"] for row in rows}
    off_cm = 100.0 * length(subtract(placed, target))
    require(
        abs(measured["distance"] - off_cm) < 0.02,
        f"trial {index}: {measured['distance']} cm are stored, the ball is {off_cm:.2f} cm off",
    )
    # As the avatar's eyes see it, about there.
    off_deg = angle_deg(*(subtract(point, AVATAR_EYES) for point in (placed, target)))
    require(
        abs(measured["angle"] - off_deg) < 6.0,
        f"trial {index}: {measured['angle']} degrees are stored, about {off_deg:.1f} are between ball and target",
    )


def check_one(study, trial, row, said):
    """One stored answer against what was meant by it."""
    index = trial["trial_index"]

    def same(key, wanted):
        require(row[key] == wanted, f"trial {index}, {row['question']}: {key} {row[key]!r}, meant was {wanted!r}")

    if row["question"] in ("consent", "preference"):
        same("value", said.value)
        return
    if row["question"] == "rating":
        low = study.stages[study.task(trial["stage"])]["scale_low"]
        same("value", said.value if said.value is not None else low + said.options[0])
        same("stimulus", said.stimulus if said.stimulus is not None else 0)
        return
    question = next(q for q in study.questions[study.task(trial["stage"])] if q["question"] == row["question"])
    options = [option["id"] for option in json.loads(question["options"] or "[]")]
    if question["kind"] == "scale":
        same("value", said.value if said.value is not None else question["low"] + said.options[0])
    elif question["kind"] == "choice":
        same("value", said.options[0])
        same("text", options[said.options[0]])
    elif question["kind"] == "choices":
        same("text", ";".join(options[place] for place in said.options))
    elif question["kind"] == "number":
        same("value", float(said.text))
    else:
        same("text", said.text)


def check_tracking(db, trials):
    """Head and hand were tracked throughout every trial."""
    tracked = {row["trial_index"] for row in db.rows("select trial_index from trial_tracking where frames > 5")}
    require(tracked >= set(trials), f"not tracked: {sorted(set(trials) - tracked)}")
    missing = db.value("select coalesce(sum(samples_missing), 0) from trial_tracking")
    require(missing == 0, f"{missing} samples went missing")
