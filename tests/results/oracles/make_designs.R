# Makes designs.json: made-up ratings of systems that cross two factors and two groups, and R's tests of interactions
# (exactRankTests' wilcox.exact of the differences of differences, without zeros) and of equivalence (two one-sided
# wilcox.exact of the differences with the bound added and taken away).
#
#   Rscript tests/results/oracles/make_designs.R > tests/results/oracles/designs.json
#
# Needs r-cran-exactranktests and r-cran-jsonlite.
suppressMessages({library(exactRankTests); library(jsonlite)})
set.seed(1970)
people <- sprintf("P%02d", 1:16)
rows <- expand.grid(item = 1:3, layout = c("across", "beside"), system = c("slow smooth", "slow jerky", "fast smooth", "fast jerky"),
                    participant = people, stringsAsFactors = FALSE)
rows$speed <- sub(" .*", "", rows$system)
rows$path <- sub(".* ", "", rows$system)
rows$group <- ifelse(as.integer(factor(rows$participant)) %% 3 == 0, "expert", "novice")
crossed <- (rows$speed == "fast") == (rows$path == "jerky")
rows$rating <- pmin(7, pmax(1, round(4 + 0.9 * crossed + 0.3 * (rows$layout == "across") +
    0.8 * (rows$group == "expert" & rows$path == "smooth") + rnorm(16, 0, 0.7)[as.integer(factor(rows$participant))] +
    rnorm(nrow(rows), 0, 0.9))))
exact <- function(d, ...) { d <- round(d, 9); wilcox.exact(d[d != 0], exact = TRUE, ...)$p.value }
mean_of <- function(here) {  # the mean of the means under each system
  by_system <- tapply(rows$rating[here], list(rows$participant[here], rows$system[here]), mean)
  rowMeans(by_system, na.rm = TRUE)[people]
}
cell <- function(...) { here <- rep(TRUE, nrow(rows)); wanted <- list(...)
  for (name in names(wanted)) here <- here & rows[[name]] == wanted[[name]]; mean_of(here) }
out <- list()
d <- (cell(speed = "slow", path = "smooth") - cell(speed = "fast", path = "smooth")) -
     (cell(speed = "slow", path = "jerky") - cell(speed = "fast", path = "jerky"))
out$speed_path <- list(mean = mean(d), p = exact(d))
d <- (cell(system = "slow smooth", layout = "across") - cell(system = "slow jerky", layout = "across")) -
     (cell(system = "slow smooth", layout = "beside") - cell(system = "slow jerky", layout = "beside"))
out$system_layout <- list(mean = mean(d), p = exact(d))
d <- cell(path = "smooth") - cell(path = "jerky")
group <- tapply(rows$group, rows$participant, `[`, 1)[people]
a <- round(d[group == "expert"], 9); b <- round(d[group == "novice"], 9)
tails <- c(wilcox.exact(a, b, exact = TRUE, alternative = "greater")$p.value,
           wilcox.exact(a, b, exact = TRUE, alternative = "less")$p.value)
out$path_group <- list(mean_expert = mean(a), mean_novice = mean(b), p = min(1, 2 * min(tails)))
d <- cell(system = "slow jerky") - cell(system = "fast smooth")
out$equivalence <- list(bound = 0.75, p = max(exact(d + 0.75, alternative = "greater"), exact(d - 0.75, alternative = "less")))
csv <- capture.output(write.csv(rows[c("participant", "system", "layout", "speed", "path", "group", "item", "rating")],
                                row.names = FALSE, quote = FALSE))
cat(toJSON(list(made_by = paste("make_designs.R:", R.version.string, "exactRankTests", packageVersion("exactRankTests")),
                cases = list(c(list(csv = paste(csv, collapse = "\n")), out))), auto_unbox = TRUE, digits = NA))
cat("\n")
