"""Makes the JSON files beside this script: cases and their right answers for the tests of results/.

Answers come from plain enumeration in exact fractions (all 2^n signs, all ways to share out the values, all
pairings), from whole-number dynamic programming where there are too many of those, from SciPy, and from R
(make_oracles.R: stats, boot, exactRankTests, coin, effectsize). The program under test takes no part. Densities and
clusters are in scripts/reference/density.py.

Run: /usr/bin/python3 tests/results/oracles/make_oracles.py
Needs python3-scipy, r-base-core, r-cran-boot, r-cran-exactranktests, r-cran-coin, r-cran-effectsize, r-cran-jsonlite,
which Debian 12 has all.
"""

import itertools
import json
import math
import random
import subprocess
import tempfile
from fractions import Fraction
from pathlib import Path

import numpy
import scipy
import scipy.stats

from invert_tests import doubled_midranks, rank_sum_interval, signed_rank_interval

here = Path(__file__).parent
draw = random.Random(1995)
draw_untied = random.Random(1945)


def number(cell):
    """A cell as an exact fraction: '7/3', '-0.125', '1e-3'."""
    top, _, bottom = cell.partition("/")
    return Fraction(top) / Fraction(bottom or "1")


def midranks(values):
    return [Fraction(rank, 2) for rank in doubled_midranks(values)]


