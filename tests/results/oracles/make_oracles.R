# R's answers to the cases of make_oracles.py, which runs this: Rscript make_oracles.R cases.json answers.json
suppressMessages({
  library(jsonlite)
  library(exactRankTests)
  library(coin)
  library(effectsize)
  library(boot)
})
files <- commandArgs(trailingOnly = TRUE)
cases <- fromJSON(files[1], simplifyVector = FALSE)

# Cells as doubles, rounded so that what is equal on paper is equal; missing ones stay missing.
number <- function(cell) {
  if (is.null(cell) || cell == "") return(NA_real_)
  parts <- as.numeric(strsplit(cell, "/", fixed = TRUE)[[1]])
  if (length(parts) == 2) parts[1] / parts[2] else parts[1]
}
numbers <- function(cells) vapply(cells, number, numeric(1))
quiet <- function(x) suppressMessages(suppressWarnings(x))

signed_rank <- function(case) {
  d <- numbers(case$a) - numbers(case$b)
  d <- signif(d[!is.na(d)], 12)
  d[abs(d) < 1e-13 * max(abs(c(d, 0)))] <- 0
  nonzero <- d[d != 0]
  out <- list()
  if (any(nchar(unlist(c(case$a, case$b))) > 15)) return(out)  # doubles cannot tell such numbers apart
  if (length(nonzero) < 2 || max(abs(d)) > 1e9 || max(abs(d)) < 1e-9) return(out)
  normal <- quiet(wilcox.test(nonzero, exact = FALSE, correct = TRUE))
  out$normal_p <- normal$p.value
  for (side in c("two.sided", "greater", "less"))
    out[[paste0("exact_", side)]] <- wilcox.exact(nonzero, alternative = side, exact = TRUE)$p.value
  if (length(d) <= 39)
    out$pratt <- pvalue(wilcoxsign_test(d ~ rep(0, length(d)), distribution = "exact", zero.method = "Pratt"))
  out$rank_biserial <- quiet(rank_biserial(d, rep(0, length(d)), paired = TRUE, ci = NULL))$r_rank_biserial
  if (all(d != 0) && !anyDuplicated(abs(d))) {
    found <- quiet(wilcox.test(d, exact = TRUE, conf.int = TRUE, conf.level = case$level))
    out$interval <- as.numeric(found$conf.int)
    out$level <- attr(found$conf.int, "conf.level")
  }
  out
}

rank_sum <- function(case) {
  a <- numbers(case$a); a <- signif(a[!is.na(a)], 12)
  b <- numbers(case$b); b <- signif(b[!is.na(b)], 12)
  out <- list()
  if (length(a) == 0 || length(b) == 0 || length(unique(c(a, b))) == 1 || max(abs(c(a, b))) > 1e9) return(out)
  out$normal_p <- quiet(wilcox.test(a, b, exact = FALSE, correct = TRUE))$p.value
  for (side in c("greater", "less"))
    out[[side]] <- quiet(wilcox.exact(a, b, alternative = side, exact = TRUE))$p.value
  if (length(a) > 1 && length(b) > 1) out$cliffs_delta <- quiet(cliffs_delta(a, b, ci = NULL))$r_rank_biserial
  group <- factor(rep(c("a", "b"), c(length(a), length(b))))
  out$coin_less <- pvalue(wilcox_test(c(a, b) ~ group, distribution = "exact", alternative = "less"))
  if (!anyDuplicated(c(a, b)) && length(a) > 1) {
    found <- quiet(wilcox.test(a, b, exact = TRUE, conf.int = TRUE, conf.level = case$level))
    out$two_sided <- found$p.value
    out$interval <- as.numeric(found$conf.int)
    out$estimate <- as.numeric(found$estimate)
  }
  out
}

