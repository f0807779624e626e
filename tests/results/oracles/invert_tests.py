"""Confidence intervals as the inversion of the exact rank tests, by trying every shift at which the tests' p can
change and one between each two of them; nothing is shared with the program under test.

make_oracles.py uses it. Run alone it writes the intervals in signed_rank.json and rank_sum.json anew:
/usr/bin/python3 tests/results/oracles/invert_tests.py
Needs python3-numpy.
"""

import json
import sys
from fractions import Fraction
from pathlib import Path
from statistics import median

import numpy

close = 1e-11  # p values are sums of exact binary fractions, or of quotients of whole numbers


def doubled_midranks(values):
    order = sorted(values)
    first, last = {}, {}
    for i, value in enumerate(order, 1):
        first.setdefault(value, i)
        last[value] = i
    return [first[value] + last[value] for value in values]


def signed_rank_p(differences, shift):
    moved = [d - shift for d in differences if d != shift]
    if not moved:
        return 1.0
    ranks = doubled_midranks([abs(d) for d in moved])
    ways = numpy.ones(1)
    for rank in ranks:
        longer = numpy.zeros(len(ways) + rank)
        longer[: len(ways)] += ways / 2
        longer[rank:] += ways / 2
        ways = longer
    plus = sum(rank for rank, d in zip(ranks, moved) if d > 0)
    return min(1.0, 2 * min(ways[: plus + 1].sum(), ways[plus:].sum()))


def rank_sum_p(a, b, shift):
    ranks = doubled_midranks([x - shift for x in a] + b)
    ways = numpy.zeros((len(a) + 1, sum(ranks) + 1))
    ways[0, 0] = 1
    for rank in ranks:
        for taken in range(len(a), 0, -1):
            ways[taken, rank:] += ways[taken - 1, : ways.shape[1] - rank]
    share = ways[len(a)] / ways[len(a)].sum()
    found = sum(ranks[: len(a)])
    return min(1.0, 2 * min(share[: found + 1].sum(), share[found:].sum()))


def invert(places, p, level):
    """From the least to the greatest shift between places with p > 1 - level, whether the ends are such ones, and 1 - the
    largest p just outside; the widest interval where none is wide enough; cut at 0 where p(0) does not exceed 1 - level."""
    alpha = 1 - level
    raw, places = list(places), sorted(set(places))
    shifts = [places[0] - 1]
    for i, place in enumerate(places):
        shifts += [place, (place + places[i + 1]) / 2 if i + 1 < len(places) else place + 1]
    found = [p(shift) for shift in shifts]
    held = [i for i, one in enumerate(found) if i % 2 == 0 and one > alpha + close]  # between places
    of_zero = p(Fraction(0))
    beside = [p(Fraction(sign, 10**12)) for sign in (-1, 1)]
    if not held:
        only = next((one for one in (median(raw), Fraction(0)) if p(one) > alpha + close), None)
        if only is None:
            return {"lower": None, "upper": None, "lower_included": True, "upper_included": True, "level": None}
        ends = [[only, True], [only, True]]
        outside = max(p(only - Fraction(1, 10**12)), p(only + Fraction(1, 10**12)))
    else:
        ends, outside = [], 0.0
        for at, step in ((held[0], -1), (held[-1], 1)):
            if 0 <= at + step < len(shifts):
                included = bool(found[at + step] > alpha + close)
                ends.append([shifts[at + step], included])
                outside = max(outside, found[at + 2 * step], 0.0 if included else found[at + step])
            else:
                ends.append([shifts[at - step], True])
                outside = max(outside, found[at])
    if outside > alpha + close:
        pass  # the widest interval speaks at its own level
    elif of_zero > alpha + close:
        if ends[0][0] >= 0:
            ends[0] = [Fraction(0), True]
        if ends[1][0] <= 0:
            ends[1] = [Fraction(0), True]
    elif ends[0][0] <= 0 <= ends[1][0]:
        outside = max(outside, of_zero)
        ends[0 if beside[0] < beside[1] else 1] = [Fraction(0), False]
    return {"lower": float(ends[0][0]), "upper": float(ends[1][0]), "lower_included": ends[0][1],
            "upper_included": ends[1][1], "level": float(1 - outside)}


def signed_rank_interval(differences, level):
    if not differences:
        return {"estimate": None, "lower": None, "upper": None, "level": None}
    walsh = [(x + y) / 2 for i, x in enumerate(differences) for y in differences[i:]]
    return {"estimate": float(median(walsh)),
            **invert(walsh, lambda shift: signed_rank_p(differences, shift), float(level))}


def rank_sum_interval(a, b, level):
    shifts = [x - y for x in a for y in b]
    return {"estimate": float(median(shifts)), **invert(shifts, lambda shift: rank_sum_p(a, b, shift), float(level))}


def main():
    here = Path(__file__).parent
    for name in ("signed_rank", "rank_sum"):
        path = here / f"{name}.json"
        text = path.read_text()
        content = json.loads(text)

        def number(cell):
            top, _, bottom = cell.partition("/")
            return Fraction(top) / Fraction(bottom or "1")

        for case in content["cases"]:
            a, b = case["a"], case["b"]
            if name == "signed_rank":
                d = [number(x) - number(y) for x, y in zip(a, b) if x and y]
                case["hodges_lehmann"] = signed_rank_interval(d, case["level"])
            elif "hodges_lehmann" in case:
                case["hodges_lehmann"] = rank_sum_interval([number(x) for x in a if x], [number(y) for y in b if y],
                                                           case["level"])
        head = text[: text.index("[\n") + 2]
        path.write_text(head + ",\n".join(json.dumps(case) for case in content["cases"]) + "\n]}\n")
        print(name, len(content["cases"]), file=sys.stderr)


if __name__ == "__main__":
    main()
