#!/usr/bin/env bash
# Times the exact tied signed-rank test of 1,000 pairs: deixis (the whole program, reading the file too) and R's
# exactRankTests (the test alone), processor seconds, in turns on the same data.
#   bench/statistics_peers.sh DEIXIS
# Needs r-base-core and r-cran-exactranktests.
set -euo pipefail
deixis=$1
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
Rscript -e '
set.seed(39)
d <- sample(1:6, 1000, TRUE) * ifelse(runif(1000) < 0.55, 1, -1)
write.csv(data.frame(a = d / 10, b = 0), commandArgs(TRUE)[1], row.names = FALSE, quote = FALSE)' "$folder/pairs.csv"
for _ in 1 2 3; do
    Rscript -e '
    suppressMessages(library(exactRankTests))
    x <- read.csv(commandArgs(TRUE)[1])
    spent <- system.time(p <- wilcox.exact(x$a, x$b, paired = TRUE, exact = TRUE)$p.value)
    cat(sprintf("exactRankTests %.3f s, p = %.12g\n", spent[["user.self"]] + spent[["sys.self"]], p))' "$folder/pairs.csv"
    TIMEFORMAT='deixis         %3U s user, %3S s system'
    time "$deixis" stats signed-rank "$folder/pairs.csv" --columns a,b --json >"$folder/out.json"
    sed -n 's/ *"p_two_sided": \(.*\),/               p = \1/p' "$folder/out.json" | head -n 1
done
