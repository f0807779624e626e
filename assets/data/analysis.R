# Computes Deixis's analysis once more, in R, from the tables beside this file, and compares every number.
#
#   Rscript analysis.R   writes comparison.csv, mixed_models.csv and mixed_interactions.csv; status 1 where a number
#                        is off
#
# Base R is enough for the tests; mixed models need the packages ordinal and lme4 and are left out without
# them. Conventions: Deixis's docs/statistics.md. Exact distributions are computed here by plain convolution,
# independently of the program.

options(stringsAsFactors = FALSE)
arguments <- commandArgs(FALSE)
script <- sub("^--file=", "", grep("^--file=", arguments, value = TRUE))
if (length(script) == 1) setwd(dirname(normalizePath(script)))

labels <- c("participant", "measure", "system", "other_system", "layout", "distance", "item", "factor", "level",
            "a", "b", "c", "d", "other_factor", "status", "station", "family", "method", "stage", "score", "name", "excluded", "unit")
table_of <- function(name) {
    file <- paste0(name, ".csv")
    if (!file.exists(file)) return(NULL)
    columns <- names(read.csv(file, nrows = 1, check.names = FALSE))
    classes <- ifelse(columns %in% c(labels, "study"), "character", NA)
    names(classes) <- columns
    found <- read.csv(file, check.names = FALSE, colClasses = classes, na.strings = "", encoding = "UTF-8")
    attr(found, "table") <- name
    found
}

settings <- table_of("settings")
setting <- function(name) as.numeric(settings$value[settings$name == name])
level <- setting("level")
answers <- table_of("answers")
# The headline's: without who is left out and without choices that were skipped; those that timed out are wrong.
answers <- answers[is.na(answers$excluded) & answers$status != "skipped", ]
answers$value <- ifelse(is.na(answers$correct), answers$rating, answers$correct)
single <- is.na(answers$other_system)  # answers on one system; the others prefer one of two

# ---- comparison ------------------------------------------------------------------------------------------

compared <- data.frame()
same <- function(table, row, column, ours) {
    theirs <- as.numeric(table[[column]][row])
    ours <- as.numeric(ours)
    if (length(ours) == 0) ours <- NA
    off <- if (is.na(ours) && is.na(theirs)) 0 else abs(ours - theirs) / max(1, abs(theirs))
    compared <<- rbind(compared, data.frame(table = attr(table, "table"), row = row, column = column, deixis = theirs, r = ours,
                                            off = ifelse(is.na(off), Inf, off)))
}

# ---- tests -----------------------------------------------------------------------------------------------

# Participants' means are fractions of small whole numbers; nine decimals tell them apart, and equal ones are
# ties whatever their last bits.
tidy <- function(x) round(x, 9)

# P(W+ <= w) and P(W+ >= w) over all signs of the ranks.
exact_tails <- function(ranks, w) {
    doubled <- round(2 * ranks)
    ways <- 1
    for (r in doubled) ways <- (c(ways, numeric(r)) + c(numeric(r), ways)) / 2
    sums <- seq_along(ways) - 1
    c(sum(ways[sums <= 2 * w]), sum(ways[sums >= 2 * w]))
}

two_sided <- function(ranks, positive) {
    if (length(ranks) == 0) return(1)
    w <- sum(ranks[positive])
    if (length(ranks) <= 2000) return(min(1, 2 * min(exact_tails(ranks, w))))
    from_mean <- w - sum(ranks) / 2
    z <- (from_mean - sign(from_mean) / 2) / sqrt(sum(ranks^2) / 4)
    min(1, 2 * pnorm(-abs(z)))
}

# The shifts that a test does not reject: p(shift) is tried at all places (pairwise means or differences) where it
# can change and between each two of them; of very many places only at those near the ends. The interval holds 0
# exactly where p(0) exceeds 1 - level.
inverted <- function(places, p) {
    # 1 - level is seldom a double: a p that equals it on paper is rejected.
    alpha <- (1 - level) * (1 + 1e-9)
    u <- sort(places)
    u <- u[!duplicated(tidy(u))]  # not rounded themselves, so that what ties at them does
    n <- length(u)
    shifts <- c(u[1] - 1, as.vector(rbind(u, c((u[-1] + u[-n]) / 2, u[n] + 1))))
    below <- (findInterval(shifts, sort(tidy(places))) + findInterval(shifts, sort(tidy(places)), left.open = TRUE)) / 2
    share <- pmin(below, length(places) - below) / length(places)
    # The middle is not rejected, and what lies far out is; alpha says where its ends are, roughly.
    near <- n <= 250
    if (!near) {
        middle <- 0.5 + qnorm(alpha / 2) * sqrt(attr(places, "variance")) / length(places)
        window <- share > 0.5 * middle & share < min(0.5, middle + 0.6 * (0.5 - middle))
    } else window <- rep(TRUE, length(shifts))
    found <- ifelse(share > 0.25, 1, 0)
    found[window] <- vapply(shifts[window], p, numeric(1))
    held <- seq(1, length(shifts), 2)
    held <- held[found[held] > alpha]  # between places
    of_zero <- p(0)
    beside <- c(p(-1e-8), p(1e-8))
    outside <- 0
    ends <- list()
    if (length(held) == 0) {  # all alike, or nearly so
        only <- Filter(function(shift) p(shift) > alpha, c(median(places), 0))
        if (length(only) == 0) return(list(NA, NA, 1, 1, NA))
        ends <- list(c(only[1], 1), c(only[1], 1))
        outside <- max(p(only[1] - 1e-8), p(only[1] + 1e-8))
    } else for (at in c(held[1], -held[length(held)])) {
        step <- -sign(at)
        at <- abs(at)
        beyond <- at + step
        if (beyond >= 1 && beyond <= length(shifts)) {
            included <- found[beyond] > alpha
            ends <- c(ends, list(c(shifts[beyond], as.numeric(included))))
            outside <- max(outside, found[beyond + step], if (included) 0 else found[beyond])
        } else {  # the widest there is
            ends <- c(ends, list(c(shifts[at - step], 1)))
            outside <- max(outside, found[at])
        }
    }
    if (outside > alpha) {
        # the widest interval speaks at its own level
    } else if (of_zero > alpha) {
        if (ends[[1]][1] >= 0) ends[[1]] <- c(0, 1)
        if (ends[[2]][1] <= 0) ends[[2]] <- c(0, 1)
    } else if (ends[[1]][1] <= 0 && ends[[2]][1] >= 0) {
        outside <- max(outside, of_zero)
        ends[[if (beside[1] < beside[2]) 1 else 2]] <- c(0, 0)
    }
    list(ends[[1]][1], ends[[2]][1], ends[[1]][2], ends[[2]][2], 1 - outside)
}
interval_columns <- paste0("hodges_lehmann_", c("lower", "upper", "lower_included", "upper_included", "level"))

