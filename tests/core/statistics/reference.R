# SPDX-License-Identifier: MIT
# Makes the known answers of the tests of this folder: Rscript reference.R > reference.inc, in R 4.2.2 with boot 1.3-28
# and coin 1.4-2. Each line is a function, a case, two samples and what R says.
options(warn = 2)
text <- function(v) paste0("{", paste(sprintf("%.17g", v), collapse = ", "), "}")
reference <- function(f, case, a, b, expected)
    cat(sprintf('{"%s", "%s", %s, %s, %s},\n', f, case, text(a), text(b), text(expected)))
cat("// SPDX-License-Identifier: MIT\n// Written by reference.R.\n")

x <- c(12.1, 14.5, 9.8, 11.3, 15.2, 13.7, 10.4, 12.9, 16.1, 8.7, 14, 12.2, 11.8, 13.1, 9.9, 15.8, 12.5, 10.9, 13.4, 11.1)
y <- c(10.13, 13.56, 9.12, 11.97, 12.24, 13.93, 8.41, 11.98, 13.17, 8.65, 11.02, 12.96, 10.81, 12.14, 9.35, 13.88,
       12.69, 9.93, 11.49, 10.16) + (1:20) / 977
tied_x <- c(5, 3, 8, 8, 2, 9, 7, 4, 6, 6, 1, 9); tied_y <- c(3, 3, 6, 9, 2, 5, 8, 1, 4, 9, 0, 3)
many_x <- ((1:60) * 37) %% 101 + (1:60) / 97; many_y <- ((1:60) * 53) %% 103 + (1:60) / 89

# Where R is not asked for an exact answer it still warns of ties and zeros.
quiet <- function(exact, value) if (exact) value else suppressWarnings(value)

# ---- Signed rank: V, two-sided, greater, less ----
sides <- function(p) c(p("two.sided"), p("greater"), p("less"))
signed <- function(a, b, exact, correct = TRUE) quiet(exact, c(
    wilcox.test(a, b, paired = TRUE, exact = exact, correct = correct)$statistic,
    sides(function(side) wilcox.test(a, b, paired = TRUE, exact = exact, correct = correct, alternative = side)$p.value)))
# Every choice of signs, with ties and without zeros.
counted <- function(a, b) {
    d <- (a - b)[a != b]; r <- rank(abs(d)); V <- sum(r[d > 0])
    all <- as.matrix(expand.grid(rep(list(0:1), length(d)))) %*% r
    c(V, mean(abs(all - mean(all)) >= abs(V - mean(all))), mean(all >= V), mean(all <= V))
}
coin_p <- function(a, b, side) as.numeric(coin::pvalue(coin::wilcoxsign_test(a ~ b, distribution = "exact",
                                                       zero.method = "Wilcoxon", alternative = side)))
stopifnot(all.equal(counted(tied_x, tied_y)[-1], sides(function(side) coin_p(tied_x, tied_y, side))),
          all.equal(counted(x[1:9], y[1:9]), unname(signed(x[1:9], y[1:9], TRUE))))
reference("signed_rank", "automatic", x, y, signed(x, y, TRUE))
reference("signed_rank", "automatic", x[1:5], y[1:5], signed(x[1:5], y[1:5], TRUE))
reference("signed_rank", "automatic", tied_x, tied_y, counted(tied_x, tied_y))
reference("signed_rank", "automatic", many_x, many_y, signed(many_x, many_y, FALSE))
for (method in c("normal", "normal_without_continuity")) {
    correct <- method == "normal"
    reference("signed_rank", method, x, y, signed(x, y, FALSE, correct))
    reference("signed_rank", method, tied_x, tied_y, signed(tied_x, tied_y, FALSE, correct))
    reference("signed_rank", method, many_y, many_x, signed(many_y, many_x, FALSE, correct))
}
reference("signed_rank", "exact", many_x, many_y, signed(many_x, many_y, TRUE))

# ---- Rank sum: W, p ----
summed <- function(a, b, correct) { t <- wilcox.test(a, b, exact = FALSE, correct = correct); c(t$statistic, t$p.value) }
for (method in c("normal", "normal_without_continuity")) {
    correct <- method == "normal"
    reference("rank_sum", method, x, y, summed(x, y, correct))
    reference("rank_sum", method, tied_x, tied_y[1:9], summed(tied_x, tied_y[1:9], correct))
    reference("rank_sum", method, many_x, y * 5, summed(many_x, y * 5, correct))
}
reference("rank_sum", "automatic", many_x, many_y, summed(many_x, many_y, TRUE))

# ---- Shift: confidence, estimate, low, high ----
shifted <- function(a, b, confidence, paired) {
    t <- wilcox.test(a, b, paired = paired, exact = TRUE, conf.int = TRUE, conf.level = confidence)
    c(confidence, t$estimate, t$conf.int)
}
for (confidence in c(0.5, 0.95, 0.99)) {
    reference("shift", "samples", x, y[1:14], shifted(x, y[1:14], confidence, FALSE))
    reference("shift", "pairs", x, y, shifted(x, y, confidence, TRUE))
}
reference("shift", "samples", x[1:4], y[1:4] + 3, shifted(x[1:4], y[1:4] + 3, 0.95, FALSE))
reference("shift", "pairs", x[1:6], y[1:6], shifted(x[1:6], y[1:6], 0.95, TRUE))
reference("shift", "samples", many_x, many_y, shifted(many_x, many_y, 0.95, FALSE))
reference("shift", "pairs", many_x, many_y, shifted(many_x, many_y, 0.95, TRUE))

