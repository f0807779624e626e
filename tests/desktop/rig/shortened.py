"""Studies that ship, with fewer items: the same stages, boards and kinds of answer, in a minute or two."""

import re


SYSTEMS = {"rating": 2, "pairwise": 3, "referential-game": 2, "free-placement": 2}  # in stages that name none: the first so many


def shortened(text, items):
    """The study file's text with at most so many items and few systems in each stage, and with breaks that are short
    and come early."""
    head, *stages = text.split("[[stages]]")
    systems = re.findall(r'^\[\[systems\]\]\nname = "([^"]*)"', head, flags=re.MULTILINE)
    return "[[stages]]".join([head, *(shortened_stage(stage, items, systems) for stage in stages)])


def shortened_stage(text, items, systems):
    for key, most in (
        ("items", items), ("break_every", 3 * items), ("break_minimum_s", 2), ("minimum_s", 2), ("count", 1),
    ):
        line = re.compile(rf"^{key} = (\d+(?:\.\d+)?)", re.MULTILINE)
        text = line.sub(lambda found: f"{key} = {min(float(found[1]), most):g}", text)
    if items == 1:  # all of one target
        text = text.replace("no_target_twice_running = true", "no_target_twice_running = false")
    kind = re.search(r'^kind = "([a-z-]+)"$', text, flags=re.MULTILINE)
    if kind and kind[1] in SYSTEMS and not re.search("^systems = ", text, flags=re.MULTILINE):
        named = ", ".join(f'"{name}"' for name in systems[: SYSTEMS[kind[1]]])
        text = text.replace(kind[0], f"{kind[0]}\nsystems = [{named}]", 1)
    return text
