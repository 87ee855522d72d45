// SPDX-License-Identifier: MIT
// Everything that `stats` holds, once. Read with these macros defined:
//
//   STATISTIC(name, signature, least, most, function, meaning)   least, most: the number of arguments
//   STATISTIC_NUMBER(name, meaning)
//
// a, b: lists of finite numbers, at least one. Options are a last argument, a table.

STATISTIC(rank_sum, "(a, b, {method = \"exact\" or \"normal\", continuity = false})", 2, 3, call_rank_sum,
          "the two-sided rank-sum test of two independent samples, R's wilcox.test: {statistic, p, least, method}; exact below 50 values, with ties as well; least: the smallest p that so many values can give")
STATISTIC(signed_rank, "(a, b, {method = \"exact\" or \"normal\", continuity = false})", 2, 3, call_signed_rank,
          "the signed-rank test of pairs, a[i] with b[i], R's wilcox.test(paired = TRUE): {statistic, p, greater, less, least, differences, method}")
STATISTIC(permutation, "(a, b, {paired = true, draws = n, name = \"…\"})", 2, 3, call_permutation,
          "the two-sided permutation test of the difference of means: {difference, p, least, method}; exact if there are at most `draws` ways to share the values out, else that many are drawn")
STATISTIC(equivalence, "(a, b, bound)", 3, 3, call_equivalence,
          "two one-sided tests that A12 lies within 1/2 ± bound: {effect, deviation, p, least}; p is small if it does")
STATISTIC(bootstrap, "(a, b, statistic, {confidence = c, resamples = n, method = \"percentile\" or \"bca\", paired = true, name = \"…\"})", 2, 4, call_bootstrap,
          "the bootstrap interval {low, high} of statistic(a, b), or, called as stats.bootstrap(a, statistic, options), of statistic(a); the statistic is a function of lists that returns a number, such as stats.a12")
STATISTIC(a12, "(a, b)", 2, 2, call_effect<a12>,
          "the probability that a value of a exceeds one of b, ties counting half (Vargha & Delaney 2000)")
STATISTIC(cliff_delta, "(a, b)", 2, 2, call_effect<cliff_delta>, "Cliff's delta (1993): 2 A12 - 1")
STATISTIC(spearman, "(a, b)", 2, 2, call_spearman,
          "Spearman's rank correlation of pairs: {rho, p, method}; nil if all values of a or of b are equal")
STATISTIC(share_ahead, "(a, b)", 2, 2, call_share_ahead,
          "the share of places at which the mean of the curves of a is at least that of b; a, b: lists of curves, which are lists of one length")
STATISTIC(holm, "(p)", 1, 1, call_correction<holm>, "a list of p-values, corrected after Holm (1979), R's p.adjust")
STATISTIC(benjamini_hochberg, "(p)", 1, 1, call_correction<benjamini_hochberg>,
          "a list of p-values, corrected after Benjamini & Hochberg (1995), R's p.adjust(method = \"BH\")")
STATISTIC(mean, "(a)", 1, 1, call_summary<mean>, "the mean")
STATISTIC(median, "(a)", 1, 1, call_summary<median>, "the median")
STATISTIC(quantile, "(a, probability)", 2, 2, call_quantile, "the quantile of type 7, R's default")
STATISTIC(entropy, "(counts)", 1, 1, call_entropy, "the entropy of a list of counts, in nats (Eq. 8)")
STATISTIC(hypergeometric, "(marked, total, all_marked, drawn)", 4, 4, call_hypergeometric,
          "the probability of at least so many marked ones among those drawn; of a table of two by two, the one-sided p of Fisher's exact test")
STATISTIC(binomial, "(found, count, probability)", 3, 3, call_binomial,
          "the probability of at most so many successes in `count` trials")
STATISTIC(present, "(list)", 1, 1, call_present, "the list without the values that are missing, which are false")

STATISTIC_NUMBER(significance, "of the experiment's statistics: p-values below it decide")
STATISTIC_NUMBER(confidence, "of the experiment's statistics: the coverage of intervals")
STATISTIC_NUMBER(resamples, "of the experiment's statistics: of an interval, and draws of a permutation test")
STATISTIC_NUMBER(interval_runs, "of the experiment's statistics: of fewer runs there should be no interval")

#undef STATISTIC
#undef STATISTIC_NUMBER