def median(values):
    ordered = sorted(values)
    n = len(ordered)
    return (ordered[(n - 1) // 2] + ordered[n // 2]) / 2


def sign_sums(ranks):
    """How many sign patterns give each doubled rank sum; whole numbers of any size."""
    counts = {0: 1}
    for rank in ranks:
        step = int(2 * rank)
        after = dict(counts)
        for total, count in counts.items():
            after[total + step] = after.get(total + step, 0) + count
        counts = after
    return counts


def enumerated_sums(ranks):
    counts = {}
    for signs in itertools.product((0, 1), repeat=len(ranks)):
        total = int(2 * sum(r for r, s in zip(ranks, signs) if s))
        counts[total] = counts.get(total, 0) + 1
    return counts


def tails(counts, found):
    """P(W <= found), P(W >= found), two-sided."""
    everything = sum(counts.values())
    low = Fraction(sum(c for w, c in counts.items() if w <= found), everything)
    high = Fraction(sum(c for w, c in counts.items() if w >= found), everything)
    return float(low), float(high), float(min(Fraction(1), 2 * min(low, high)))


def signed_rank(name, a, b, level="0.95"):
    pairs = [(number(x), number(y)) for x, y in zip(a, b) if x and y]
    d = [x - y for x, y in pairs]
    rest = [x for x in d if x != 0]
    out = {"name": name, "a": a, "b": b, "level": float(level), "n_pairs": len(d), "n_missing": len(a) - len(d),
           "n_zero": len(d) - len(rest), "n_positive": sum(x > 0 for x in d), "n_negative": sum(x < 0 for x in d)}
    sums = enumerated_sums if len(rest) <= 14 else sign_sums
    ranks = midranks([abs(x) for x in rest])
    groups = {}
    for r in ranks:
        groups[r] = groups.get(r, 0) + 1
    out["ties"] = sum(g > 1 for g in groups.values())
    plus = sum((r for r, x in zip(ranks, rest) if x > 0), Fraction(0))
    minus = sum((r for r, x in zip(ranks, rest) if x < 0), Fraction(0))
    out["w_plus"], out["w_minus"] = float(plus), float(minus)
    out["p_less"], out["p_greater"], out["p_two_sided"] = tails(sums(ranks), int(2 * plus))
    with_zeros = [r for r, x in zip(midranks([abs(x) for x in d]), d) if x != 0]
    pratt = sum((r for r, x in zip(with_zeros, rest) if x > 0), Fraction(0))
    out["pratt_w_plus"] = float(pratt)
    out["pratt_p_two_sided"] = tails(sums(with_zeros), int(2 * pratt))[2]
    out["rank_biserial"] = float((plus - minus) / (plus + minus)) if rest else None
    out["paired_superiority"] = float((out["n_positive"] + Fraction(out["n_zero"], 2)) / len(d)) if d else None
    out["hodges_lehmann"] = signed_rank_interval(d, level)
    if len(rest) > 1:
        signed = [float(r if x > 0 else -r) for r, x in zip(ranks, rest)]
        out["scipy"] = {"normal_p": min(1.0, float(scipy.stats.wilcoxon(signed, correction=True, mode="approx").pvalue))}
        if out["ties"] == 0 and len(rest) <= 50:
            for side in ("two-sided", "greater", "less"):
                out["scipy"][side] = float(scipy.stats.wilcoxon(signed, mode="exact", alternative=side).pvalue)
    return out


def mean_cells(n, denominators, shift):
    """Means of answers of which some are missing: fractions with different denominators."""
    cells = []
    for _ in range(n):
        q = draw.choice(denominators)
        cells.append(f"{draw.randint(shift * q, (3 + shift) * q)}/{q}")
    return cells


def signed_rank_cases():
    cases = [
        signed_rank("no pairs", [], []),
        signed_rank("only missing cells", ["", "1"], ["2", ""]),
        signed_rank("one pair", ["2"], ["1"]),
        signed_rank("one pair of equals", ["1/3"], ["2/6"]),
        signed_rank("two pairs", ["2", "3"], ["1", "1"]),
        signed_rank("two pairs, opposite and tied", ["2", "1"], ["1", "2"]),
        signed_rank("all differences equal", ["1.1"] * 7, ["1"] * 7),
        signed_rank("all zero", ["0.3"] * 5, ["3/10"] * 5),
        signed_rank("one missing cell", ["1", "2", "", "5", "7"], ["2", "0", "3", "1", "1"]),
        signed_rank("equal on paper", ["0.3", "1/3", "0.1", "1e-1"], ["0.1", "2/15", "-0.1", "0.3"]),
        signed_rank("thirds and sevenths", ["7/3", "5/7", "1", "2/3"], ["2", "8/21", "4/3", "1/3"]),
        signed_rank("huge", ["1e200", "3e200", "1e200", "2e200"], ["0", "1e200", "2e200", "7"]),
        signed_rank("tiny", ["1e-200", "3e-200", "1e-200"], ["0", "1e-200", "2e-200"]),
        signed_rank("17 digits", ["0.12345678901234567", "0.12345678901234568", "3"],
                    ["0.02345678901234567", "0.02345678901234567", "2.9"]),
        signed_rank("level that is met exactly", ["1", "2", "3.5", "-1", "6"], ["0"] * 5, "0.9375"),
        signed_rank("90 %", [str(x) for x in (3, 1, 4, 1, 5, 9, 2, 6)], [str(x) for x in (2, 7, 1, 8, 2, 8, 1, 8)], "0.9"),
    ]
    for i in range(24):
        n = draw.randint(3, 14)
        cases.append(signed_rank(f"means of answers {i}", mean_cells(n, [3, 4, 5, 6, 7][: 2 + i % 4], 1),
                                 mean_cells(n, [3, 4, 5, 6][: 1 + i % 4], 0 if i % 3 else 1)))
    for n in (20, 39, 60, 100):
        cases.append(signed_rank(f"{n} pairs in fifths", mean_cells(n, [5], 1), mean_cells(n, [5, 4], 1)))
    cases.append(signed_rank("39 pairs without ties", [f"{draw.gauss(0.3, 1):.6f}" for _ in range(39)], ["0"] * 39))
    cases.append(signed_rank("60 pairs, far tail", [f"{draw.gauss(3, 1):.2f}" for _ in range(60)], ["0"] * 60))
    return cases


def untied_pairs():
    """For R's intervals, which need differences without ties and zeros."""
    cases = []
    for i in range(24):
        n = draw_untied.randint(4, 45)
        differences = draw_untied.sample(range(1, 20 * n), n)
        cells = [f"{x * draw_untied.choice((1, 1, -1)) / 1000:.3f}" for x in differences]
        cases.append(signed_rank(f"untied {i}", cells, ["0"] * n, draw_untied.choice(["0.95", "0.9", "0.99"])))
    return cases


def large_case(name, n, shift, places):
    """Too large for whole numbers: doubles, each stage halved; right to about n * 2^-53 near the middle."""
    cells = [f"{draw.gauss(shift, 1):.{places}f}" for _ in range(n)]
    d = [x for x in map(number, cells) if x != 0]
    doubled = [int(2 * r) for r in midranks([abs(x) for x in d])]
    chances = numpy.ones(1)
    for r in sorted(doubled):
        after = numpy.zeros(len(chances) + r)
        after[: len(chances)] += 0.5 * chances
        after[r:] += 0.5 * chances
        chances = after
    plus = sum(r for r, x in zip(doubled, d) if x > 0)
    low, high = float(chances[: plus + 1].sum()), float(chances[plus:].sum())
    return {"name": name, "a": cells, "w_plus": plus / 2, "p_less": low, "p_greater": high,
            "p_two_sided": min(1.0, 2 * min(low, high))}


def subset_sums(ranks, chosen):
    counts = {}
    for subset in itertools.combinations(ranks, chosen):
        total = int(2 * sum(subset))
        counts[total] = counts.get(total, 0) + 1
    return counts


def rank_sum(name, a, b, level="0.95"):
    x, y = [number(c) for c in a if c], [number(c) for c in b if c]
    out = {"name": name, "a": a, "b": b, "level": float(level), "n_a": len(x), "n_b": len(y)}
    if not x or not y:
        return out
    u = sum(Fraction(1) if p > q else Fraction(1, 2) if p == q else Fraction(0) for p in x for q in y)
    out["u"], out["a12"] = float(u), float(u / (len(x) * len(y)))
    out["cliffs_delta"] = float(2 * u / (len(x) * len(y)) - 1)
    ranks = midranks(x + y)
    if math.comb(len(ranks), len(x)) <= 40000:
        out["p_less"], out["p_greater"], out["p_two_sided"] = tails(subset_sums(ranks, len(x)),
                                                                    int(2 * sum(ranks[: len(x)])))
    out["hodges_lehmann"] = rank_sum_interval(x, y, level)
    if len(set(ranks)) > 1:
        sides = [float(r) for r in ranks[: len(x)]], [float(r) for r in ranks[len(x):]]
        out["scipy"] = {"normal_p": float(scipy.stats.mannwhitneyu(*sides, method="asymptotic").pvalue)}
        if len(set(ranks)) == len(ranks):
            for side in ("two-sided", "greater", "less"):
                out["scipy"][side] = float(scipy.stats.mannwhitneyu(*sides, method="exact", alternative=side).pvalue)
    return out


def untied_samples():
    """For R's intervals, which need samples without ties."""
    cases = []
    for i in range(28):
        n_a, n_b = draw_untied.randint(3, 20), draw_untied.randint(3, 20)
        values = [f"{x / 100:.2f}" for x in draw_untied.sample(range(50 * (n_a + n_b)), n_a + n_b)]
        cases.append(rank_sum(f"untied {i}", values[:n_a], values[n_a:], draw_untied.choice(["0.95", "0.9", "0.99"])))
    return cases


def rank_sum_cases():
    cases = [
        rank_sum("an empty sample", [], ["1", "2"]),
        rank_sum("one each", ["1"], ["2"]),
        rank_sum("one each, equal", ["1/2"], ["0.5"]),
        rank_sum("two each", ["3", "4"], ["1", "2"]),
        rank_sum("all equal", ["2"] * 4, ["2"] * 5),
        rank_sum("missing cells", ["1", "", "3", "9"], ["2", "2", "", ""]),
        rank_sum("unequal sizes", ["5"], [str(i) for i in range(12)]),
        rank_sum("lopsided ties", ["1", "1", "1", "7"], ["1", "1", "1", "1", "1", "8", "9"]),
        rank_sum("thirds", ["1/3", "2/3", "1", "4/3"], ["0.5", "1/3", "1", "5/3", "2"]),
        rank_sum("huge and tiny", ["1e150", "1e-150", "3"], ["1e149", "2e-150", "3"], "0.8"),
    ]
    for i in range(22):
        n_a, n_b = draw.randint(2, 8), draw.randint(2, 8)
        cases.append(rank_sum(f"tied {i}", mean_cells(n_a, [1, 2], i % 2), mean_cells(n_b, [1, 3], 0),
                              draw.choice(["0.95", "0.9", "0.8"])))
    for n_a, n_b in ((12, 15), (20, 20), (30, 25)):
        cases.append(rank_sum(f"{n_a} and {n_b}, tied", mean_cells(n_a, [2], 0), mean_cells(n_b, [2], 0)))
        cases.append(rank_sum(f"{n_a} and {n_b}, untied", [f"{draw.gauss(0.5, 1):.6f}" for _ in range(n_a)],
                              [f"{draw.gauss(0, 1):.6f}" for _ in range(n_b)]))
    return cases


def friedman_cases():
    cases = [{"name": "all rank alike", "rows": [["1", "2", "3"]] * 4}, {"name": "one row", "rows": [["1", "2", "2"]]},
             {"name": "all tied", "rows": [["1", "1", "1"]] * 3},
             {"name": "two columns", "rows": [["1", "2"], ["2", "1"], ["1", "3"], ["2", "2"], ["1", "4"]]}]
    for i in range(28):
        k, n = draw.randint(2, 6), draw.randint(2, 40)
        cases.append({"name": f"random {i}", "rows": [mean_cells(k, [1, 2, 3], 0) for _ in range(n)]})
    for case in cases:
        columns = [[float(r) for r in column] for column in zip(*(midranks([number(c) for c in row]) for row in case["rows"]))]
        if len(columns) > 2 and case["name"] != "all tied":
            found = scipy.stats.friedmanchisquare(*columns)
            case["scipy"] = {"chi2": float(found.statistic), "p": float(found.pvalue)}
    return cases


def shapiro_cases():
    cases = [{"name": "equally spaced", "x": [str(i) for i in range(1, 8)]}, {"name": "three", "x": ["1", "2", "4"]},
             {"name": "three, two equal", "x": ["1", "1", "5"]}, {"name": "far off", "x": ["0"] * 9 + ["1000"]},
             {"name": "scaled", "x": [f"{1000000 + x}e-9" for x in (1, 4, 2, 8, 5, 7)]}]
    for n in (3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 15, 20, 25, 30, 39, 50, 80, 150, 400):
        cases.append({"name": f"normal {n}", "x": [f"{draw.gauss(0, 1):.4f}" for _ in range(n)]})
    for n in (3, 5, 8, 11, 12, 20, 39, 100):
        cases.append({"name": f"skewed {n}", "x": [f"{draw.expovariate(1):.2f}" for _ in range(n)]})
    cases.append({"name": "5000", "x": [str(draw.randint(0, 99)) for _ in range(5000)]})
    for case in cases:
        found = scipy.stats.shapiro([float(number(c)) for c in case["x"]])
        case["scipy"] = {"w": float(found.statistic), "p": float(found.pvalue)}
    return cases


def spearman(name, x, y):
    out = {"name": name, "x": x, "y": y}
    a, b = midranks([number(c) for c in x]), midranks([number(c) for c in y])
    if len(set(a)) > 1 and len(set(b)) > 1:
        out["rho"] = float(scipy.stats.pearsonr([float(r) for r in a], [float(r) for r in b])[0]) if len(a) > 2 else \
            (1.0 if (a[0] < a[1]) == (b[0] < b[1]) else -1.0)
        if len(a) <= 7:
            found = sum(p * q for p, q in zip(a, b))
            counts = {}
            for pairing in itertools.permutations(b):
                total = sum(p * q for p, q in zip(a, pairing))
                counts[total] = counts.get(total, 0) + 1
            out["p_less"], out["p_greater"], out["p"] = tails(counts, found)
        elif len(a) > 9:
            out["p"] = float(scipy.stats.spearmanr([float(r) for r in a], [float(r) for r in b]).pvalue)
    return out


def spearman_cases():
    cases = [spearman("two", ["1", "2"], ["3", "4"]), spearman("two, turned", ["1", "2"], ["4", "3"]),
             spearman("one", ["1"], ["2"]), spearman("constant", ["1", "1", "1"], ["1", "2", "3"]),
             spearman("perfect 5", [str(i) for i in range(5)], [str(i * i) for i in range(5)])]
    for i in range(18):
        n = draw.randint(3, 7)
        cases.append(spearman(f"tied {i}", mean_cells(n, [1, 2], 0), mean_cells(n, [1, 3], 0)))
    for n in (8, 9):
        for i in range(3):
            cases.append(spearman(f"untied {n} {i}", [f"{draw.random():.6f}" for _ in range(n)],
                                  [f"{draw.random():.6f}" for _ in range(n)]))
    for n in (10, 11, 20, 39, 100):
        cases.append(spearman(f"t {n}", mean_cells(n, [1, 2], 0), mean_cells(n, [1, 3], 0)))
    return cases


def holm(p):
    """By the definition: of each p the largest of what the p up to it give, in exact fractions."""
    there = sorted((Fraction(str(x)), i) for i, x in enumerate(p) if x is not None)
    out = [None] * len(p)
    for place, (_, i) in enumerate(there):
        out[i] = float(min(Fraction(1), max((len(there) - j) * x for j, (x, _) in enumerate(there[: place + 1]))))
    return out


def holm_cases():
    cases = [{"p": []}, {"p": [None]}, {"p": [0.04]}, {"p": [0.0, 1.0, 0.5]}, {"p": [0.02, None, 0.02, 0.01]}]
    for _ in range(27):
        cases.append({"p": [None if draw.random() < 0.1 else round(draw.random() ** 3, draw.randint(1, 6))
                            for _ in range(draw.randint(1, 15))]})
    for case in cases:
        case["adjusted"] = holm(case["p"])
    return cases


def describe_cases():
    cases = [{"x": ["1"]}, {"x": ["1/3", "1/3"]}, {"x": ["1e15", "1000000000000001", "1000000000000002"]},
             {"x": ["0.1", "0.2", "0.3", "0.4"]}]
    for i in range(28):
        n = draw.randint(2, 45)
        cases.append({"x": mean_cells(n, [1, 2, 3, 7], i % 3) if i % 2 else [f"{draw.gauss(3, 1):.5f}" for _ in range(n)]})
    return cases


def proportion_cases():
    cases = [(0, 1, "1/3", "0.95"), (1, 1, "1/3", "0.95"), (0, 20, "1/4", "0.95"), (20, 20, "1/4", "0.95"),
             (5, 15, "1/3", "0.95"), (10, 20, "1/2", "0.95"), (900, 2340, "1/3", "0.99"), (600, 1000, "1/3", "0.95"),
             (333333, 1000000, "1/3", "0.95")]
    for _ in range(25):
        n = draw.randint(2, 120)
        cases.append((draw.randint(0, n), n, draw.choice(["1/2", "1/3", "0.25", "1/7", "0.9"]), draw.choice(["0.95", "0.9"])))
    out = []
    for s, n, c, level in cases:
        test = scipy.stats.binomtest(s, n, float(number(c)))
        interval = test.proportion_ci(float(level), "exact")
        out.append({"successes": s, "n": n, "chance": float(number(c)), "level": float(level),
                    "scipy": {"p_chance": float(test.pvalue), "lower": float(interval.low), "upper": float(interval.high)}})
    return out


def bootstrap_cases():
    """SciPy's intervals from 200,000 resamples; another generator, so equal only within its error."""
    cases = []
    for i, n in enumerate((12, 39, 39, 20) + tuple(draw_untied.randint(8, 60) for _ in range(28))):
        skewed, level = i % 2 == 1, (0.95, 0.95, 0.9, 0.99)[i // 4 % 4]
        x = [round(draw_untied.expovariate(1) if skewed else draw_untied.gauss(3, 1), 3) for _ in range(n)]
        case = {"x": x, "level": level, "mean": float(numpy.mean(x))}
        for method in ("percentile", "BCa"):
            found = scipy.stats.bootstrap((x,), numpy.mean, n_resamples=200000, batch=20000, method=method,
                                          confidence_level=level, random_state=numpy.random.default_rng(7))
            case[method.lower()] = [float(v) for v in found.confidence_interval]
            case["se"] = float(found.standard_error)
        cases.append(case)
    return cases


cases = {
    "signed_rank": signed_rank_cases() + untied_pairs(),
    "signed_rank_large": [large_case("1,000 pairs in tenths", 1000, 0.05, 1),
                          large_case("1,500 pairs in hundredths", 1500, -0.06, 2)],
    "rank_sum": rank_sum_cases() + untied_samples(),
    "friedman": friedman_cases(),
    "shapiro": shapiro_cases(),
    "spearman": spearman_cases(),
    "holm": holm_cases(),
    "describe": describe_cases(),
    "proportion": proportion_cases(),
    "bootstrap": bootstrap_cases(),
}
with tempfile.TemporaryDirectory() as folder:
    inputs, outputs = Path(folder) / "cases.json", Path(folder) / "answers.json"
    inputs.write_text(json.dumps(cases))
    subprocess.run(["Rscript", str(here / "make_oracles.R"), str(inputs), str(outputs)], check=True)
    by_r = json.loads(outputs.read_text())
for test, answers in by_r["answers"].items():
    for case, answer in zip(cases[test], answers, strict=True):
        case["r"] = answer
made_by = f"make_oracles.py: Python, NumPy {numpy.__version__}, SciPy {scipy.__version__}, {by_r['made_by']}"
for test, found in cases.items():
    lines = ",\n".join(json.dumps(case) for case in found)
    (here / f"{test}.json").write_text(f'{{"made_by": "{made_by}", "cases": [\n{lines}\n]}}\n')
    print(f"{test}: {len(found)} cases")
