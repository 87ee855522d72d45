// SPDX-License-Identifier: MIT
// The main() of every test executable.
#define BOOST_TEST_MODULE planula
#include <boost/test/unit_test.hpp>
