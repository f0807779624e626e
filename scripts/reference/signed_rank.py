"""Makes tests/results/reference/signed_rank_enumerated.json: exact Wilcoxon tests for the tests of results/statistics.

With ties the p values come from enumerating all sign patterns (in two halves where there are many pairs);
without, from SciPy. Run: /usr/bin/python3 scripts/reference/signed_rank.py > tests/results/reference/signed_rank_enumerated.json
"""

import json

import numpy
import scipy
from scipy.stats import rankdata, wilcoxon


def pattern_sums(ranks):
    """The rank sum of the positive differences under each of the 2^n sign patterns."""
    sums = numpy.zeros(1)
    for rank in ranks:
        sums = numpy.concatenate([sums, sums + rank])
    return sums


def enumerate_p(differences):
    d = numpy.array([x for x in differences if x != 0])
    ranks = rankdata(abs(d))
    w_plus = ranks[d > 0].sum()
    half = len(d) // 2
    first, second = pattern_sums(ranks[:half]), numpy.sort(pattern_sums(ranks[half:]))
    lower = int(numpy.searchsorted(second, w_plus - first, side="right").sum())
    upper = int((len(second) - numpy.searchsorted(second, w_plus - first, side="left")).sum())
    patterns = 2 ** len(d)
    return w_plus, ranks[d < 0].sum(), min(1.0, 2 * min(lower, upper) / patterns)


def enumerated(name, differences):
    w_plus, w_minus, p = enumerate_p(differences)
    return {"name": name, "method": "exact with ties", "differences": differences,
            "n_zero": differences.count(0), "w_plus": w_plus, "w_minus": w_minus, "p": p}


def from_scipy(name, differences):
    p = wilcoxon(differences, zero_method="wilcox", alternative="two-sided", method="exact").pvalue
    ranks = rankdata(numpy.abs(differences))
    d = numpy.array(differences)
    return {"name": name, "method": "exact", "differences": differences, "n_zero": 0,
            "w_plus": ranks[d > 0].sum(), "w_minus": ranks[d < 0].sum(), "p": p}


draw = numpy.random.default_rng(2023)


def fifths(n, shift):
    """Differences of means of five ratings: whole fifths, many of them equal, some zero."""
    return [int(x) / 5 for x in numpy.round(draw.normal(shift, 2, n))]


cases = [
    enumerated("three pairs, all tied", [1, 1, 1]),
    enumerated("two tied against one", [1, -1, 2]),
    enumerated("balanced", [1, -1, 2, -2]),
    enumerated("the midrank case of the documentation", [0.2, -0.2, 0.4, 0.4, 0, 0.6]),
    enumerated("9 pairs in fifths", fifths(9, 1)),
    enumerated("14 pairs in fifths", fifths(14, 1)),
    enumerated("14 pairs in fifths, no effect", fifths(14, 0)),
    enumerated("39 pairs in fifths", fifths(39, 1)),
    enumerated("39 pairs in fifths, strong effect", fifths(39, 3)),
    from_scipy("12 pairs", [round(x, 4) for x in draw.normal(0.5, 1, 12)]),
    from_scipy("39 pairs", [round(x, 5) for x in draw.normal(0.3, 1, 39)]),
]
print(json.dumps({"made_by": f"NumPy {numpy.__version__}, SciPy {scipy.__version__}, scripts/reference/signed_rank.py",
                  "signed_rank": cases}, indent=1))