signed_rank_p <- function(exactly, shift) {
    d <- tidy(exactly - shift)
    d <- d[d != 0]
    two_sided(rank(abs(d)), d > 0)
}

# `interval`: the program gives one, too.
signed_rank <- function(exactly, interval = TRUE) {
    d <- tidy(exactly)
    n <- length(d)
    nonzero <- d[d != 0]
    ranks <- rank(abs(nonzero))
    out <- list(n = n, n_zero = sum(d == 0), n_positive = sum(d > 0), n_negative = sum(d < 0),
                ties = sum(table(abs(nonzero)) > 1), w_plus = sum(ranks[nonzero > 0]),
                w_minus = sum(ranks[nonzero < 0]), p = two_sided(ranks, nonzero > 0),
                paired_superiority = mean((d > 0) + (d == 0) / 2), smallest_p = NA, z = NA, p_normal = 1,
                p_pratt = 1, rank_biserial = NA)
    if (length(nonzero) > 0) {
        from_mean <- out$w_plus - sum(ranks) / 2
        out$z <- (from_mean - sign(from_mean) / 2) / sqrt(sum(ranks^2) / 4)
        out$p_normal <- min(1, 2 * pnorm(-abs(out$z)))
        out$p_pratt <- two_sided(rank(abs(d))[d != 0], nonzero > 0)
        out$rank_biserial <- (out$w_plus - out$w_minus) / sum(ranks)
        out$smallest_p <- 2^(1 - length(nonzero))
    }
    if (n == 0) {  # nobody answered to both: no p, and no place in the family
        out[c("p", "p_normal", "p_pratt")] <- NA
        return(out)
    }
    walsh <- outer(exactly, exactly, "+")[lower.tri(diag(n), diag = TRUE)] / 2
    out$hodges_lehmann <- median(walsh)
    attr(walsh, "variance") <- n * (n + 1) * (2 * n + 1) / 24
    if (interval) out[interval_columns] <- inverted(walsh, function(shift) signed_rank_p(exactly, shift))
    spread <- n >= 3 && n <= 5000 && length(unique(d)) > 1
    normality <- if (spread) shapiro.test(exactly) else NULL
    out$shapiro_w <- if (spread) normality$statistic else NA
    out$shapiro_p <- if (spread) normality$p.value else NA
    out
}

# Compares a table of signed-rank tests; differences(i): those of its row i.
compare_tests <- function(tests, differences, interval = TRUE) {
    found <- lapply(seq_len(nrow(tests)), function(i) signed_rank(differences(i), interval))
    for (i in seq_along(found))
        for (column in names(found[[i]])) {
            if (column %in% c("smallest_p") && is.na(found[[i]][[column]])) next
            same(tests, i, column, found[[i]][[column]])
        }
    for (family in unique(tests$family)) {
        rows <- which(tests$family == family)
        for (adjusted in c("p", "p_pratt")) {
            p <- p.adjust(sapply(rows, function(i) found[[i]][[adjusted]]), "holm")
            for (j in seq_along(rows))
                same(tests, rows[j], if (adjusted == "p") "p_holm" else "p_holm_pratt", p[j])
        }
    }
}

# Means of participants over the answers that `which` picks, named by participant.
means_of <- function(which) {
    values <- answers$value[which]
    people <- answers$participant[which]
    vapply(split(values, people), mean, numeric(1))
}
paired <- function(first, second) {
    people <- intersect(names(first), names(second))
    first[people] - second[people]
}
is <- function(column, value) !is.na(answers[[column]]) & answers[[column]] == value

of_system_or_all <- function(system) if (system == "all") rep(TRUE, nrow(answers)) else is("system", system)

