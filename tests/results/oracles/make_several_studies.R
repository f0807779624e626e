# Makes several_studies.json: made-up ratings of four systems by other people in each of two studies, and R's tests of all
# pairs within each study, pooled and between the studies (exactRankTests' wilcox.exact, Holm by p.adjust), medians and
# the interaction of study and system.
#
#   Rscript tests/results/oracles/make_several_studies.R > tests/results/oracles/several_studies.json
#
# Needs r-cran-exactranktests and r-cran-jsonlite.
suppressMessages({library(exactRankTests); library(jsonlite)})
set.seed(2021)
systems <- c("REF", "AUTO", "SGT", "MANUAL")
study <- function(people, pages, shifts) {
    rows <- expand.grid(item = sprintf("S%d", 1:pages), system = systems, participant = sprintf("P%02d", 1:people),
                        stringsAsFactors = FALSE)
    own <- rnorm(people, 0, 8)
    rows$rating <- pmin(100, pmax(0, round(50 + shifts[match(rows$system, systems)] +
        own[as.integer(factor(rows$participant))] + rnorm(nrow(rows), 0, 9))))
    rows[sample(nrow(rows), round(0.95 * nrow(rows))), ]  # some answers are missing
}
studies <- list(relaxed = study(14, 5, c(6, -4, 5, 4)), rushed = study(10, 4, c(6, 3, 4, -9)))
means_of <- function(rows, system) {
    here <- rows$system == system
    tapply(rows$rating[here], rows$participant[here], mean)
}
signed_rank <- function(d) { d <- round(d, 9); wilcox.exact(d[d != 0], exact = TRUE)$p.value }
rank_sum <- function(a, b) {
    a <- round(a, 9); b <- round(b, 9)
    min(1, 2 * min(wilcox.exact(a, b, exact = TRUE, alternative = "greater")$p.value,
                   wilcox.exact(a, b, exact = TRUE, alternative = "less")$p.value))
}
pairs <- combn(systems, 2, simplify = FALSE)
pair_tests <- function(rows) {
    found <- lapply(pairs, function(pair) {
        a <- means_of(rows, pair[1]); b <- means_of(rows, pair[2])
        both <- intersect(names(a), names(b))
        list(a = pair[1], b = pair[2], n = length(both), mean = mean(a[both] - b[both]), p = signed_rank(a[both] - b[both]))
    })
    adjusted <- p.adjust(sapply(found, `[[`, "p"), "holm")
    Map(function(one, p_holm) c(one, p_holm = p_holm), found, adjusted)
}
medians <- function(rows) setNames(lapply(systems, function(s) list(
    median = median(means_of(rows, s)), ratings = median(rows$rating[rows$system == s]))), systems)
pooled <- do.call(rbind, lapply(names(studies), function(name)
    transform(studies[[name]], participant = paste(name, participant))))
between <- lapply(systems, function(s) rank_sum(means_of(studies$relaxed, s), means_of(studies$rushed, s)))
interaction <- lapply(pairs, function(pair) {
    d <- lapply(studies, function(rows) { a <- means_of(rows, pair[1]); b <- means_of(rows, pair[2])
        both <- intersect(names(a), names(b)); a[both] - b[both] })
    rank_sum(d$relaxed, d$rushed)
})
csv <- lapply(studies, function(rows) paste(capture.output(write.csv(rows[c("participant", "system", "item", "rating")],
    row.names = FALSE, quote = FALSE)), collapse = "\n"))
cat(toJSON(list(made_by = paste("make_several_studies.R:", R.version.string, "exactRankTests", packageVersion("exactRankTests")),
    cases = list(list(csv = csv, relaxed = pair_tests(studies$relaxed), rushed = pair_tests(studies$rushed),
        pooled = pair_tests(pooled), medians = list(relaxed = medians(studies$relaxed), rushed = medians(studies$rushed),
        pooled = medians(pooled)), between = setNames(between, systems), interaction = interaction))),
    auto_unbox = TRUE, digits = NA))
cat("\n")
