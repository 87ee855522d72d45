// SPDX-License-Identifier: MIT
#include "statement/keys.h"

#include "base/error.h"
#include "parameters/parameters.h"
#include "statement/schema.h"
#include "support/scripts.h"

#include <algorithm>
#include <set>
#include <string>

#include <boost/test/unit_test.hpp>

namespace {

using namespace planula;

/// The errors of a script that returns a complete setting, `where` filled in.
std::string errors_of(const std::string &of_experiment, const std::string &of_environment = "",
                      const std::string &of_parameters = "") {
    const std::string script = "local paper = require 'paper'\n"
                               "return paper.experiment {\n"
                               "  name = 'x', " +
                               of_experiment + "\n  environment = { actuation_range = 0.4, " +
                               of_environment + " },\n  parameters = { " + of_parameters + " },\n}\n";
    try {
        load_experiment(
            std::make_shared<Sources>("test.lua", script, std::string(PLANULA_SOURCE_DIR) + "/experiments"));
    } catch (const InputError &error) {
        return error.what();
    }
    return "";
}

BOOST_AUTO_TEST_CASE(every_row_says_what_its_key_means) {
    for (const KeyTable &table : key_tables()) {
        BOOST_TEST_CONTEXT(table.path) {
            std::set<std::string_view> names;
            for (const Key &key : table.keys) {
                BOOST_TEST_CONTEXT(key.name) {
                    BOOST_TEST(names.insert(key.name).second);
                    for (const std::string_view text : {key.kind, key.standard, key.origin, key.meaning})
                        BOOST_TEST(!text.empty());
                    BOOST_TEST(!key.meaning.ends_with('.'));
                    if (!key.example.empty())
                        BOOST_TEST(key.example.starts_with(std::string(key.name) + " = "));
                }
            }
        }
    }
}

BOOST_AUTO_TEST_CASE(tables_stand_where_their_keys_say) {
    for (const KeyTable &table : key_tables()) {
        const std::size_t dot = table.path.rfind('.');
        if (dot == table.path.npos) continue;
        std::string_view last = table.path.substr(dot + 1);
        if (last.ends_with("[]")) last.remove_suffix(2);
        BOOST_TEST(keys_of(table.path.substr(0, dot)).find(last), table.path);
    }
}

BOOST_AUTO_TEST_CASE(a_key_of_another_table_says_where_it_belongs) {
    BOOST_TEST(test::contains(errors_of("drag = { normal = 1, tangential = 1 },"),
                              "test.lua:3: the experiment has no 'drag'; write: environment = { drag = … }"));
    BOOST_TEST(test::contains(errors_of("normal = 2,"), "write: environment = { drag = { normal = 2 } }"));
    BOOST_TEST(test::contains(errors_of("", "search = 'neat'"),
                              "environment has no 'search'; write in the setting: search = \"neat\""));
    BOOST_TEST(test::contains(errors_of("", "", "search = 'neat'"),
                              "no parameter is called 'search'; write in the setting: search = \"neat\""));
}

BOOST_AUTO_TEST_CASE(a_parameter_in_another_table_says_where_it_belongs) {
    BOOST_TEST(test::contains(errors_of("population = 40,"),
                              "the experiment has no 'population'; write: parameters = { population = 40 }"));
    BOOST_TEST(
        test::contains(errors_of("", "population = 40"),
                       "environment has no 'population'; write in the setting: parameters = { population"));
    // Both a key of the environment and a parameter.
    BOOST_TEST(test::contains(errors_of("gravity = 3,"),
                              "write: environment = { gravity = 3 }, or: parameters = { gravity = 3 }"));
    BOOST_TEST(errors_of("", "gravity = 3, ground = 'flat'", "gravity = 3") == "");
}

BOOST_AUTO_TEST_CASE(a_key_of_a_setting_beside_settings_says_so) {
    const Value number{.kind = Value::Kind::number, .number = 30};
    BOOST_TEST(where_it_belongs("engine", number, keys_of("experiment")) ==
               "write in the setting: engine = 30");
    BOOST_TEST(where_it_belongs("sensitivity", number, keys_of("setting")) ==
               "write in the experiment: sensitivity = 30");
    BOOST_TEST(where_it_belongs("population", number, keys_of("experiment")) ==
               "write: parameters = { population = 30 }");
    BOOST_TEST(where_it_belongs("nothing", number, keys_of("setting")) == "");
}

} // namespace