# P(U <= u) and P(U >= u) over all ways to take n_a of the ranks.
rank_sum_tails <- function(ranks, n_a, w) {
    doubled <- round(2 * ranks)
    ways <- matrix(0, n_a + 1, sum(doubled) + 1)  # by how many are taken, and their sum
    ways[1, 1] <- 1
    for (r in doubled) {  # each rank is taken or not
        at <- seq_len(ncol(ways) - r)
        ways[-1, r + at] <- ways[-1, r + at] + ways[-(n_a + 1), at]
    }
    share <- ways[n_a + 1, ] / sum(ways[n_a + 1, ])
    sums <- seq_along(share) - 1
    c(sum(share[sums <= 2 * w]), sum(share[sums >= 2 * w]))
}

rank_sum_p <- function(a, b) {
    n_a <- length(a)
    n <- n_a + length(b)
    ranks <- rank(tidy(c(a, b)))
    w <- sum(ranks[seq_len(n_a)])
    if (n <= 400) return(min(1, 2 * min(rank_sum_tails(ranks, n_a, w))))
    spread <- sqrt(n_a * (n - n_a) / (n * (n - 1)) * sum((ranks - mean(ranks))^2))
    from_mean <- w - n_a * (n + 1) / 2
    if (spread == 0) 1 else min(1, 2 * pnorm(-max(0, abs(from_mean) - 0.5) / spread))
}

rank_sum <- function(exactly_a, exactly_b, interval = TRUE) {
    a <- tidy(exactly_a)
    b <- tidy(exactly_b)
    n_a <- length(a)
    n_b <- length(b)
    if (n_a == 0 || n_b == 0) return(list(n_a = n_a, n_b = n_b, p = NA))
    ranks <- rank(c(a, b))
    w <- sum(ranks[seq_len(n_a)])
    u <- w - n_a * (n_a + 1) / 2
    ties <- as.numeric(table(c(a, b)))
    n <- n_a + n_b
    spread <- sqrt(n_a * n_b / 12 * (n + 1 - sum(ties^3 - ties) / (n * (n - 1))))
    out <- list(n_a = n_a, n_b = n_b, mean_a = mean(exactly_a), mean_b = mean(exactly_b), u = u, ties = sum(ties > 1),
                a12 = u / (n_a * n_b), cliffs_delta = 2 * u / (n_a * n_b) - 1)
    from_mean <- u - n_a * n_b / 2
    if (spread > 0) {
        out$z <- (from_mean - sign(from_mean) / 2) / spread
        out$p_normal <- min(1, 2 * pnorm(-abs(out$z)))
        out$p <- if (n <= 400) min(1, 2 * min(rank_sum_tails(ranks, n_a, w))) else out$p_normal
    } else {
        out$p <- 1
    }
    shifts <- as.vector(outer(exactly_a, exactly_b, "-"))
    out$hodges_lehmann <- median(shifts)
    attr(shifts, "variance") <- n_a * n_b * (n + 1) / 12
    if (interval) out[interval_columns] <- inverted(shifts, function(shift) rank_sum_p(exactly_a - shift, exactly_b))
    out
}

# ---- tables ----------------------------------------------------------------------------------------------

# Of several studies the tables study_... hold each by itself: the answers of a row's study.
in_study <- function(table, i) {
    if (is.null(table$study) || table$study[i] == "pooled") rep(TRUE, nrow(answers)) else is("study", table$study[i])
}

means <- table_of("means")
compare_means <- function(means) for (i in seq_len(NROW(means))) {
    here <- single & in_study(means, i) & is("measure", means$measure[i]) & is("system", means$system[i])
    by_participant <- means_of(here)
    same(means, i, "mean", mean(by_participant))
    same(means, i, "median", if (length(by_participant) > 0) median(by_participant) else NA)
    same(means, i, "sd_participants", if (length(by_participant) > 1) sd(by_participant) else NA)
    same(means, i, "sd_trials", if (sum(here) > 1) sd(answers$value[here]) else NA)
    same(means, i, "participants", length(by_participant))
    same(means, i, "answers", sum(here))
}
compare_means(means)
compare_means(table_of("study_means"))

medians <- table_of("study_medians")
for (i in seq_len(NROW(medians))) {
    here <- single & in_study(medians, i) & is("measure", medians$measure[i])
    of_system <- here & is("system", medians$system[i])
    by_participant <- means_of(of_system)
    same(medians, i, "median", median(by_participant))
    if (all(is.na(answers$correct[of_system]))) same(medians, i, "median_of_ratings", median(answers$value[of_system]))
    same(medians, i, "participants", length(by_participant))
    same(medians, i, "answers", sum(of_system))
    all_medians <- vapply(unique(answers$system[here]), function(s) median(means_of(here & is("system", s))), numeric(1))
    same(medians, i, "place", 1 + sum(tidy(all_medians) > tidy(median(by_participant))))
}

levels_table <- table_of("levels")
for (i in seq_len(NROW(levels_table))) {
    row <- levels_table[i, ]
    here <- single & is("measure", row$measure) & is(row$factor, row$level) &
        of_system_or_all(row$system)
    same(levels_table, i, "mean", mean(answers$value[here]))
    same(levels_table, i, "sd_trials", if (sum(here) > 1) sd(answers$value[here]) else NA)
    same(levels_table, i, "answers", sum(here))
}

