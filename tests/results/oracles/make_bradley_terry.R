# Makes bradley_terry.json and bradley_terry_bootstrap.json beside this script: abilities from preferences by R's glm, a logistic regression of
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

# Bootstrap intervals over participants without drawing: every way in which seven participants can be drawn seven
# times, with its probability; the acceleration of BCa (Efron 1987) from the jackknife.
set.seed(1987)
people <- lapply(c(1, 1, 2, 2, 3, 4, 9), function(each) random_wins(3, c(0.7, 0, -0.7), each, 0.2))
for (k in 1:3) people[[k]] <- people[[k]] + matrix(c(0, 1, 1, 0, 0, 1, 0, 0, 0), 3) # who finds the first worst
drawn <- function(n, places) {
  if (places == 1) return(matrix(n))
  do.call(rbind, lapply(0:n, function(k) cbind(k, drawn(n - k, places - 1), deparse.level = 0)))
}
n <- length(people)
times <- drawn(n, n)
share <- apply(times, 1, function(t) factorial(n) / prod(factorial(t))) / n^n
stopifnot(abs(sum(share) - 1) < 1e-12)
total <- function(t) Reduce(`+`, Map(`*`, people, t))
# A finite maximum: from each system along wins to each (Ford 1957).
finite <- function(wins) {
  reach <- diag(3) + (wins > 0)
  all(reach %*% reach > 0)
}
kept <- apply(times, 1, function(t) finite(total(t)))
resampled <- apply(times[kept, ], 1, function(t) abilities(total(t)))
share <- share[kept] / sum(share[kept])
estimate <- abilities(total(rep(1, n)))
without <- sapply(seq_len(n), function(k) abilities(total(replace(rep(1, n), k, 0))))
ends <- function(k, probabilities) {
  order <- order(resampled[k, ])
  up_to <- cumsum(share[order])
  sapply(probabilities, function(p) resampled[k, order][which(up_to >= p)[1]])
}
intervals <- lapply(1:3, function(k) {
  equal <- abs(resampled[k, ] - estimate[k]) < 1e-7
  z0 <- qnorm(sum(share[resampled[k, ] < estimate[k] & !equal]) + sum(share[equal]) / 2)
  influence <- mean(without[k, ]) - without[k, ]
  a <- sum(influence^3) / (6 * sum(influence^2)^1.5)
  z <- z0 + qnorm(c(0.025, 0.975))
  list(ability = unbox(estimate[k]), percentile = ends(k, c(0.025, 0.975)), bca = ends(k, pnorm(z0 + z / (1 - a * z))))
})
writeLines(toJSON(list(made_by = unbox(made_by), cases = list(list(people = people, left_out = unbox(sum(!kept)),
  systems = intervals))), digits = 15), file.path(here, "bradley_terry_bootstrap.json"))
