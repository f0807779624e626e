# Makes bradley_terry.json beside this script: abilities from preferences by R's glm, a logistic regression of
# the wins in each pair on who stands in it. Ties are half a win each; quasibinomial takes halves without a
# word and has the same estimates as binomial. The program under test takes no part.
#
# Run: Rscript tests/results/oracles/make_bradley_terry.R    Needs r-base and r-cran-jsonlite.
suppressMessages(library(jsonlite))

abilities <- function(wins) {
  n <- nrow(wins)
  pairs <- which(upper.tri(wins) & wins + t(wins) > 0, arr.ind = TRUE)
  design <- matrix(0, nrow(pairs), n)
  for (k in seq_len(nrow(pairs))) {
    design[k, pairs[k, 1]] <- 1
    design[k, pairs[k, 2]] <- -1
  }
  won <- wins[pairs]
  lost <- t(wins)[pairs]
  fit <- glm(cbind(won, lost) ~ 0 + design[, -1, drop = FALSE], family = quasibinomial,
             control = glm.control(epsilon = 1e-14, maxit = 100))
  b <- c(0, unname(coef(fit)))
  b - mean(b)
}

set.seed(1952)
random_wins <- function(n, strength, each, share_tied) {
  wins <- matrix(0, n, n)
  for (i in seq_len(n - 1)) for (j in (i + 1):n) {
    ties <- rbinom(1, each, share_tied)
    first <- rbinom(1, each - ties, plogis(strength[i] - strength[j]))
    wins[i, j] <- first + ties / 2
    wins[j, i] <- each - ties - first + ties / 2
  }
  wins
}
sparse <- rbind(c(0, 7, 0, 0), c(3, 0, 5.5, 0), c(0, 4.5, 0, 9), c(0, 0, 1, 0)) # each meets its neighbours only
cases <- list(
  list(name = "two systems", wins = rbind(c(0, 14.5), c(5.5, 0))),
  list(name = "three, few ties", wins = random_wins(3, c(0.5, 0, -0.5), 30, 0.1)),
  list(name = "four, many ties", wins = random_wins(4, c(1.5, 0.3, -0.2, -1.6), 40, 0.4)),
  list(name = "six, far apart", wins = random_wins(6, c(3, 2, 1, 0, -1, -2), 25, 0.2)),
  list(name = "a chain", wins = sparse))
for (k in seq_along(cases)) cases[[k]]$abilities <- abilities(cases[[k]]$wins)

here <- dirname(sub("--file=", "", grep("--file=", commandArgs(FALSE), value = TRUE)))
made_by <- paste("make_bradley_terry.R:", R.version.string)
writeLines(toJSON(list(made_by = unbox(made_by), cases = lapply(cases, function(case) {
  list(name = unbox(case$name), wins = case$wins, abilities = case$abilities)
})), digits = 15), file.path(here, "bradley_terry.json"))