compare_omnibus <- function(omnibus) for (i in seq_len(NROW(omnibus))) {
    systems <- unique(means$system[means$measure == omnibus$measure[i]])
    columns <- lapply(systems, function(s)
        means_of(single & in_study(omnibus, i) & is("measure", omnibus$measure[i]) & is("system", s)))
    people <- Reduce(intersect, lapply(columns, names))
    n <- length(people)
    scores <- tidy(vapply(columns, function(column) column[people], numeric(n)))
    k <- length(systems)
    same(omnibus, i, "n", n)
    if (n < 2 || k < 2) next
    test <- friedman.test(scores)
    chi2 <- if (is.nan(test$statistic)) NA else test$statistic
    same(omnibus, i, "chi2", chi2)
    same(omnibus, i, "df", k - 1)
    same(omnibus, i, "p", if (is.na(chi2)) NA else test$p.value)
    same(omnibus, i, "kendalls_w", chi2 / (n * (k - 1)))
    rest <- n * (k - 1) - chi2
    if (!is.na(rest) && rest > 1e-9) {
        f <- (n - 1) * chi2 / rest
        same(omnibus, i, "f", f)
        same(omnibus, i, "p_f", pf(f, k - 1, (k - 1) * (n - 1), lower.tail = FALSE))
    }
}
compare_omnibus(table_of("omnibus"))
compare_omnibus(table_of("study_omnibus"))

for (pairwise in Filter(Negate(is.null), list(table_of("pairwise"), table_of("study_pairwise")))) {
    of_system <- function(i, system)
        means_of(single & in_study(pairwise, i) & is("measure", pairwise$measure[i]) & is("system", system))
    differences <- function(i) paired(of_system(i, pairwise$a[i]), of_system(i, pairwise$b[i]))
    compare_tests(pairwise, differences)
    for (i in seq_len(nrow(pairwise))) same(pairwise, i, "mean_difference", mean(differences(i)))
}

level_tests <- table_of("level_tests")
if (!is.null(level_tests)) {
    of_level <- function(row, level)
        means_of(single & is("measure", row$measure) & of_system_or_all(row$system) & is(row$factor, level))
    compare_tests(level_tests, function(i) {
        row <- level_tests[i, ]
        paired(of_level(row, row$a), of_level(row, row$b))
    })
}

# Single ratings by what makes two of them a pair: the page (a trial in which one participant rated several systems for
# one item), else participant, item, layout and distance. Several of one system in a pair are averaged.
ratings_by_pair <- function(here) {
    own <- answers[here, ]
    trial <- paste(own$participant, own$order, own$item, sep = "\r")
    systems <- tapply(own$system, trial, function(s) length(unique(s)))[trial]
    pair <- ifelse(!is.na(own$order) & systems > 1, trial,
                   ifelse(is.na(own$item), NA, paste(own$participant, own$item, own$layout, own$distance, "", sep = "\r")))
    lapply(split(seq_len(nrow(own)), own$system), function(of) {
        of <- of[!is.na(pair[of])]
        vapply(split(own$value[of], pair[of]), mean, numeric(1))
    })
}

for (ratings in Filter(Negate(is.null), list(table_of("pairwise_ratings"), table_of("study_pairwise_ratings")))) {
    of_row <- function(i) single & in_study(ratings, i) & is("measure", ratings$measure[i])
    by_pair <- lapply(seq_len(nrow(ratings)), function(i) ratings_by_pair(of_row(i)))
    side <- function(i, column) {
        found <- by_pair[[i]][[ratings[[column]][i]]]
        if (is.null(found)) setNames(numeric(), character()) else found
    }
    compare_tests(ratings, function(i) paired(side(i, "a"), side(i, "b")), FALSE)
    for (i in seq_len(nrow(ratings))) {
        both <- intersect(names(side(i, "a")), names(side(i, "b")))
        same(ratings, i, "participants", length(unique(sub("\r.*", "", both))))
        same(ratings, i, "n_missing", length(side(i, "a")) + length(side(i, "b")) - 2 * length(both))
        for (column in c("a", "b")) {
            here <- of_row(i) & is("system", ratings[[column]][i])
            same(ratings, i, paste0("median_", column), if (any(here)) median(answers$value[here]) else NA)
        }
        if (length(both) > 0) same(ratings, i, "mean_difference", mean(paired(side(i, "a"), side(i, "b"))))
    }
}

# Compares a table of rank-sum tests; group(row, level): the scores of that level's participants.
compare_groups <- function(tests, group, interval = TRUE) {
    found <- lapply(seq_len(nrow(tests)), function(i) {
        row <- tests[i, ]
        rank_sum(group(row, row$a), group(row, row$b), interval)
    })
    for (i in seq_along(found))
        for (column in names(found[[i]])) same(tests, i, column, found[[i]][[column]])
    for (family in unique(tests$family)) {
        rows <- which(tests$family == family)
        p <- p.adjust(sapply(found[rows], function(test) test$p), "holm")
        for (j in seq_along(rows)) same(tests, rows[j], "p_holm", p[j])
    }
}

for (between in Filter(Negate(is.null), list(table_of("between"), table_of("study_between")))) {
    # Of each participant the mean, or the mean of the means under each system.
    compare_groups(between, function(row, level) {
        here <- single & in_study(row, 1) & is("measure", row$measure) & is(row$factor, level)
        if (row$system != "all") return(means_of(here & is("system", row$system)))
        by_system <- lapply(unique(answers$system[here]), function(s) means_of(here & is("system", s)))
        people <- unique(answers$participant[here])
        sapply(people, function(one) mean(unlist(lapply(by_system, function(column) column[one])), na.rm = TRUE))
    })
}

of_author_trial <- function(row, trial)
    single & in_study(row, 1) & is("measure", row$measure) & is("system", row$system) & is("author_trial", as.numeric(trial))
