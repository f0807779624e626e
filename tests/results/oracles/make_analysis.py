"""Makes analysis.csv and analysis.json beside this script: made-up ratings from 0 to 100 in two groups, and what an
analysis must find in them.

Participants' means come from NumPy, p from SciPy's exact signed-rank and Mann-Whitney tests (the values are untied,
which is checked), quantiles from NumPy's linear interpolation, the Hodges-Lehmann estimates are medians of all Walsh
averages and of all differences, and Holm's adjustment is written out from his paper (1979). The program under test takes
no part.

Run: /usr/bin/python3 tests/results/oracles/make_analysis.py
Needs python3-scipy.
"""

import csv
import json
from itertools import combinations
from pathlib import Path

import numpy
import scipy.stats

draw = numpy.random.default_rng(11)
here = Path(__file__).parent
systems = ["a", "b", "c"]
lift = {"a": 0.0, "b": 6.0, "c": 9.0}
excluded = {"P03", "P08", "P12"}
failed = {"P05", "P17"}
rows = []
for number in range(1, 21):
    who = f"P{number:02}"
    group = "young" if number % 5 < 2 else "old"
    own = draw.normal(50.0, 8.0) + (7.0 if group == "old" else 0.0)
    for system in systems:
        for item in range(4):
            if number == 6 and system == "c" and item > 1:
                continue  # not balanced
            value = own + lift[system] + draw.normal(0.0, 9.0) - (35.0 if who in excluded and system != "a" else 0.0)
            rows.append({"participant": who, "measure": "appeal", "system": system, "item": f"T{item}",
                         "rating": round(float(numpy.clip(value, 0, 100)), 2), "group": group,
                         "excluded": "slept" if who in excluded else "", "marked": int(draw.uniform() < 0.15),
                         "attention": ""})
    rows.append({"participant": who, "measure": "", "system": "a", "item": "check", "rating": 1, "group": group,
                 "excluded": "slept" if who in excluded else "", "marked": "",
                 "attention": "failed" if who in failed else "passed"})


def holm(p):
    order = numpy.argsort(p)
    out = numpy.empty(len(p))
    running = 0.0
    for place, index in enumerate(order):
        running = max(running, min(1.0, (len(p) - place) * p[index]))
        out[index] = running
    return [float(one) for one in out]


def means(chosen):
    """participant -> system -> mean"""
    out = {}
    for row in chosen:
        out.setdefault(row["participant"], {}).setdefault(row["system"], []).append(row["rating"])
    return {who: {system: float(numpy.mean(values)) for system, values in of.items()} for who, of in out.items()}


def pairs(chosen):
    found = []
    of = means(chosen)
    for first, second in combinations(systems, 2):
        d = numpy.array([m[first] - m[second] for m in of.values() if first in m and second in m])
        assert len(set(numpy.round(abs(d), 9))) == len(d) and (d != 0).all()
        found.append({"a": first, "b": second, "n": len(d),
                      "p": float(scipy.stats.wilcoxon(d, method="exact").pvalue)})
    for one, p in zip(found, holm([one["p"] for one in found])):
        one["p_holm"] = p
    return {"participants": len(of), "answers": len(chosen), "pairs": found}


answers = [row for row in rows if row["attention"] == ""]
headline = [row for row in answers if not row["excluded"]]
fewer = [row for row in headline if not row["marked"] and row["participant"] not in failed]

group_of = {row["participant"]: row["group"] for row in rows}
of = means(headline)
between = []
for system in ["all"] + systems:
    scores = {"young": [], "old": []}
    for who, by_system in of.items():
        value = numpy.mean(list(by_system.values())) if system == "all" else by_system.get(system)
        if value is not None:
            scores[group_of[who]].append(float(value))
    young, old = numpy.array(scores["young"]), numpy.array(scores["old"])
    assert len(set(numpy.round(numpy.concatenate([young, old]), 9))) == len(young) + len(old)
    test = scipy.stats.mannwhitneyu(young, old, method="exact")
    differences = (young[:, None] - old[None, :]).ravel()
    a12 = float(numpy.mean(differences > 0))
    between.append({"system": system, "a": "young", "b": "old", "n_a": len(young), "n_b": len(old),
                    "mean_a": float(young.mean()), "mean_b": float(old.mean()), "u": float(test.statistic),
                    "p": float(test.pvalue), "a12": a12, "cliffs_delta": 2 * a12 - 1,
                    "hodges_lehmann": float(numpy.median(differences))})
for one, p in zip(between, holm([one["p"] for one in between])):
    one["p_holm"] = p

pooled = []
for system in systems:
    values = [row["rating"] for row in headline if row["system"] == system]
    q = numpy.percentile(values, [5, 25, 50, 75, 95])
    pooled.append({"system": system, "n": len(values), "mean": float(numpy.mean(values)),
                   "sd": float(numpy.std(values, ddof=1)), "quantiles": [float(one) for one in q],
                   "median_of_participants": float(numpy.median([m[system] for m in of.values() if system in m]))})

with open(here / "analysis.csv", "w", newline="") as out:
    writer = csv.DictWriter(out, fieldnames=list(rows[0]), lineterminator="\n")
    writer.writeheader()
    writer.writerows(rows)
(here / "analysis.json").write_text(json.dumps({"cases": [{
    "headline": pairs(headline), "with_left_out": pairs(answers), "without_doubtful": pairs(fewer),
    "between": between, "pooled": pooled}]}, indent=1) + "\n")