# One row is too few for R.
friedman <- function(case) {
  x <- do.call(rbind, lapply(case$rows, function(row) signif(unlist(lapply(row, number)), 12)))
  if (nrow(x) < 2) return(list())
  found <- friedman.test(x)
  chi2 <- as.numeric(found$statistic)
  n <- nrow(x)
  k <- ncol(x)
  f <- (n - 1) * chi2 / (n * (k - 1) - chi2)
  out <- list(chi2 = chi2, df = k - 1, p = found$p.value, w = chi2 / (n * (k - 1)), f = f,
              f_p = pf(f, k - 1, (k - 1) * (n - 1), lower.tail = FALSE))
  if (!is.nan(chi2)) {
    long <- data.frame(y = as.vector(x), of = factor(rep(seq_len(k), each = n)), who = factor(rep(seq_len(n), k)))
    out$coin_chi2 <- as.numeric(statistic(friedman_test(y ~ of | who, long)))
    out$effectsize_w <- quiet(kendalls_w(x, ci = NULL))$Kendalls_W
  }
  out
}

shapiro <- function(case) {
  found <- shapiro.test(numbers(case$x))
  list(w = as.numeric(found$statistic), p = found$p.value)
}

spearman <- function(case) {
  x <- numbers(case$x)
  y <- numbers(case$y)
  if (length(x) < 3 || length(unique(x)) == 1 || length(unique(y)) == 1) return(list())
  untied <- !anyDuplicated(x) && !anyDuplicated(y)
  if (length(x) <= 9 && !untied) return(list(rho = cor(x, y, method = "spearman")))
  found <- quiet(cor.test(x, y, method = "spearman", exact = length(x) <= 9))
  list(rho = as.numeric(found$estimate), p = found$p.value)
}

holm <- function(case) {
  p <- vapply(case$p, function(p) if (is.null(p)) NA_real_ else as.numeric(p), numeric(1))
  list(adjusted = p.adjust(p, "holm"))
}

described <- function(case) {
  x <- numbers(case$x)
  q <- quantile(x, c(0.05, 0.25, 0.5, 0.75, 0.95), type = 7, names = FALSE)
  list(mean = mean(x), sd = sd(x), min = min(x), max = max(x), q = q, mad = mad(x))
}

# boot's quantiles are interpolated on the normal scale; with so many resamples that is below their error.
bootstrapped <- function(case) {
  set.seed(39)
  x <- as.numeric(case$x)
  drawn <- boot(x, function(x, i) mean(x[i]), R = 200000)
  found <- boot.ci(drawn, conf = case$level, type = c("perc", "bca"), L = x - mean(x))
  list(percentile = found$percent[4:5], bca = found$bca[4:5])
}

proportion <- function(case) {
  test <- function(side) binom.test(case$successes, case$n, case$chance, side, conf.level = case$level)
  found <- test("two.sided")
  list(p_chance = found$p.value, lower = found$conf.int[1], upper = found$conf.int[2],
       p_greater = test("greater")$p.value, p_less = test("less")$p.value)
}

# R's exact tied test of the large cases takes seconds each: the first one only.
large <- function(case) {
  if (length(case$a) > 1000) return(list())
  d <- numbers(case$a)
  list(exact_two.sided = wilcox.exact(d[d != 0], exact = TRUE)$p.value)
}

answers <- list(
  signed_rank = lapply(cases$signed_rank, signed_rank), signed_rank_large = lapply(cases$signed_rank_large, large),
  rank_sum = lapply(cases$rank_sum, rank_sum), friedman = lapply(cases$friedman, friedman),
  shapiro = lapply(cases$shapiro, shapiro), spearman = lapply(cases$spearman, spearman),
  holm = lapply(cases$holm, holm), describe = lapply(cases$describe, described),
  proportion = lapply(cases$proportion, proportion), bootstrap = lapply(cases$bootstrap, bootstrapped))
made_by <- paste0(R.version.string, ", exactRankTests ", packageVersion("exactRankTests"), ", coin ",
                  packageVersion("coin"), ", effectsize ", packageVersion("effectsize"), ", boot ", packageVersion("boot"))
write(toJSON(list(made_by = made_by, answers = answers), digits = NA, auto_unbox = TRUE, na = "null"), files[2])