for (trials in Filter(Negate(is.null), list(table_of("author_trials"), table_of("study_author_trials")))) {
    compare_groups(trials, function(row, trial) answers$value[of_author_trial(row, trial)], FALSE)
    for (i in seq_len(nrow(trials)))
        for (column in c("a", "b"))
            same(trials, i, paste0("median_", column),
                 median(answers$value[of_author_trial(trials[i, ], trials[[column]][i])]))
}
for (trials in Filter(Negate(is.null), list(table_of("author_trials_by_participants"),
                                            table_of("study_author_trials_by_participants")))) {
    of_trial <- function(i, column) means_of(of_author_trial(trials[i, ], trials[[column]][i]))
    compare_tests(trials, function(i) paired(of_trial(i, "a"), of_trial(i, "b")))
    for (i in seq_len(nrow(trials))) {
        both <- intersect(names(of_trial(i, "a")), names(of_trial(i, "b")))
        for (column in c("a", "b"))
            same(trials, i, paste0("median_", column), if (length(both) > 0) median(of_trial(i, column)[both]) else NA)
    }
}

# Of each participant and cell the mean of the means under each system.
cell_means <- function(here) {
    by_system <- lapply(unique(answers$system[here]), function(s) means_of(here & is("system", s)))
    people <- unique(answers$participant[here])
    vapply(setNames(people, people), function(one) mean(unlist(lapply(by_system, function(column) column[one])), na.rm = TRUE),
           numeric(1))
}

interactions <- table_of("interactions")
if (!is.null(interactions)) {
    in_cell <- function(row, one, other)
        cell_means(single & is("measure", row$measure) & is(row$factor, one) & is(row$other_factor, other))
    contrasts <- function(i) {
        row <- interactions[i, ]
        paired(paired(in_cell(row, row$a, row$c), in_cell(row, row$b, row$c)),
               paired(in_cell(row, row$a, row$d), in_cell(row, row$b, row$d)))
    }
    compare_tests(interactions, contrasts)
    for (i in seq_len(nrow(interactions))) same(interactions, i, "mean_difference", mean(contrasts(i)))
}

group_interactions <- table_of("group_interactions")
if (!is.null(group_interactions))
    compare_groups(group_interactions, function(row, level) {
        here <- single & is("measure", row$measure) & is(row$factor, level)
        paired(cell_means(here & is(row$other_factor, row$c)), cell_means(here & is(row$other_factor, row$d)))
    })

equivalence <- table_of("equivalence")
if (!is.null(equivalence)) {
    # p of the shift being above 0, and below.
    one_sided <- function(exactly) {
        d <- tidy(exactly)
        d <- d[d != 0]
        if (length(d) == 0) return(c(1, 1))
        rev(exact_tails(rank(abs(d)), sum(rank(abs(d))[d > 0])))
    }
    one_sided_groups <- function(a, b) {
        ranks <- rank(tidy(c(a, b)))
        rev(rank_sum_tails(ranks, length(a), sum(ranks[seq_along(a)])))
    }
    p <- vapply(seq_len(nrow(equivalence)), function(i) {
        row <- equivalence[i, ]
        factor <- if (is.na(row$factor)) "system" else row$factor
        within <- if (is.na(row$system) || row$system == "all") rep(TRUE, nrow(answers)) else is("system", row$system)
        of <- function(level) {
            here <- single & is("measure", row$measure) & within & is(factor, level)
            if (grepl("over systems|within systems", row$family)) means_of(here) else cell_means(here)
        }
        a <- of(row$a)
        b <- of(row$b)
        d <- paired(a, b)
        if (length(d) > 0) max(one_sided(d + row$bound)[1], one_sided(d - row$bound)[2])
        else max(one_sided_groups(a + row$bound, b)[1], one_sided_groups(a - row$bound, b)[2])
    }, numeric(1))
    for (family in unique(equivalence$family)) {
        rows <- which(equivalence$family == family)
        adjusted <- p.adjust(p[rows], "holm")
        for (j in seq_along(rows)) {
            same(equivalence, rows[j], "p", p[rows[j]])
            same(equivalence, rows[j], "p_holm", adjusted[j])
        }
    }
}

pooled_ratings <- table_of("pooled_ratings")
for (i in seq_len(NROW(pooled_ratings))) {
    here <- single & is("measure", pooled_ratings$measure[i]) & is("system", pooled_ratings$system[i])
    values <- answers$value[here]
    same(pooled_ratings, i, "n", length(values))
    same(pooled_ratings, i, "mean", mean(values))
    same(pooled_ratings, i, "sd", if (length(values) > 1) sd(values) else NA)
    for (q in c(5, 25, 75, 95)) same(pooled_ratings, i, sprintf("q%02d", q), quantile(values, q / 100, type = 7))
    same(pooled_ratings, i, "median", median(values))
}

# Answers to a pair of systems, positive for a; of those that `which` picks.
towards <- function(a, b, which = TRUE) {
    forth <- which & is("system", a) & is("other_system", b)
    back <- which & is("system", b) & is("other_system", a)
    # A preference below 0 is for the first of the two.
    chosen <- answers[forth | back, ]
    chosen$value <- ifelse(back, answers$value, -answers$value)[forth | back]
    chosen
}
net_preferences <- function(chosen) vapply(split(chosen$value, chosen$participant), mean, numeric(1))

