"""Makes power.json beside this script: the power of two studies with two systems each, for deixis power to agree with.

The game: one choice a participant and system, so differences of means are -1, 0 or 1 and the signed-rank test is a sign
test; its power is a sum over the trinomial distribution of their counts, with SciPy's binomial probabilities. Exact.

The rating: studies drawn with NumPy, p by enumerating the signs of the midranks (dynamic programming, written out
here), locations of the systems by SciPy's root finding. Simulated, with its standard error. The program under test
takes no part.

Run: /usr/bin/python3 tests/results/oracles/make_power.py
Needs python3-scipy.
"""

import json
from functools import lru_cache
from pathlib import Path

import numpy
import scipy
from scipy.optimize import brentq
from scipy.stats import binom, multinomial, norm, rankdata

ALPHA = 0.05


def game_power(shares, participants):
    a, b = shares
    up, down = a * (1 - b), b * (1 - a)
    counts = multinomial(participants, [up, down, 1 - up - down])
    power = {"a_higher": 0.0, "b_higher": 0.0}
    for plus in range(participants + 1):
        for minus in range(participants + 1 - plus):
            n = plus + minus
            p = min(1.0, 2 * binom.cdf(min(plus, minus), n, 0.5)) if n else 1.0
            if p <= ALPHA:
                way = "a_higher" if plus > minus else "b_higher"
                power[way] += counts.pmf([plus, minus, participants - n])
    return {way: float(value) for way, value in power.items()}


@lru_cache(maxsize=None)
def tails(doubled_ranks):
    ways = numpy.zeros(sum(doubled_ranks) + 1)
    ways[0] = 1.0
    for rank in doubled_ranks:
        shifted = numpy.zeros_like(ways)
        shifted[rank:] = ways[: len(ways) - rank]
        ways = 0.5 * (ways + shifted)
    return numpy.cumsum(ways)


def signed_rank_p(differences):
    left = differences[differences != 0]
    if not len(left):
        return 1.0
    ranks = numpy.rint(2 * rankdata(numpy.abs(left))).astype(int)
    plus, minus = int(ranks[left > 0].sum()), int(ranks[left < 0].sum())
    return min(1.0, 2.0 * tails(tuple(sorted(ranks.tolist())))[min(plus, minus)])


def rating_power(case, studies, draw):
    p, ps, item, noise = case["participant_sd"], case["participant_system_sd"], case["item_sd"], case["noise_sd"]
    total = (p * p + ps * ps + item * item + noise * noise) ** 0.5
    steps = numpy.arange(case["low"], case["high"])

    def location(mean):
        return brentq(lambda at: case["low"] + norm.cdf((at - steps - 0.5) / total).sum() - mean, -50, 50, xtol=1e-12)

    at = numpy.array([location(mean) for mean in case["means"]])
    n, items = case["participants"], case["items"]
    found = 0
    for _ in range(studies):
        behind = (
            at[None, :, None]
            + p * draw.standard_normal((n, 1, 1))
            + ps * draw.standard_normal((n, 2, 1))
            + item * draw.standard_normal((n, 1, items))
            + noise * draw.standard_normal((n, 2, items))
        )
        answers = numpy.floor(numpy.clip(behind, case["low"], case["high"]) + 0.5).astype(int)
        sums = answers.sum(axis=2)
        found += signed_rank_p(sums[:, 0] - sums[:, 1]) <= ALPHA
    share = found / studies
    return {"power": share, "se": (share * (1 - share) / studies) ** 0.5, "studies": studies}


draw = numpy.random.default_rng(2004)
games = [{"shares": shares, "participants": n} for shares in ([0.9, 0.55], [0.7, 0.7]) for n in (12, 25)]
for case in games:
    case.update(game_power(case["shares"], case["participants"]))
ratings = [
    {"means": [3.5, 3.0], "participants": 16, "items": 3, "low": 1, "high": 5, "participant_sd": 0.7,
     "participant_system_sd": 0.4, "item_sd": 0.3, "noise_sd": 0.9},
    {"means": [4.6, 4.3], "participants": 24, "items": 2, "low": 1, "high": 5, "participant_sd": 0.5,
     "participant_system_sd": 0.3, "item_sd": 0.2, "noise_sd": 0.7},
]
for case in ratings:
    case.update(rating_power(case, 20000, draw))
here = Path(__file__).parent
(here / "power.json").write_text(json.dumps({
    "made_by": f"make_power.py: NumPy {numpy.__version__}, SciPy {scipy.__version__}",
    "alpha": ALPHA, "games": games, "ratings": ratings}, indent=1) + "\n")
