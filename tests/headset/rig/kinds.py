"""A session with every kind of stage and question that a headset can show: what is answered is kept, and each state is
pictured."""

import re

import desktop  # noqa: F401
import checks
import kept
from checks import Database, require
from participant import Participant
from person import Person
from pictures import DRAWN_SMALLER, SCREEN, Camera, Photographer
from ray_hands import RayHands, field
from scenarios import HERE, require_clean_end, require_valid

STUDY = HERE / "kinds.toml"
PICTURES = (
    ["consent-consent", "instructions", "rest", "goodbye"]
    + [f"about-you-questionnaire-{page}{how}" for page in (1, 2) for how in ("", "-answered")]
    + [f"parallel-{state}" for state in ("watching", "watching-answered", "check")]
    + [f"pair-{state}" for state in ("comparing", "comparing-answered", "playing", "reasons", "reasons-answered")]
    + [f"naturalness-{state}" for state in ("playing", "rating", "rating-answered")]
    + [f"game-{state}-{layout}" for state in ("pointing", "choosing", "aiming", "confidence")
       for layout in ("across", "side-by-side")]
    + ["game-practice-feedback-side-by-side", "placement-choosing-across", "placement-choosing-across-answered",
       "placement-aiming-across", "placement-practice-feedback-across"]
)


class RayPerson(Person):
    """Answers boards as the desktop's person does, but with the ray and without a keyboard."""

    def __init__(self, hands, seed):
        super().__init__(hands.trace, hands.mouse, seed)
        self.hands = hands

    def _by_key(self, share):
        return False

    def _type(self, number):
        low, high = re.findall(r"-?\d+(?:\.\d+)?", field(self.hands.look(), number)["hint"])
        if "." in low + high:
            text = f"{self._random.uniform(float(low), float(high)):.1f}"
        else:
            text = str(self._random.randint(int(low), int(high)))
        self.hands.type_into(number, text)
        return text


def every_kind(settings):
    """The whole of kinds.toml, in front of the runtime's real compositor."""
    with settings.rig("kinds", compositor="xcb", screen=SCREEN) as rig:
        database = rig.folder / "kinds.sqlite"
        rig.start_service()
        body = Participant(rig.remote)
        trace = rig.run(STUDY, database, *DRAWN_SMALLER)
        trace.wait("consent", lambda line: line["state"] == "consent" and line["frame"] > 3, 60.0)
        camera = Camera(rig, settings.pictures)
        camera.clear_view()
        photographer = Photographer(camera, trace, PICTURES)
        person = RayPerson(RayHands(trace, body, photographer.came_up, photographer.before_press), seed=3)
        person.take_part()
        require_clean_end(rig, 60.0)
        units = kept.check_whole_session(database, person.meant, station="headset")
        checks.check_tracking(database)
        check_participant(database)
        require(person.hands.slips == 1, "no slip was made on the pad of a number")
        require(any(one.number_shown for one in person.meant.values()), "no number was shown to be given")
        missing = [name for name in PICTURES if name not in camera.taken]
        require(not missing, f"no picture was taken of {missing}")
        camera.require_lit()
        require_valid(rig)
        count = sum(len(one.answers) for one in person.meant.values())
        return f"{count} answers to {units} boards, {len(camera.taken)} pictures in {settings.pictures}"


def check_participant(database):
    """Answers about the participant are the participant's fields too; what needs a keyboard was not asked."""
    with Database(database) as db:
        fields = {row["field"]: (row["value"], row["text"]) for row in db.rows("select * from participant_fields")}
        answers = db.rows(
            "select a.* from answers a join responses r on r.id = a.response "
            "join trials t using (participant, trial_index) where t.stage = 'about-you'"
        )
    require(len(answers) == 5 and "words" not in fields, f"of the participant is kept {fields}")
    for row in answers:
        answered = (row["value"], row["text"])
        require(
            fields.get(row["question"]) == answered,
            f"{row['question']} of the participant is {fields.get(row['question'])}, the answer was {answered}",
        )