for (preferences in Filter(Negate(is.null), list(table_of("preferences"), table_of("study_preferences")))) {
    of_pair <- function(i) towards(preferences$a[i], preferences$b[i], in_study(preferences, i))
    compare_tests(preferences, function(i) net_preferences(of_pair(i)))
    for (i in seq_len(nrow(preferences))) {
        chosen <- of_pair(i)
        same(preferences, i, "mean", mean(net_preferences(chosen)))
        same(preferences, i, "prefers_a", sum(chosen$value > 0))
        same(preferences, i, "equal", sum(chosen$value == 0))
        same(preferences, i, "prefers_b", sum(chosen$value < 0))
    }
}

preferences_between <- table_of("preferences_between")
if (!is.null(preferences_between)) {
    of_level <- function(row, level) {
        chosen <- towards(row$system, row$other_system)
        chosen[!is.na(chosen[[row$factor]]) & chosen[[row$factor]] == level, ]
    }
    compare_groups(preferences_between, function(row, level) net_preferences(of_level(row, level)))
    for (i in seq_len(nrow(preferences_between)))
        for (side in c("a", "b")) {
            chosen <- of_level(preferences_between[i, ], preferences_between[[side]][i])
            same(preferences_between, i, paste0("answers_", side), nrow(chosen))
            same(preferences_between, i, paste0("wins_", side), mean(chosen$value > 0))
            same(preferences_between, i, paste0("ties_", side), mean(chosen$value == 0))
            same(preferences_between, i, paste0("losses_", side), mean(chosen$value < 0))
        }
}

chance <- table_of("chance")
if (!is.null(chance)) {
    # Each trial's own chance; trials without a number of balls have no part in it.
    with_balls <- function(i) is("system", chance$system[i]) & !is.na(answers$correct) & !is.na(answers$balls)
    by_person <- function(values, here) vapply(split(values[here], answers$participant[here]), mean, numeric(1))
    above <- function(i) by_person(answers$correct - 1 / answers$balls, with_balls(i))
    compare_tests(chance, above)
    for (i in seq_len(nrow(chance))) {
        here <- is("system", chance$system[i]) & !is.na(answers$correct)
        same(chance, i, "successes", sum(answers$correct[here]))
        same(chance, i, "choices", sum(here))
        same(chance, i, "estimate", mean(answers$correct[here]))
        if (!any(with_balls(i))) next
        same(chance, i, "mean_above", mean(above(i)))
        same(chance, i, "chance", mean(by_person(1 / answers$balls, with_balls(i))))
    }
}

order_table <- table_of("order")
if (!is.null(order_table)) {
    halves <- function(i) {
        rows <- which(single & is("measure", order_table$measure[i]) & !is.na(answers$order))
        do.call(rbind, lapply(split(rows, answers$participant[rows]), function(own) {
            own <- own[order(answers$order[own])]
            first <- seq_along(own) <= (length(own) + 1) %/% 2
            if (length(own) < 2) return(NULL)
            data.frame(first = mean(answers$value[own][first]), second = mean(answers$value[own][!first]))
        }))
    }
    compare_tests(order_table, function(i) with(halves(i), second - first))
    for (i in seq_len(nrow(order_table))) {
        same(order_table, i, "first_half", mean(halves(i)$first))
        same(order_table, i, "second_half", mean(halves(i)$second))
    }
}

response_times <- table_of("response_times")
for (i in seq_len(NROW(response_times))) {
    here <- single & is("measure", response_times$measure[i]) & is("system", response_times$system[i])
    times <- answers$rt[here & !is.na(answers$rt)]
    same(response_times, i, "n", length(times))
    for (q in c(25, 75)) same(response_times, i, sprintf("q%d_s", q), quantile(times, q / 100, type = 7))
    same(response_times, i, "median_s", median(times))
}

items <- table_of("items")
for (i in seq_len(NROW(items))) {
    here <- single & is("measure", items$measure[i]) & is("item", items$item[i])
    same(items, i, "mean", mean(answers$value[here]))
    same(items, i, "answers", sum(here))
}

# ---- mixed models ----------------------------------------------------------------------------------------

has <- function(package) {
    found <- requireNamespace(package, quietly = TRUE)
    if (!found) cat("no mixed model by", package, ": the package is not installed\n")
    found
}

# Contrasts of all pairs of systems from a model's coefficients, Wald tests, Holm within the measure. Without a model
# all is NA, and the note says why.
contrasts_of <- function(measure, name, systems, fit) {
    at <- function(system) paste0("system", system)
    rows <- data.frame()
    for (pair in combn(systems, 2, simplify = FALSE)) {
        estimate <- se <- z <- NA_real_
        if (!is.null(fit$slopes)) {
            weights <- setNames(numeric(length(fit$slopes)), names(fit$slopes))
            for (k in 1:2) if (at(pair[k]) %in% names(weights)) weights[at(pair[k])] <- c(1, -1)[k]
            estimate <- sum(weights * fit$slopes)
            se <- sqrt(as.numeric(weights %*% fit$covariance[names(weights), names(weights), drop = FALSE] %*% weights))
            z <- estimate / se
        }
        rows <- rbind(rows, data.frame(measure, model = name, a = pair[1], b = pair[2], estimate, se, z,
                                       p = 2 * pnorm(-abs(z))))
    }
    rows$p_holm <- p.adjust(rows$p, "holm")
    rows$note <- fit$note
    rows$random <- fit$random
    rows
}

