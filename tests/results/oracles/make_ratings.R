# Makes ratings.json: made-up ratings of three systems on pages, some missing and two of each participant's taken by
# attention checks, of clips that authors made in a first or second trial; and R's tests of single ratings: stats'
# wilcox.test with the normal approximation (|z| from its p), exactRankTests' wilcox.exact, p.adjust.
#
#   Rscript tests/results/oracles/make_ratings.R > tests/results/oracles/ratings.json
#
# Needs r-cran-exactranktests and r-cran-jsonlite.
suppressMessages({library(exactRankTests); library(jsonlite)})
set.seed(2021)
people <- sprintf("P%02d", 1:12)
rows <- expand.grid(system = c("auto", "sgt", "manual"), item = sprintf("S%02d", 1:8), participant = people,
                    stringsAsFactors = FALSE)
rows$order <- as.integer(substring(rows$item, 2)) + 2
person <- as.integer(factor(rows$participant))
rows$author_trial <- ifelse(rows$system == "auto", NA, sample(1:2, nrow(rows), replace = TRUE))
rows$rating <- pmin(100, pmax(0, round((50 + 12 * (rows$system == "sgt") - 6 * (rows$system == "manual") +
    3 * (!is.na(rows$author_trial) & rows$author_trial == 2) + rnorm(12, 0, 9)[person] + rnorm(nrow(rows), 0, 16)) / 5) * 5))
checked <- unlist(lapply(people, function(one) sample(which(rows$participant == one), 2)))
rows <- rows[-sort(c(checked, sample(setdiff(seq_len(nrow(rows)), checked), 9))), ]

# Twice the smaller exact tail; differences of zero dropped.
exact <- function(...) min(1, 2 * min(wilcox.exact(..., exact = TRUE, alternative = "greater")$p.value,
                                      wilcox.exact(..., exact = TRUE, alternative = "less")$p.value))
normal <- function(...) suppressWarnings(wilcox.test(..., exact = FALSE, correct = TRUE)$p.value)
with_z <- function(p) list(p_normal = p, z = qnorm(p / 2, lower.tail = FALSE))

of_system <- function(system) rows[rows$system == system, ]
pairs <- lapply(list(c("auto", "sgt"), c("auto", "manual"), c("sgt", "manual")), function(pair) {
    both <- merge(of_system(pair[1]), of_system(pair[2]), by = c("participant", "item"))
    one <- nrow(of_system(pair[1])) + nrow(of_system(pair[2])) - 2 * nrow(both)
    d <- both$rating.x - both$rating.y
    c(list(a = pair[1], b = pair[2], n = length(d), n_missing = one, participants = length(unique(both$participant)),
           mean_difference = mean(d), median_a = median(of_system(pair[1])$rating), median_b = median(of_system(pair[2])$rating),
           p = exact(d[d != 0])), with_z(normal(d[d != 0])))
})
pairs <- Map(function(one, adjusted) c(one, p_holm = adjusted), pairs, p.adjust(sapply(pairs, `[[`, "p"), "holm"))

trials <- lapply(c("sgt", "manual"), function(system) {
    of_trial <- function(trial) { here <- of_system(system); here[here$author_trial == trial, ] }
    a <- of_trial(1)
    b <- of_trial(2)
    means <- merge(aggregate(rating ~ participant, a, mean), aggregate(rating ~ participant, b, mean), by = "participant")
    d <- round(means$rating.x - means$rating.y, 9)
    list(system = system, ratings = c(list(n_a = nrow(a), n_b = nrow(b), median_a = median(a$rating), median_b = median(b$rating),
                                           p = exact(a$rating, b$rating)), with_z(normal(a$rating, b$rating))),
         participants = list(n = length(d), median_a = median(means$rating.x), median_b = median(means$rating.y),
                             mean_difference = mean(d), p = exact(d[d != 0])))
})
for (of in c("ratings", "participants")) {
    adjusted <- p.adjust(sapply(trials, function(one) one[[of]]$p), "holm")
    for (i in seq_along(trials)) trials[[i]][[of]]$p_holm <- adjusted[i]
}
csv <- capture.output(write.csv(cbind(rows, measure = "human-likeness"), row.names = FALSE, quote = FALSE, na = ""))
cat(toJSON(list(made_by = paste("make_ratings.R:", R.version.string, "exactRankTests", packageVersion("exactRankTests")),
                cases = list(list(csv = paste(csv, collapse = "\n"), pairs = pairs, trials = trials))),
           auto_unbox = TRUE, digits = NA))
cat("\n")
