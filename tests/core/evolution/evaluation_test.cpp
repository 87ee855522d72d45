// SPDX-License-Identifier: MIT
#include "evolution/evaluation.h"

#include "base/error.h"

#include <boost/test/unit_test.hpp>

#include <limits>
#include <string_view>

using namespace planula;

namespace {

Evaluation load(std::string_view bytes) {
    StateReader reader(bytes);
    const Evaluation evaluation = load_evaluation(reader);
    reader.done();
    return evaluation;
}

} // namespace

BOOST_AUTO_TEST_CASE(behaviours_must_exist_be_finite_and_have_one_length) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const auto refused = [](const std::vector<Evaluation> &evaluations, std::size_t length = 0) {
        BOOST_CHECK_THROW(check_behaviours(evaluations, length), InputError);
    };
    refused({{1, {}, 1}});
    refused({{1, {1, nan}, 1}});
    refused({{1, {1}, 1}, {1, {1, 2}, 1}});
    refused({{1, {1}, 1}}, 2);
    std::size_t length = 0;
    check_behaviours(std::vector<Evaluation>{{1, {nan}, 0}, {1, {1, 2}, 0.5}},
                     length); // invalid ones are not looked at
    BOOST_TEST(length == 2u);
}

BOOST_AUTO_TEST_CASE(a_saved_evaluation_reads_back_equal_and_is_refused_if_cut_short) {
    const Evaluation evaluation{12.5, {-1, 0.1}, 0.1};
    StateWriter writer;
    save(evaluation, writer);
    BOOST_TEST((load(writer.bytes()) == evaluation));
    for (std::size_t length = 0; length < writer.bytes().size(); ++length)
        BOOST_CHECK_THROW(load(std::string_view(writer.bytes()).substr(0, length)), InputError);
}

BOOST_AUTO_TEST_CASE(an_evaluation_that_cannot_be_is_refused) {
    const double infinity = std::numeric_limits<double>::infinity();
    for (const Evaluation &evaluation :
         {Evaluation{-1, {}, 1}, Evaluation{infinity, {}, 1}, Evaluation{1, {}, 1.5}, Evaluation{1, {}, -0.5},
          Evaluation{1, {infinity}, 1}}) {
        StateWriter writer;
        save(evaluation, writer);
        BOOST_CHECK_THROW(load(writer.bytes()), InputError);
    }
}