# What R says while a model is fitted; an error leaves no model.
heard <- function(fit) {
    said <- character()
    hear <- function(condition, restart) {
        said <<- c(said, trimws(gsub("\\s+", " ", conditionMessage(condition))))
        invokeRestart(restart)
    }
    model <- tryCatch(withCallingHandlers(fit, message = function(m) hear(m, "muffleMessage"),
                                          warning = function(w) hear(w, "muffleWarning")),
                      error = function(e) { said <<- c(said, conditionMessage(e)); NULL })
    list(model = model, said = unique(said))
}

# Fits one formula with one optimiser.
fit_with <- function(kind, formula, data, other) {
    if (kind == "ordinal") {
        control <- if (other) ordinal::clmm.control(method = "nlminb") else ordinal::clmm.control()
        return(ordinal::clmm(formula, data = data, control = control))
    }
    most <- list(maxfun = 2e5)
    if (kind == "binary")
        lme4::glmer(formula, data, family = binomial,
                    control = if (other) lme4::glmerControl("bobyqa", optCtrl = most) else lme4::glmerControl())
    else
        lme4::lmer(formula, data, control = if (other) lme4::lmerControl("bobyqa", optCtrl = most) else lme4::lmerControl())
}

slopes_of <- function(kind, model) if (kind == "ordinal") model$beta else lme4::fixef(model)
is_singular <- function(kind, model) {
    if (kind != "ordinal") return(lme4::isSingular(model))
    any(vapply(ordinal::VarCorr(model), function(v) {
        sds <- attr(v, "stddev")
        related <- attr(v, "correlation")
        any(sds < 1e-3) || !is.null(related) && any(abs(related[upper.tri(related)]) > 0.999)
    }, logical(1)))
}

# Why a fit is not a maximum that can be trusted; empty where it is. A Hessian that is not positive definite or a
# gradient that is not 0 means that the optimiser stopped elsewhere, and its standard errors mean nothing.
doubts_about <- function(kind, model) {
    covariance <- tryCatch(suppressWarnings(as.matrix(vcov(model))), error = function(e) NULL)
    if (is.null(covariance)) return("no covariance of the estimates")
    slopes <- slopes_of(kind, model)
    ses <- sqrt(diag(covariance)[names(slopes)])
    if (any(!is.finite(slopes)) || any(!is.finite(ses)) || any(ses <= 0)) return("a standard error is not defined")
    if (kind != "linear" && any(abs(slopes) > 15 | ses > 15))
        return("an estimate has no bound: all answers to a system are alike")
    if (kind == "ordinal") {
        gradient <- model$gradient
        hessian <- model$Hessian
    } else {
        if (length(model@optinfo$conv$opt) > 0 && model@optinfo$conv$opt != 0) return("the optimiser did not converge")
        gradient <- model@optinfo$derivs$gradient
        hessian <- model@optinfo$derivs$Hessian
    }
    if (is.null(hessian) || is.null(gradient) || is_singular(kind, model)) return(character())
    if (any(!is.finite(hessian)) || any(!is.finite(gradient))) return("the Hessian is not finite")
    values <- eigen((hessian + t(hessian)) / 2, symmetric = TRUE, only.values = TRUE)$values
    if (min(values) <= 1e-6 * max(values)) return("the Hessian is not positive definite")
    step <- tryCatch(solve(hessian, gradient), error = function(e) Inf)
    if (max(pmin(abs(step), abs(gradient))) > 0.002)
        return(sprintf("the gradient is not 0 (%.2g)", max(abs(gradient))))
    character()
}

# The two fits say the same.
agree <- function(kind, one, two) {
    ses <- sqrt(diag(as.matrix(vcov(one)))[names(slopes_of(kind, one))])
    others <- sqrt(diag(as.matrix(vcov(two)))[names(slopes_of(kind, two))])
    all(abs(slopes_of(kind, one) - slopes_of(kind, two)) < 0.05 * ses) && all(abs(log(ses / others)) < 0.05)
}

# A formula by one optimiser, and by another that must agree: the model, or what is wrong with it. A variance at its
# bound is told (`singular`); such a fit is not made a second time.
trusted_fit <- function(kind, formula, data) {
    reasons <- character()
    good <- list()
    for (other in c(FALSE, TRUE)) {
        fit <- heard(fit_with(kind, formula, data, other))
        why <- if (is.null(fit$model)) fit$said else doubts_about(kind, fit$model)
        if (length(why) > 0) {
            reasons <- c(reasons, why)
            next
        }
        if (is_singular(kind, fit$model)) return(list(model = fit$model, singular = TRUE, said = fit$said))
        good <- c(good, list(fit))
    }
    if (length(good) == 0) return(list(why = paste(unique(reasons), collapse = "; ")))
    if (length(good) == 2 && !agree(kind, good[[1]]$model, good[[2]]$model))
        return(list(why = "two optimisers give different estimates"))
    said <- if (length(good) == 2) good[[1]]$said else c(paste("another optimiser:", reasons), good[[1]]$said)
    list(model = good[[1]]$model, singular = FALSE, said = said)
}

# Random parts, the fullest first: slopes of the systems where every participant, or item, has two answers and more to
# each of them (else they cannot be told from what is left over), then intercepts.
random_parts <- function(data) {
    repeated <- function(by) min(table(by, data$system)) >= 2
    by_item <- all(!is.na(data$item)) && length(unique(data$item)) > 1
    # A slope needs more levels than there are variances and covariances of it.
    many <- function(by) length(unique(by)) > 1 + nlevels(data$system) * (nlevels(data$system) + 1) / 2
    of_people <- c(if (repeated(data$participant) && many(data$participant)) "(1 + system | participant)",
                   "(1 | participant)")
    of_items <- if (by_item) c(if (repeated(data$item) && many(data$item)) "(1 + system | item)", "(1 | item)") else ""
    parts <- as.vector(outer(of_people, of_items, function(a, b) ifelse(b == "", a, paste(a, "+", b))))
    unique(c(parts, if (by_item) "(1 | participant)"))
}

