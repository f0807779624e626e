"""Makes evaluation_pairs.json beside this script: accuracies of systems' clips, and how the systems differ over
the targets that both were made for.

Pairs are made from the clips with NumPy, p comes from SciPy's exact signed-rank test (of differences without ties;
zeros are left out before, as Wilcoxon did), the Hodges-Lehmann estimate is the median of all Walsh averages, and
Holm's adjustment is written out from his paper (1979). The program under test takes no part.

Run: /usr/bin/python3 tests/results/oracles/make_evaluation_pairs.py
Needs python3-scipy.
"""

import json
from pathlib import Path

import numpy
import scipy
import scipy.stats

draw = numpy.random.default_rng(2023)


def clip(system, target, accuracy):
    # Degrees need not follow from the accuracy here: both are only averaged.
    error = None if accuracy is None else round(float(draw.uniform(0.0, 60.0)), 3)
    return {"system": system, "target": target, "accuracy": accuracy, "error_deg": error}


def by_target(clips, system, key):
    """Target -> mean over the system's clips that have an accuracy."""
    found = {}
    for c in clips:
        if c["system"] == system and c["accuracy"] is not None:
            found.setdefault(tuple(c["target"]), []).append(c[key])
    return {target: numpy.mean(values) for target, values in found.items()}


def holm(p):
    """Steps down from the smallest: p_(i) times the number of hypotheses left, never below one before."""
    p = numpy.array([numpy.nan if x is None else x for x in p], dtype=float)
    known = numpy.flatnonzero(~numpy.isnan(p))
    order = known[numpy.argsort(p[known], kind="stable")]
    steps = p[order] * (len(order) - numpy.arange(len(order)))
    out = numpy.full(len(p), numpy.nan)
    out[order] = numpy.minimum(1.0, numpy.maximum.accumulate(steps))
    return [None if numpy.isnan(x) else float(x) for x in out]


def pair(clips, a, b):
    first, second = (by_target(clips, s, "accuracy") for s in (a, b))
    first_deg, second_deg = (by_target(clips, s, "error_deg") for s in (a, b))
    shared = [t for t in first if t in second]
    out = {"a": a, "b": b, "n": len(shared)}
    if not shared:
        return out | dict.fromkeys(["mean_difference", "sd", "mean_difference_deg", "estimate", "w_plus", "p"])
    d = numpy.round([first[t] - second[t] for t in shared], 9)
    rest = d[d != 0.0]
    assert len(set(abs(rest))) == len(rest), "ties: SciPy is exact without them only"
    i, j = numpy.triu_indices(len(d))
    out["mean_difference"] = float(numpy.mean(d))
    out["sd"] = float(numpy.std(d, ddof=1)) if len(d) > 1 else None
    out["mean_difference_deg"] = float(numpy.mean([first_deg[t] - second_deg[t] for t in shared]))
    out["estimate"] = float(numpy.median((d[i] + d[j]) / 2.0))
    ranks = scipy.stats.rankdata(abs(rest))
    out["w_plus"] = float(numpy.sum(ranks[rest > 0.0]))
    out["p"] = float(scipy.stats.wilcoxon(rest, mode="exact").pvalue) if len(rest) else 1.0
    return out


def case(name, clips):
    systems = list(dict.fromkeys(c["system"] for c in clips))
    pairs = [pair(clips, a, b) for k, a in enumerate(systems) for b in systems[k + 1:]]
    for found, adjusted in zip(pairs, holm([p["p"] for p in pairs])):
        found["p_holm"] = adjusted
    return {"name": name, "clips": clips, "pairs": pairs}


def places(count, z):
    return [[round(float(x), 4) for x in (draw.uniform(-2, 2), draw.uniform(0.3, 1.7), z)] for _ in range(count)]


def accuracies(count, mean):
    return [round(float(x), 6) for x in numpy.clip(draw.normal(mean, 0.05, count), 0.0, 0.632)]


def small():
    """Two systems at nine targets; one misses a clip, one has two clips for a target, one difference is 0."""
    targets = places(9, 1.5)
    one, other = accuracies(9, 0.55), accuracies(9, 0.5)
    other[4] = one[4]
    clips = [clip("one", t, x) for t, x in zip(targets, one)]
    clips += [clip("other", t, x) for t, x in zip(targets, other)]
    clips[9]["accuracy"] = clips[9]["error_deg"] = None
    clips.append(clip("other", targets[2], 0.61))
    return case("nine targets", clips)


def several():
    """Four systems at 60 targets, and one made for places of its own but for one."""
    targets = places(60, 1.8)
    clips = []
    for system, mean in (("a", 0.55), ("b", 0.545), ("c", 0.5), ("d", 0.51)):
        clips += [clip(system, t, x) for t, x in zip(targets, accuracies(60, mean))]
    clips += [clip("elsewhere", t, x) for t, x in zip(places(3, 2.2), accuracies(3, 0.4))]
    clips += [clip("near", t, x) for t, x in zip([targets[0]], accuracies(1, 0.4))]
    return case("six systems", clips)


if __name__ == "__main__":
    made_by = f"make_evaluation_pairs.py: NumPy {numpy.__version__}, SciPy {scipy.__version__}"
    cases = ",\n".join(json.dumps(c) for c in (small(), several()))
    text = f'{{"made_by": "{made_by}", "cases": [\n{cases}\n]}}\n'
    Path(__file__).with_name("evaluation_pairs.json").write_text(text)
