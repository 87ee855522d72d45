// SPDX-License-Identifier: MIT
// Known answers are those of R 4.2.2, of a, b and c as below:
//   wilcox.test(x, y, paired = TRUE, exact = TRUE, conf.int = TRUE); wilcox.test(a, b[1:8], conf.int = TRUE)
//   mean(outer(x, y, ">") + outer(x, y, "==") / 2); p.adjust(p, "holm")
//   boot.ci(boot(data.frame(a, b), function(d, i) A12(d$a[i], d$b[i]), 20000), type = "bca", L = <by leaving one out>)
#include "analysis/comparison.h"

#include "analysis/comparison_picture.h"
#include "analysis/comparison_text.h"
#include "base/error.h"
#include "core/analysis/fake_setting.h"
#include "support/folder.h"

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <vector>

using namespace planula;
namespace tt = boost::test_tools;

namespace {

const std::vector<double> a{12.1, 14.5, 9.8, 11.3, 15.2, 13.7, 10.4, 12.9, 16.1, 8.7},
    b{10.13, 13.56, 9.12, 11.97, 12.24, 13.93, 8.41, 11.98, 13.17, 8.65},
    c{9.5, 13.2, 8.4, 11.1, 12.9, 13.35, 9.6, 10.2, 14.7, 7.75};

using Settings = std::vector<std::vector<double>>;

/// Recorded runs of settings called a, b, c …, whose best fitness is as stated: one run per value, seeds from 1.
class Recorded {
  public:
    explicit Recorded(const Settings &settings, std::uint64_t first_seed_of_last = 1) {
        specs_.reserve(settings.size());
        for (std::size_t i = 0; i < settings.size(); ++i) {
            const Spec &spec =
                specs_.emplace_back(fake_spec(std::string(1, static_cast<char>('a' + i)), 2, 3));
            std::uint64_t seed = i + 1 == settings.size() ? first_seed_of_last : 1;
            for (const double value : settings[i])
                write_fake_run(folder_.path(), spec, seed++, [&](int generation, int slot) {
                    return FakeLife{.fitness = generation + slot == 0 ? value : value / 2};
                });
            RunChoice choice = runs_in(folder_.path());
            choice.tell = [this](const std::string &line) { told.push_back(line); };
            contenders.push_back({spec.name, &spec, choice});
        }
    }
    std::filesystem::path folder() const { return folder_.path(); }

    std::vector<Contender> contenders;
    std::vector<std::string> told;

  private:
    TemporaryFolder folder_;
    std::vector<Spec> specs_;
};

const ComparisonPlan by_fitness{.measures = {measure_called("best_fitness")}};

void check_row(const ComparisonRow &row, double p, double difference, double low, double high,
               double effect) {
    BOOST_TEST_CONTEXT(row.a << " against " << row.b) {
        BOOST_TEST(row.p.value() == p, tt::tolerance(1e-11));
        BOOST_TEST(row.difference.value() == difference, tt::tolerance(1e-11));
        BOOST_TEST(row.difference_low.value() == low, tt::tolerance(1e-11));
        BOOST_TEST(row.difference_high.value() == high, tt::tolerance(1e-11));
        BOOST_TEST(row.a12.value() == effect, tt::tolerance(1e-11));
    }
}

} // namespace

