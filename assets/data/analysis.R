# Computes Deixis's analysis once more, in R, from the tables beside this file, and compares every number.
#
#   Rscript analysis.R           writes comparison.csv and mixed_models.csv; status 1 where a number is off
#
# Base R is enough for the tests; mixed models need the packages ordinal and lme4 and are left out without
# them. Conventions: Deixis's docs/statistics.md. Exact distributions are computed here by plain convolution,
# independently of the program.

options(stringsAsFactors = FALSE)
arguments <- commandArgs(FALSE)
script <- sub("^--file=", "", grep("^--file=", arguments, value = TRUE))
if (length(script) == 1) setwd(dirname(normalizePath(script)))

labels <- c("participant", "measure", "system", "other_system", "layout", "distance", "item", "factor", "level",
            "a", "b", "family", "method", "stage", "score", "name", "excluded")
table_of <- function(name) {
    file <- paste0(name, ".csv")
    if (!file.exists(file)) return(NULL)
    columns <- names(read.csv(file, nrows = 1, check.names = FALSE))
    classes <- ifelse(columns %in% labels, "character", NA)
    names(classes) <- columns
    found <- read.csv(file, check.names = FALSE, colClasses = classes, na.strings = "", encoding = "UTF-8")
    attr(found, "table") <- name
    found
}

settings <- table_of("settings")
setting <- function(name) as.numeric(settings$value[settings$name == name])
level <- setting("level")
answers <- table_of("answers")
answers <- answers[is.na(answers$excluded), ]  # the headline's: without who is left out
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

signed_rank <- function(exactly) {
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
    walsh <- sort(outer(exactly, exactly, "+")[lower.tri(diag(n), diag = TRUE)] / 2)
    out$hodges_lehmann <- median(walsh)
    k <- 1
    while (k < length(walsh) / 2 && psignrank(k, n) <= (1 - level) / 2) k <- k + 1
    out$hodges_lehmann_lower <- walsh[k]
    out$hodges_lehmann_upper <- walsh[length(walsh) + 1 - k]
    out$hodges_lehmann_level <- 1 - 2 * psignrank(k - 1, n)
    spread <- n >= 3 && length(unique(d)) > 1
    normality <- if (spread) shapiro.test(exactly) else NULL
    out$shapiro_w <- if (spread) normality$statistic else NA
    out$shapiro_p <- if (spread) normality$p.value else NA
    out
}

# Compares a table of signed-rank tests; differences(i): those of its row i.
compare_tests <- function(tests, differences) {
    found <- lapply(seq_len(nrow(tests)), function(i) signed_rank(differences(i)))
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
    for (r in doubled)
        for (k in seq(min(n_a, length(doubled)), 1))
            ways[k + 1, ] <- ways[k + 1, ] + c(numeric(r), head(ways[k, ], -r))
    share <- ways[n_a + 1, ] / sum(ways[n_a + 1, ])
    sums <- seq_along(share) - 1
    c(sum(share[sums <= 2 * w]), sum(share[sums >= 2 * w]))
}

rank_sum <- function(exactly_a, exactly_b) {
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
    shifts <- sort(outer(exactly_a, exactly_b, "-"))
    k <- 1
    while (k < length(shifts) / 2 && pwilcox(k, n_a, n_b) <= (1 - level) / 2) k <- k + 1
    out$hodges_lehmann <- median(shifts)
    out$hodges_lehmann_lower <- shifts[k]
    out$hodges_lehmann_upper <- shifts[length(shifts) + 1 - k]
    out$hodges_lehmann_level <- 1 - 2 * pwilcox(k - 1, n_a, n_b)
    out
}

# ---- tables ----------------------------------------------------------------------------------------------