# ---- Effect sizes: Cliff's delta ----
reference("cliff_delta", "", x, y, mean(sign(outer(x, y, "-"))))
reference("cliff_delta", "", tied_x, tied_y[1:9], mean(sign(outer(tied_x, tied_y[1:9], "-"))))

# ---- Spearman: rho, p, whether exact ----
spearman <- function(a, b, exact) { t <- suppressWarnings(cor.test(a, b, method = "spearman", exact = exact)); c(t$estimate, t$p.value, exact) }
permutations <- function(v) if (length(v) <= 1) list(v) else
    do.call(c, lapply(seq_along(v), function(i) lapply(permutations(v[-i]), function(rest) c(v[i], rest))))
every_order <- function(a, b) {
    rho <- cor(a, b, method = "spearman"); a <- rank(a)
    all <- sapply(permutations(rank(b)), function(o) sum((a - mean(a)) * o))
    c(rho, mean(abs(all) >= abs(sum((a - mean(a)) * rank(b))) - 1e-9), TRUE)
}
stopifnot(all.equal(every_order(x[1:6], y[1:6]), unname(spearman(x[1:6], y[1:6], TRUE))))
reference("rank_correlation", "", x[1:9], y[c(4, 2, 1, 3, 6, 5, 9, 8, 7)], spearman(x[1:9], y[c(4, 2, 1, 3, 6, 5, 9, 8, 7)], TRUE))
reference("rank_correlation", "", x[1:7], -y[1:7], spearman(x[1:7], -y[1:7], TRUE))
reference("rank_correlation", "", tied_x[1:7], tied_y[1:7], every_order(tied_x[1:7], tied_y[1:7]))
reference("rank_correlation", "", x, y, spearman(x, y, FALSE))
reference("rank_correlation", "", tied_x, tied_y, spearman(tied_x, tied_y, FALSE))
reference("rank_correlation", "", many_x, many_y, spearman(many_x, many_y, FALSE))

# ---- Corrections ----
p <- c(0.01, 0.04, 0.03, 0.005, 0.5, 0.03, 0.97, 1e-9)
reference("benjamini_hochberg", "", p, c(0), p.adjust(p, "BH"))
reference("benjamini_hochberg", "", rev(p)[1:3], c(0), p.adjust(rev(p)[1:3], "BH"))

# ---- Paired permutation: mean difference, p ----
flipped <- function(a, b) {
    d <- a - b; all <- as.matrix(expand.grid(rep(list(c(-1, 1)), length(d)))) %*% d
    c(mean(d), mean(abs(all) >= abs(sum(d)) - 1e-9))
}
reference("paired_permutation", "exact", x[1:11], y[1:11], flipped(x[1:11], y[1:11]))
reference("paired_permutation", "exact", tied_x, tied_y, flipped(tied_x, tied_y))
reference("paired_permutation", "drawn", x[1:16], y[16:1], flipped(x[1:16], y[16:1]))

# ---- Paired equivalence: bound, p ----
equivalent <- function(a, b, bound) c(bound, max(wilcox.test(a - b, mu = -bound, exact = TRUE, alternative = "greater")$p.value,
                                                 wilcox.test(a - b, mu = bound, exact = TRUE, alternative = "less")$p.value))
reference("paired_equivalence", "", x, y, equivalent(x, y, 1.3077))
reference("paired_equivalence", "", x, y, equivalent(x, y, 2.5013))

# ---- Distributions: quantiles of the normal one; two-sided p of Student's t with 1, 2, 7, 58 and 998 degrees ----
p <- c(1e-12, 0.0005, 0.025, 0.2, 0.5, 0.8, 0.975, 0.9995)
reference("normal_quantile", "", p, c(0), qnorm(p))
t <- c(0.01, 0.3, 1, 1.3, 1.5, 2.2, 4, 9, 40)
for (freedom in c(1, 2, 7, 58, 998)) reference("student", "", t, freedom, 2 * pt(-t, freedom))

# ---- BCa: a: replicates, b: influences; confidence, estimate, low, high ----
set.seed(1)
bca <- function(sample, statistic, replicates, confidence) {
    made <- boot::boot(sample, function(v, i) statistic(v[i]), replicates)
    without <- sapply(seq_along(sample), function(i) statistic(sample[-i])); influence <- mean(without) - without
    found <- boot::boot.ci(made, conf = confidence, type = "bca", L = influence)$bca
    reference("bca", "", made$t, influence, c(confidence, made$t0, found[4:5]))
}
skewed <- exp(x / 3)
bca(x, mean, 199, 0.9)
bca(skewed, mean, 399, 0.95)
bca(skewed, median, 299, 0.8)
bca(skewed, sd, 399, 0.9)