BOOST_AUTO_TEST_CASE(settings_with_the_same_seeds_are_compared_in_pairs_as_in_r) {
    const Recorded runs(Settings{a, b, c});
    const Comparisons found = compare(runs.contenders, by_fitness);
    BOOST_TEST(found.generations == 2);
    BOOST_REQUIRE(found.rows.size() == 3u);
    check_row(found.rows[0], 0.01953125, 1.13, 0.135, 1.98, 0.65);
    check_row(found.rows[1], 0.001953125, 1.4, 0.8, 2, 0.675);
    check_row(found.rows[2], 0.556640625, 0.47, -0.45, 0.885, 0.53);
    BOOST_TEST(found.rows[0].p_holm.value() == 0.0390625);
    BOOST_TEST(found.rows[1].p_holm.value() == 0.005859375);
    BOOST_TEST(found.rows[2].p_holm.value() == 0.556640625);
    BOOST_TEST(std::abs(found.rows[0].a12_low.value() - 0.46) < 0.03);
    BOOST_TEST(std::abs(found.rows[0].a12_high.value() - 0.72) < 0.03);
    for (const ComparisonRow &row : found.rows) {
        BOOST_TEST(row.pairs == 10);
        BOOST_TEST(row.test == "signed-rank");
        BOOST_TEST(row.method == "exact");
        BOOST_TEST(row.note == "");
    }
    BOOST_TEST(found.rows[0].larger == 8);
    BOOST_TEST(found.rows[0].smaller == 2);
    BOOST_TEST(found.runs.size() == 30u);
    BOOST_REQUIRE(found.settings.size() == 3u);
    BOOST_TEST(found.settings[1].median.value() == 11.975, tt::tolerance(1e-12));
    BOOST_TEST(found.settings[1].low.value() < 11.975);
    BOOST_TEST(found.settings[1].high.value() > 11.975);
}

BOOST_AUTO_TEST_CASE(runs_of_other_seeds_or_unpaired_ones_are_independent_samples_as_in_r) {
    const std::vector<double> fewer(b.begin(), b.begin() + 8);
    for (const std::uint64_t seed : {101, 1}) {
        const Recorded runs(Settings{a, fewer}, seed);
        ComparisonPlan plan = by_fitness;
        plan.by_seed = seed != 1;
        const Comparisons found = compare(runs.contenders, plan);
        BOOST_REQUIRE(found.rows.size() == 1u);
        check_row(found.rows[0], 0.3599341834635952, 1.055, -1.57, 3.57, 0.6375);
        BOOST_TEST(found.rows[0].test == "rank-sum");
        BOOST_TEST(found.rows[0].pairs == 0);
        BOOST_TEST(found.rows[0].p_holm.value() == found.rows[0].p.value());
        BOOST_TEST(!found.rows[0].a12_low.has_value()); // of eight runs
    }
}

BOOST_AUTO_TEST_CASE(seeds_that_only_one_setting_has_are_left_out_or_make_no_pairs) {
    const std::vector<double> fewer(b.begin(), b.begin() + 7);
    const ComparisonRow nested = compare(Recorded(Settings{a, fewer}).contenders, by_fitness).rows.at(0);
    BOOST_TEST(nested.pairs == 7);
    BOOST_TEST(nested.note == "3 runs without a partner of the same seed left out");
    const ComparisonRow crossed = compare(Recorded(Settings{a, b}, 4).contenders, by_fitness).rows.at(0);
    BOOST_TEST(crossed.pairs == 0);
    BOOST_TEST(crossed.runs_a == 10);
    BOOST_TEST(crossed.note ==
               "7 pairs of the same seed among runs of other seeds: compared as independent samples; "
               "--seeds chooses those that are pairs");
}