# The fullest random part whose fit can be trusted and has no variance at its bound; else the simplest one at all.
# `fixed` is the formula's fixed part.
fullest_fit <- function(kind, fixed, data, parts) {
    passed <- character()
    last <- NULL
    for (part in parts) {
        fit <- trusted_fit(kind, as.formula(paste("value ~", fixed, "+", part)), data)
        fit$random <- part
        if (is.null(fit$model)) {
            passed <- c(passed, sprintf("%s: %s", part, fit$why))
        } else if (fit$singular) {
            passed <- c(passed, sprintf("%s: boundary (singular) fit", part))
            last <- fit
        } else {
            fit$note <- paste(c(passed, fit$said), collapse = "; ")
            return(fit)
        }
    }
    if (is.null(last)) return(list(note = paste("no model could be fitted:", paste(passed, collapse = "; ")), random = NA))
    last$note <- paste(passed, collapse = "; ")
    last
}

# Factors that cross with the systems: every system has answers under two levels and more.
crossing <- function(data) {
    known <- c("layout", "distance", setdiff(names(answers), c(labels, "order", "balls", "correct", "rating", "rt",
                                                                "synthetic", "marked", "value", "author_trial")))
    Filter(function(factor) {
        values <- data[[factor]]
        !is.null(values) && all(!is.na(values)) && length(unique(values)) > 1 && min(table(data$system, values)) >= 2
    }, known)
}

mixed_models <- data.frame()
mixed_interactions <- data.frame()
for (measure in unique(answers$measure[single])) {
    data <- answers[single & is("measure", measure) & !is.na(answers$value), ]
    systems <- unique(means$system[means$measure == measure])
    if (length(systems) < 2 || length(unique(data$value)) < 2 || length(unique(data$participant)) < 2) next
    data$system <- factor(data$system, levels = systems)
    binary <- all(!is.na(data$correct))
    steps <- length(unique(data$value))
    kind <- if (binary) "binary" else if (steps >= 3 && steps <= 12) "ordinal" else "linear"
    if (!binary && steps < 3 || !has(if (kind == "ordinal") "ordinal" else "lme4")) next
    name <- c(binary = "logistic GLMM", ordinal = "cumulative link mixed model", linear = "linear mixed model")[[kind]]
    if (kind == "ordinal") data$value <- factor(data$value, ordered = TRUE)
    parts <- random_parts(data)
    fit <- fullest_fit(kind, "system", data, parts)
    if (!is.null(fit$model)) {
        fit$slopes <- slopes_of(kind, fit$model)
        fit$covariance <- as.matrix(vcov(fit$model))
    }
    if (fit$note != "") cat(measure, ":", fit$note, "\n")
    mixed_models <- rbind(mixed_models, contrasts_of(measure, name, systems, fit))
    # Two fixed parts over the same random one, by the likelihood ratio.
    for (factor in if (is.null(fit$model)) character() else crossing(data)) {
        data$crossed <- factor(data[[factor]])
        fits <- lapply(c("system + crossed", "system * crossed"), function(fixed)
            trusted_fit(kind, as.formula(paste("value ~", fixed, "+", fit$random)), data))
        row <- data.frame(measure, model = name, interaction = paste0("system x ", factor), chi2 = NA_real_, df = NA_real_,
                          p = NA_real_, note = paste(unique(unlist(lapply(fits, function(one) one$why))), collapse = "; "),
                          random = fit$random)
        if (!is.null(fits[[1]]$model) && !is.null(fits[[2]]$model)) {
            fitted <- lapply(fits, function(one) if (kind == "linear") lme4::refitML(one$model) else one$model)
            row$chi2 <- max(0, 2 * (as.numeric(logLik(fitted[[2]])) - as.numeric(logLik(fitted[[1]]))))
            row$df <- attr(logLik(fitted[[2]]), "df") - attr(logLik(fitted[[1]]), "df")
            row$p <- pchisq(row$chi2, row$df, lower.tail = FALSE)
        }
        mixed_interactions <- rbind(mixed_interactions, row)
    }
}
if (nrow(mixed_models) > 0) write.csv(mixed_models, "mixed_models.csv", row.names = FALSE)
if (nrow(mixed_interactions) > 0) write.csv(mixed_interactions, "mixed_interactions.csv", row.names = FALSE)

# ---- verdict ---------------------------------------------------------------------------------------------

write.csv(compared, "comparison.csv", row.names = FALSE)
if (any(answers$synthetic == 1, na.rm = TRUE)) cat("Some answers are simulated: no evidence about people.\n")
wrong <- compared[compared$off > 1e-6, ]
cat(sprintf("%d numbers compared, the largest difference is %.2g; %d contrasts by mixed models\n", nrow(compared),
            max(compared$off, 0), nrow(mixed_models)))
cat("Not recomputed: bootstrap intervals (their draws are the program's own), questionnaires' scores\n")
if (nrow(wrong) > 0) {
    print(head(wrong, 20), row.names = FALSE)
    quit(status = 1)
}