means <- table_of("means")
for (i in seq_len(NROW(means))) {
    here <- single & is("measure", means$measure[i]) & is("system", means$system[i])
    by_participant <- means_of(here)
    same(means, i, "mean", mean(by_participant))
    same(means, i, "sd_participants", if (length(by_participant) > 1) sd(by_participant) else NA)
    same(means, i, "sd_trials", if (sum(here) > 1) sd(answers$value[here]) else NA)
    same(means, i, "participants", length(by_participant))
    same(means, i, "answers", sum(here))
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

omnibus <- table_of("omnibus")
for (i in seq_len(NROW(omnibus))) {
    systems <- unique(means$system[means$measure == omnibus$measure[i]])
    columns <- lapply(systems, function(s) means_of(single & is("measure", omnibus$measure[i]) & is("system", s)))
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

pairwise <- table_of("pairwise")
if (!is.null(pairwise)) {
    of_system <- function(measure, system) means_of(single & is("measure", measure) & is("system", system))
    differences <- function(i)
        paired(of_system(pairwise$measure[i], pairwise$a[i]), of_system(pairwise$measure[i], pairwise$b[i]))
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

# Compares a table of rank-sum tests; group(row, level): the scores of that level's participants.
compare_groups <- function(tests, group) {
    found <- lapply(seq_len(nrow(tests)), function(i) {
        row <- tests[i, ]
        rank_sum(group(row, row$a), group(row, row$b))
    })
    for (i in seq_along(found))
        for (column in names(found[[i]])) same(tests, i, column, found[[i]][[column]])
    for (family in unique(tests$family)) {
        rows <- which(tests$family == family)
        p <- p.adjust(sapply(found[rows], function(test) test$p), "holm")
        for (j in seq_along(rows)) same(tests, rows[j], "p_holm", p[j])
    }
}

between <- table_of("between")
if (!is.null(between)) {
    # Of each participant the mean, or the mean of the means under each system.
    compare_groups(between, function(row, level) {
        here <- single & is("measure", row$measure) & is(row$factor, level)
        if (row$system != "all") return(means_of(here & is("system", row$system)))
        by_system <- lapply(unique(answers$system[here]), function(s) means_of(here & is("system", s)))
        people <- unique(answers$participant[here])
        sapply(people, function(one) mean(unlist(lapply(by_system, function(column) column[one])), na.rm = TRUE))
    })
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

# Answers to a pair of systems, positive for a.
towards <- function(a, b) {
    forth <- is("system", a) & is("other_system", b)
    back <- is("system", b) & is("other_system", a)
    # A preference below 0 is for the first of the two.
    chosen <- answers[forth | back, ]
    chosen$value <- ifelse(back, answers$value, -answers$value)[forth | back]
    chosen
}
net_preferences <- function(chosen) vapply(split(chosen$value, chosen$participant), mean, numeric(1))

preferences <- table_of("preferences")
if (!is.null(preferences)) {
    compare_tests(preferences, function(i) net_preferences(towards(preferences$a[i], preferences$b[i])))
    for (i in seq_len(nrow(preferences))) {
        chosen <- towards(preferences$a[i], preferences$b[i])
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
for (i in seq_len(NROW(chance))) {
    here <- is("system", chance$system[i]) & !is.na(answers$correct)
    successes <- sum(answers$correct[here])
    same(chance, i, "successes", successes)
    same(chance, i, "n", sum(here))
    test <- binom.test(successes, sum(here), conf.level = level)
    same(chance, i, "estimate", test$estimate)
    same(chance, i, "lower", test$conf.int[1])
    same(chance, i, "upper", test$conf.int[2])
    if (!is.na(chance$p_chance[i]))
        same(chance, i, "p_chance", binom.test(successes, sum(here), setting("chance"))$p.value)
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

# Contrasts of all pairs of systems from a model's coefficients, Wald tests, Holm within the measure.
contrasts_of <- function(measure, model, coefficients, covariance, systems, note) {
    at <- function(system) paste0("system", system)
    rows <- data.frame()
    for (pair in combn(systems, 2, simplify = FALSE)) {
        weights <- setNames(numeric(length(coefficients)), names(coefficients))
        for (k in 1:2) if (at(pair[k]) %in% names(weights)) weights[at(pair[k])] <- c(1, -1)[k]
        estimate <- sum(weights * coefficients)
        se <- sqrt(as.numeric(weights %*% covariance[names(weights), names(weights), drop = FALSE] %*% weights))
        z <- estimate / se
        rows <- rbind(rows, data.frame(measure, model, a = pair[1], b = pair[2], estimate, se, z,
                                       p = 2 * pnorm(-abs(z))))
    }
    rows$p_holm <- p.adjust(rows$p, "holm")
    rows$note <- note
    rows
}

# A model, and what R says while it is fitted: printed, and kept beside the contrasts.
fitted_by <- function(measure, fit) {
    said <- character()
    hear <- function(condition, restart) {
        said <<- c(said, trimws(conditionMessage(condition)))
        invokeRestart(restart)
    }
    model <- tryCatch(withCallingHandlers(fit, message = function(m) hear(m, "muffleMessage"),
                                          warning = function(w) hear(w, "muffleWarning")),
                      error = function(e) { said <<- c(said, conditionMessage(e)); NULL })
    note <- paste(unique(said), collapse = "; ")
    if (note != "") cat(measure, ":", note, "\n")
    if (is.null(model)) NULL else list(model = model, note = note)
}

mixed_models <- data.frame()
for (measure in unique(answers$measure[single])) {
    data <- answers[single & is("measure", measure) & !is.na(answers$value), ]
    systems <- unique(means$system[means$measure == measure])
    if (length(systems) < 2 || length(unique(data$value)) < 2 || length(unique(data$participant)) < 2) next
    data$system <- factor(data$system, levels = systems)
    by_item <- sum(!is.na(data$item)) == nrow(data) && length(unique(data$item)) > 1
    terms <- as.formula(paste(c("value ~ system", "(1 | participant)", if (by_item) "(1 | item)"), collapse = " + "))
    binary <- all(!is.na(data$correct))
    steps <- length(unique(data$value))
    ordinal <- !binary && steps >= 3 && steps <= 12
    if (!binary && steps < 3 || !has(if (ordinal) "ordinal" else "lme4")) next
    name <- if (binary) "logistic GLMM" else if (ordinal) "cumulative link mixed model" else "linear mixed model"
    if (ordinal) data$value <- factor(data$value, ordered = TRUE)
    fit <- fitted_by(measure, {
        model <- if (binary) lme4::glmer(terms, data, family = binomial)
                 else if (ordinal) ordinal::clmm(terms, data = data)
                 else lme4::lmer(terms, data)
        list(slopes = if (ordinal) model$beta else lme4::fixef(model), covariance = as.matrix(vcov(model)))
    })
    if (is.null(fit)) next
    mixed_models <- rbind(mixed_models, contrasts_of(measure, name, fit$model$slopes, fit$model$covariance, systems,
                                                     fit$note))
}
if (nrow(mixed_models) > 0) write.csv(mixed_models, "mixed_models.csv", row.names = FALSE)

# ---- verdict ---------------------------------------------------------------------------------------------

write.csv(compared, "comparison.csv", row.names = FALSE)
if (any(answers$synthetic == 1, na.rm = TRUE)) cat("Some answers are simulated: no evidence about people.\n")
wrong <- compared[compared$off > 1e-6, ]
cat(sprintf("%d numbers compared, the largest difference is %.2g; %d contrasts by mixed models\n", nrow(compared),
            max(compared$off, 0), nrow(mixed_models)))
cat("Not computed anew: bootstrap intervals (their draws are the program's own), questionnaires' scores\n")
if (nrow(wrong) > 0) {
    print(head(wrong, 20), row.names = FALSE)
    quit(status = 1)
}
