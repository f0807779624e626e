# Makes tests/results/reference/statistics_r.json: numbers of base R for the tests of results/statistics.
# Run: Rscript scripts/reference/statistics.R > tests/results/reference/statistics_r.json

numbers <- function(x) paste0("[", paste(sprintf("%.17g", x), collapse = ", "), "]")

signed_rank <- function(name, d, exact) {
  test <- suppressWarnings(wilcox.test(d, exact = exact, correct = TRUE))
  sprintf('    {"name": "%s", "method": "%s", "differences": %s, "w_plus": %.17g, "p": %.17g}',
          name, if (exact) "exact" else "normal approximation", numbers(d), test$statistic, test$p.value)
}

adjusted <- function(p) sprintf('    {"p": %s, "holm": %s}', numbers(p), numbers(p.adjust(p, "holm")))

described <- function(x) {
  q <- c(0, 0.05, 0.25, 0.5, 0.75, 0.95, 1)
  sprintf('    {"x": %s, "mean": %.17g, "sd": %.17g, "q": %s, "quantiles": %s}',
          numbers(x), mean(x), sd(x), numbers(q), numbers(quantile(x, q, type = 7, names = FALSE)))
}

set.seed(2023)
tests <- c(
  signed_rank("5 pairs, all positive", c(0.3, 1.1, 0.7, 2.5, 0.2), TRUE),
  signed_rank("8 pairs", round(rnorm(8, 0.4), 4), TRUE),
  signed_rank("20 pairs, no effect", round(rnorm(20), 5), TRUE),
  signed_rank("39 pairs, some effect", round(rnorm(39, 0.4), 5), TRUE),
  signed_rank("39 pairs, strong effect", round(rnorm(39, 1.5), 5), TRUE),
  signed_rank("90 pairs", round(rnorm(90, 0.2), 6), TRUE),
  signed_rank("150 pairs without ties", round(rnorm(150, 0.15), 6), FALSE),
  signed_rank("160 pairs with ties and zeros", round(rnorm(160, 0.1) * 4) / 10, FALSE),
  signed_rank("130 pairs, hardly any effect", round(rnorm(130) * 3) / 5, FALSE))
holms <- c(
  adjusted(c(0.01, 0.04, 0.03, 0.005)),
  adjusted(c(0.2, 0.2, 0.001, 0.9, 0.02, 0.0004)),
  adjusted(c(0.5)))
descriptions <- c(
  described(c(3, 1, 4, 1, 5, 9, 2, 6)),
  described(round(rnorm(39, 3.5, 0.6), 2)),
  described(c(2.5, 4)))

block <- function(x) paste0("[\n", paste(x, collapse = ",\n"), "\n  ]")
cat(sprintf('{\n  "made_by": "%s, scripts/reference/statistics.R",\n  "signed_rank": %s,\n  "holm": %s,\n  "descriptions": %s\n}\n',
            R.version.string, block(tests), block(holms), block(descriptions)))
