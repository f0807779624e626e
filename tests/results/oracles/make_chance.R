# Makes chance.json: made-up choices among two, three and five balls, and R's tests of participants' means of
# correct - 1 / balls against 0 (exactRankTests' wilcox.exact of the means without zeros, p.adjust).
#
#   Rscript tests/results/oracles/make_chance.R > tests/results/oracles/chance.json
#
# Needs r-cran-exactranktests and r-cran-jsonlite.
suppressMessages({library(exactRankTests); library(jsonlite)})
set.seed(23)
rows <- expand.grid(trial = 1:7, system = c("guess", "near", "seen"), participant = sprintf("P%02d", 1:14),
                    stringsAsFactors = FALSE)
rows$balls <- c(2, 3, 5)[1 + (rows$trial + as.integer(factor(rows$participant))) %% 3]
lift <- c(guess = 0, near = 0.12, seen = 0.45)[rows$system]
rows$correct <- as.integer(runif(nrow(rows)) < 1 / rows$balls + lift)
rows$balls[rows$participant == "P03" & rows$trial == 4] <- NA  # not known
found <- lapply(unique(rows$system), function(system) {
  here <- rows[rows$system == system & !is.na(rows$balls), ]
  # In sixtieths and sevenths, so that equal means are equal: 420 times the mean of up to seven.
  above <- vapply(split(here$correct - 1 / here$balls, here$participant), mean, numeric(1))
  above <- round(above, 9)
  nonzero <- above[above != 0]
  list(system = system, successes = sum(rows$correct[rows$system == system]), choices = sum(rows$system == system),
       choices_with_balls = nrow(here), mean_above = mean(above),
       chance = mean(vapply(split(1 / here$balls, here$participant), mean, numeric(1))), n = length(above),
       p = wilcox.exact(nonzero, exact = TRUE)$p.value)
})
holm <- p.adjust(vapply(found, function(one) one$p, numeric(1)), "holm")
for (i in seq_along(found)) found[[i]]$p_holm <- holm[i]
csv <- capture.output(write.csv(rows[c("participant", "system", "trial", "balls", "correct")], row.names = FALSE,
                                quote = FALSE, na = ""))
cat(toJSON(list(made_by = paste("make_chance.R:", R.version.string, "exactRankTests", packageVersion("exactRankTests")),
                cases = list(list(csv = paste(csv, collapse = "\n"), systems = found))), auto_unbox = TRUE, digits = NA))
cat("\n")
