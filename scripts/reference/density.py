"""Makes tests/results/reference/density_scipy.json: densities, clusters and correlations by SciPy, statsmodels and
scikit-learn, for the tests of results/density, results/mean_shift and results/spearman.

Run: /usr/bin/python3 scripts/reference/density.py > tests/results/reference/density_scipy.json
"""

import itertools
import json

import numpy
import scipy
import sklearn
import statsmodels
from scipy.stats import gaussian_kde, spearmanr
from sklearn.cluster import MeanShift, estimate_bandwidth
from statsmodels.nonparametric.kernel_density import KDEMultivariate

draw = numpy.random.default_rng(2023)
draw_heaps = numpy.random.default_rng(1995)


def half_cylinder(n):
    """Targets as the paper's Figure 1 has them, roughly; rounded, so that the file stays small."""
    azimuth, radius = draw.uniform(-1.5, 1.5, n), draw.uniform(1.8, 2.3, n)
    x, y, z = radius * numpy.sin(azimuth), draw.uniform(0, 2.2, n), radius * numpy.cos(azimuth)
    return numpy.round(numpy.column_stack([x, y, z]), 3)


def densities(points, queries):
    product = KDEMultivariate(points, "c" * points.shape[1], bw="normal_reference")
    paper = KDEMultivariate(points, "c" * points.shape[1], bw=[0.80, 0.36, 0.35][: points.shape[1]])
    full = gaussian_kde(points.T)
    return {
        "points": points.tolist(), "queries": queries.tolist(),
        "normal_reference": {"bandwidths": product.bw.tolist(), "density": product.pdf(queries).tolist()},
        "given": {"bandwidths": paper.bw.tolist(), "density": paper.pdf(queries).tolist()},
        "scott_covariance": {"bandwidths": numpy.sqrt(numpy.diag(full.covariance)).tolist(),
                             "density": full(queries.T).tolist()},
    }


def clusters(name, points, bandwidth=None, quantile=0.3):
    estimated = float(estimate_bandwidth(points, quantile=quantile))
    found = MeanShift(bandwidth=bandwidth or estimated, bin_seeding=False).fit(points)
    return {"name": name, "points": points.tolist(), "quantile": quantile, "estimated": estimated, "bandwidth": bandwidth or estimated,
            "centres": found.cluster_centers_.tolist(), "labels": found.labels_.tolist()}


def spread_points(n, d):
    """Some in one heap, some in several."""
    heaps = draw_heaps.normal(0, 2, (draw_heaps.integers(1, 4), d))
    return numpy.round(heaps[draw_heaps.integers(0, len(heaps), n)] + draw_heaps.normal(0, 0.5, (n, d)), 2)


def more_densities():
    return [densities(spread_points(int(draw_heaps.integers(5, 25)), d), numpy.round(draw_heaps.normal(0, 2, (4, d)), 2))
            for d in (1, 2, 3) for _ in range(10)]


def more_clusters():
    cases = []
    for i in range(30):
        points = spread_points(int(draw_heaps.integers(15, 40)), 1 + i % 3)
        given = float(numpy.round(draw_heaps.uniform(0.4, 2.0), 2)) if i % 2 else None
        cases.append(clusters(f"heaps {i}", points, given, (0.3, 0.2, 0.5)[i // 2 % 3]))
    return cases


def all_pairings(x, y):
    """Two-sided p over all pairings: twice the nearer tail."""
    rank_x, rank_y = scipy.stats.rankdata(x), scipy.stats.rankdata(y)
    sums = numpy.array([rank_x @ numpy.array(p) for p in itertools.permutations(rank_y)])
    found = rank_x @ rank_y
    return min(1.0, 2 * min((sums <= found + 1e-9).mean(), (sums >= found - 1e-9).mean()))


def correlation(name, x, y):
    result = spearmanr(x, y)
    return {"name": name, "x": list(x), "y": list(y), "rho": float(result.correlation),
            "p": all_pairings(x, y) if len(x) <= 9 else float(result.pvalue)}


targets = half_cylinder(52)
grid = numpy.round(numpy.array(list(itertools.product([-2, 0.3, 1.9], [0.1, 1.2], [0.2, 1.0, 2.1]))), 3)
spots = numpy.round(numpy.concatenate([draw.normal(c, 0.15, (12, 2)) for c in ([0, 0], [2, 0.5], [0.4, 2.5])]), 3)
x30 = numpy.round(draw.normal(0, 1, 30), 2)
print(json.dumps({
    "made_by": f"scripts/reference/density.py, SciPy {scipy.__version__}, statsmodels {statsmodels.__version__}, "
               f"scikit-learn {sklearn.__version__}",
    "density": [densities(targets, grid), densities(half_cylinder(9)[:, :1], numpy.array([[-1.0], [0.0], [2.5]]))]
    + more_densities(),
    "mean_shift": [clusters("targets, bandwidth as in the paper", targets, 0.78), clusters("targets, estimated", targets),
                   clusters("three spots", spots), clusters("three spots, narrow", spots, 0.3)]
    + more_clusters(),
    "spearman": [
        correlation("six pairs", [1.2, 3.1, 0.4, 2.2, 5.0, 4.1], [2.0, 2.5, 0.1, 3.3, 4.8, 9.9]),
        correlation("seven pairs, ties", [1, 2, 2, 3, 5, 5, 5], [4, 4, 1, 3, 2, 2, 0]),
        correlation("nine pairs, falling", list(range(9)), [9, 8, 7, 6, 5, 3, 4, 2, 1]),
        correlation("ten pairs", list(range(10)), [3, 1, 2, 0, 5, 6, 4, 9, 8, 7]),
        correlation("thirty pairs, ties", x30.tolist(), numpy.round(0.4 * x30 + draw.normal(0, 1, 30), 1).tolist()),
    ],
}, indent=None, separators=(",", ":")))
