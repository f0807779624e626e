#!/usr/bin/env bash
# Times deixis beside R and SciPy on the same data, in one run; fails where an answer or a limit is missed.
#   bench/statistics_peers.sh BUILD      such as build/bench, with deixis and deixis_bench
# Processor seconds, medians of repetitions; of `deixis stats` the whole program, of a peer the test alone; power in
# real time, on two threads. Needs r-base-core, r-cran-exactranktests and python3-scipy.
set -euo pipefail
build=$1
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

python=/usr/bin/python3
$python - "$folder" <<'END'
import random, sys
draw = random.Random(39)
with open(sys.argv[1] + "/pairs.csv", "w") as out:
    print("tied,untied,zero", file=out)
    for size in draw.sample(range(1, 5000), 1000):
        sign = draw.choice((1, 1, 1, 1, 1, 1, -1, -1, -1, -1, -1))
        print(f"{sign * draw.randint(1, 6) / 10},{sign * size / 1000},0", file=out)
with open(sys.argv[1] + "/scores.csv", "w") as out:
    print("a,b,c,d", file=out)
    for _ in range(39):
        print(*(f"{draw.gauss(3, 0.5):.3f}" for _ in range(4)), sep=",", file=out)
END

# A test of deixis, five times: "NAME SECONDS" each, and its answer in NAME.json.
deixis_stats() {
    local name=$1 TIMEFORMAT='%3U %3S'
    shift
    for _ in 1 2 3 4 5; do
        { time "$build/deixis" stats "$@" --json >"$folder/$name.json"; } 2>&1 | awk -v name="$name" '{print name, $1 + $2}'
    done >>"$folder/times"
}
deixis_stats tied signed-rank "$folder/pairs.csv" --columns tied,zero
deixis_stats untied signed-rank "$folder/pairs.csv" --columns untied,zero
deixis_stats bootstrap bootstrap "$folder/scores.csv" --columns a,b,c,d

Rscript -e '
suppressMessages(library(exactRankTests))
folder <- commandArgs(TRUE)[1]
x <- read.csv(file.path(folder, "pairs.csv"))
out <- file(file.path(folder, "times"), "a")
for (i in 1:3) {
    spent <- system.time(p <- wilcox.exact(x$tied, x$zero, paired = TRUE, exact = TRUE)$p.value)
    cat("exactRankTests", spent[["user.self"]] + spent[["sys.self"]], "\n", file = out)
    spent <- system.time(for (j in 1:10) wilcox.test(x$untied, exact = TRUE))
    cat("wilcox.test", (spent[["user.self"]] + spent[["sys.self"]]) / 10, "\n", file = out)
}
cat(sprintf("%.15g", p), file = file.path(folder, "tied_p"))' "$folder"

"$build/deixis_bench" --benchmark_filter='power/' --benchmark_format=json >"$folder/power.json" 2>/dev/null
"$build/deixis_bench" --benchmark_filter='signed_rank/exact_with_ties/1000|bootstrap/|report/.*_2340_' \
    --benchmark_repetitions=5 --benchmark_report_aggregates_only=true --benchmark_format=json >"$folder/bench.json" 2>/dev/null

$python - "$folder" <<'END'
import json, statistics, sys, time
import numpy, scipy, scipy.stats
folder, times, missed = sys.argv[1], {}, False

def spent(name, run, repetitions=3):
    for _ in range(repetitions):
        begin = time.process_time()
        found = run()
        times.setdefault(name, []).append(time.process_time() - begin)
    return found

def say(what, deixis, against, other, limit=1.0):
    """`limit`: of the ratio."""
    global missed
    ratio = deixis / other
    missed |= ratio > limit
    share = f"1/{1 / ratio:.0f}" if ratio < 0.1 else f"{100 * ratio:.0f} %"
    print(f"{what:<52} {1000 * deixis:9.1f} ms  {against:<34} {1000 * other:9.1f} ms  {share}{' MISSED' if ratio > limit else ''}")

pairs = numpy.loadtxt(folder + "/pairs.csv", delimiter=",", skiprows=1)
scores = numpy.loadtxt(folder + "/scores.csv", delimiter=",", skiprows=1)
untied_p = spent("wilcoxon", lambda: scipy.stats.wilcoxon(pairs[:, 1], mode="exact").pvalue)
def bootstrap(columns):
    return scipy.stats.bootstrap((columns,), numpy.mean, axis=0, n_resamples=10000, method="BCa",
                                 random_state=numpy.random.default_rng(1)).confidence_interval
differences = [scores[:, a] - scores[:, b] for a in range(4) for b in range(a + 1, 4)]
spent("SciPy, 4 columns", lambda: bootstrap(scores))
interval = spent("SciPy, 10 columns", lambda: bootstrap(numpy.column_stack([scores, *differences])))
for line in open(folder + "/times"):
    name, seconds = line.split()
    times.setdefault(name, []).append(float(seconds))
took = {name: statistics.median(found) for name, found in times.items()}
bench = {b["run_name"]: b["cpu_time"] / 1000 for b in json.load(open(folder + "/bench.json"))["benchmarks"]
         if b["aggregate_name"] == "median" and b["time_unit"] == "ms"}
power = json.load(open(folder + "/power.json"))["benchmarks"][0]["real_time"]
answers = {name: json.load(open(f"{folder}/{name}.json")) for name in ("tied", "untied", "bootstrap")}
def same(a, b, allowed):
    if not abs(a - b) <= allowed:
        sys.exit(f"deixis finds {a}, the peer {b}")
same(answers["tied"]["p_two_sided"], float(open(folder + "/tied_p").read()), 1e-9)
same(answers["untied"]["p_two_sided"], untied_p, 1e-9)
for c, found in enumerate(answers["bootstrap"]["means"] + answers["bootstrap"]["differences"]):
    same(found["bca"]["lower"], interval.low[c], 0.03)

print(f"SciPy {scipy.__version__}, NumPy {numpy.__version__}")
say("signed-rank, 1,000 tied pairs, whole program", took["tied"], "R exactRankTests, exact", took["exactRankTests"], 1 / 30)
say("signed-rank, 1,000 untied pairs, whole program", took["untied"], "SciPy wilcoxon, exact", took["wilcoxon"])
say("", took["untied"], "R wilcox.test, exact", took["wilcox.test"], float("inf"))
say("10,000 bootstraps of 39 x 4, BCa", bench["bootstrap/10000_of_39_x_4"], "limit", 0.010)
say("", bench["bootstrap/10000_of_39_x_4"], "SciPy bootstrap, BCa", took["SciPy, 4 columns"])
say("means and 6 differences, whole program", took["bootstrap"], "SciPy bootstrap, BCa", took["SciPy, 10 columns"], float("inf"))
report = bench["report/analyse_and_render_2340_answers"]
say("report of 39 participants, figures too", report, "limit", 0.150)
say("reading its database first", report + bench["report/load_2340_answers"], "limit", 0.150)
say("power, 4 sizes x 1,000 studies, on the clock", power, "limit", 60.0)
sys.exit(missed)
END