BOOST_AUTO_TEST_CASE(too_few_runs_are_told_in_words_and_have_no_p) {
    const auto row_of = [](const Recorded &runs) { return compare(runs.contenders, by_fitness).rows.at(0); };
    const ComparisonRow five = row_of(Recorded(Settings{{1, 2, 3, 4, 5}, {2, 4, 6, 8, 10}}));
    BOOST_TEST(!five.p.has_value());
    BOOST_TEST(!five.p_holm.has_value());
    BOOST_TEST(five.note ==
               "5 pairs are too few for a test, whose p is never below 0.062; at least 6 pairs are needed");
    const ComparisonRow one = row_of(Recorded(Settings{{1}, {2}}));
    BOOST_TEST(one.note ==
               "1 pair is too few for a test, whose p is never below 1.00; at least 6 pairs are needed");
    const ComparisonRow three = row_of(Recorded(Settings{{1, 2, 3}, {4, 5, 6}}, 11));
    BOOST_TEST(three.note ==
               "3 runs against 3 are too few for a test, whose p is never below 0.10; at least 4 runs "
               "of each setting are needed");
    const ComparisonRow equal = row_of(Recorded(Settings{a, a}));
    BOOST_TEST(equal.note == "no pair differs, so that there is nothing to test");
    BOOST_TEST(row_of(Recorded(Settings{{1, 1, 1, 1, 1}, {1, 1, 1, 1, 2}}, 11)).note ==
               "so many values are equal that p is never below 1.00");
    std::vector<double> almost = a;
    almost[3] += 1;
    BOOST_TEST(row_of(Recorded(Settings{a, almost})).note ==
               "1 pair that differs is too few for a test, whose p is "
               "never below 1.00; at least 6 pairs are needed");
}

BOOST_AUTO_TEST_CASE(a_correction_that_so_few_runs_cannot_meet_is_told) {
    const auto first = [](const std::vector<double> &values) {
        return std::vector<double>(values.begin(), values.begin() + 6);
    };
    const Recorded two(Settings{first(a), first(b)}), three(Settings{first(a), first(b), first(c)});
    BOOST_TEST(compare(two.contenders, by_fitness).rows.at(0).note == "");
    BOOST_TEST(compare(three.contenders, by_fitness).rows.at(0).note ==
               "of so few runs the smallest of 3 p is never significant when corrected");
}

BOOST_AUTO_TEST_CASE(one_setting_may_be_the_one_that_all_are_compared_with) {
    const Recorded runs(Settings{a, b, c});
    ComparisonPlan plan = by_fitness;
    plan.against = "b";
    plan.measures.push_back(measure_called("side_switches"));
    const Comparisons found = compare(runs.contenders, plan);
    std::vector<std::string> compared;
    for (const ComparisonRow &row : found.rows) compared.push_back(row.measure + " " + row.a + row.b);
    BOOST_TEST(compared == std::vector<std::string>({"best_fitness ab", "best_fitness cb", "side_switches ab",
                                                     "side_switches cb"}),
               tt::per_element());
    // Those that cannot be tested do not count for the correction.
    BOOST_TEST(found.rows[0].p_holm.value() == 2 * 0.01953125);
}

BOOST_AUTO_TEST_CASE(runs_are_compared_after_the_generations_that_all_have_or_that_are_asked_for) {
    Recorded runs(Settings{a, b});
    const Spec longer = fake_spec("b", 4, 3);
    std::filesystem::remove_all(run_folder(runs.folder(), "b", 3));
    write_fake_run(runs.folder(), longer, 3, [](int, int slot) { return FakeLife{.fitness = slot + 1.0}; });
    BOOST_TEST(compare(runs.contenders, by_fitness).generations == 2);
    BOOST_REQUIRE(runs.told.size() == 1u);
    BOOST_TEST(runs.told[0].starts_with("compared after 2 generations, which all runs have; "));

    ComparisonPlan plan = by_fitness;
    plan.generations = 1;
    BOOST_TEST(compare(runs.contenders, plan).generations == 1);
    plan.generations = 3;
    BOOST_TEST(message_of<InputError>([&] { compare(runs.contenders, plan); }) ==
               "there is no run of a below " + runs.folder().string() +
                   " that has 3 generations; planula run makes runs");
}

BOOST_AUTO_TEST_CASE(the_sentence_has_every_number_that_a_paper_prints) {
    const Recorded runs(Settings{a, b, c}),
        others(Settings{a, std::vector<double>(b.begin(), b.begin() + 8)}, 101), equal(Settings{a, a}),
        few(Settings{{1, 2, 3}, {4, 5, 6}});
    const auto sentence = [](const Recorded &recorded) {
        const Comparisons found = compare(recorded.contenders, by_fitness);
        return sentence_of(found.rows.at(0), found, by_fitness);
    };
    const std::string paired = sentence(runs);
    BOOST_TEST(paired.starts_with(
                   "Over 10 paired seeds, a reached a median best fitness of 12.5 after 2 "
                   "generations, against 12.0 for b (larger in 8 of 10 pairs, Hodges–Lehmann "
                   "difference 1.1, 95 % interval 0.1 to 2.0; Wilcoxon signed-rank test, exact p = "
                   "0.020, Holm-corrected over 3 comparisons p = 0.039; A12 = 0.65, 95 % interval 0.4"),
               paired);
    BOOST_TEST(paired.ends_with(")."));
    BOOST_TEST(
        sentence(others) ==
        "Over 10 against 8 independent runs, a reached a median best fitness of 12.5 after 2 "
        "generations, against 12.0 for b (Hodges–Lehmann difference 1.1, 95 % interval −1.6 to 3.6; Wilcoxon "
        "rank-sum test, exact p = 0.36; A12 = 0.64).");
    BOOST_TEST(sentence(equal) ==
               "Over 10 paired seeds, a and b had the same best fitness in every pair after 2 "
               "generations (median 12.5).");
    BOOST_TEST(sentence(few) ==
               "Over 3 paired seeds, a reached a median best fitness of 2 after 2 "
               "generations, against 5 for b (larger in 0 of 3 pairs, Hodges–Lehmann difference "
               "−3; 3 pairs are too few for a test, whose p is never below 0.25; A12 = 0.00).");
}

BOOST_AUTO_TEST_CASE(p_values_are_rounded_to_two_digits_and_never_to_zero) {
    BOOST_TEST(p_text(1) == "p = 1");
    BOOST_TEST(p_text(0.123) == "p = 0.12");
    BOOST_TEST(p_text(0.0463) == "p = 0.046");
    BOOST_TEST(p_text(0.00012) == "p = 0.00012");
    BOOST_TEST(p_text(0.00009) == "p < 0.0001");
}

BOOST_AUTO_TEST_CASE(the_picture_has_a_circle_for_each_run_and_a_line_for_each_pair) {
    const Recorded runs(Settings{a, b}), others(Settings{a, b}, 101);
    const auto count = [](const std::string &text, const std::string &part) {
        int found = 0;
        for (std::size_t at = 0; (at = text.find(part, at)) != text.npos; at += part.size()) ++found;
        return found;
    };
    const Measure &measure = by_fitness.measures[0];
    const std::string pairs = svg_of(compare(runs.contenders, by_fitness), measure, false);
    BOOST_TEST(count(pairs, "<circle ") == 20);
    BOOST_TEST(count(pairs, "stroke=\"#8c8c8c\"") == 10);
    BOOST_TEST(count(pairs, "stroke-dasharray") == 8); // where it falls
    BOOST_TEST(count(pairs, "best fitness after 2 generations") == 1);
    BOOST_TEST(count(pairs, "exact: p = 0.020") == 1);
    const std::string samples = svg_of(compare(others.contenders, by_fitness), measure, true);
    BOOST_TEST(count(samples, "<circle ") == 20);
    BOOST_TEST(count(samples, "stroke=\"#8c8c8c\"") == 0);
    BOOST_TEST(count(samples, "logarithmic") == 1);
}

BOOST_AUTO_TEST_CASE(a_logarithmic_picture_needs_values_above_zero) {
    const Recorded runs(Settings{{0, 1}, {2, 3}});
    const Comparisons found = compare(runs.contenders, by_fitness);
    BOOST_TEST(message_of<InputError>([&] { svg_of(found, by_fitness.measures[0], true); }) ==
               "a logarithmic axis needs values above 0: a, seed 1, has 0");
    BOOST_TEST(svg_of(found, by_fitness.measures[0], false).ends_with("</svg>\n"));
}
