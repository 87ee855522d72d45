// SPDX-License-Identifier: MIT
#include "tables/columns.h"
#include "tables/csv.h"

#include <boost/test/unit_test.hpp>
#include <set>

using namespace planula;

BOOST_AUTO_TEST_CASE(every_column_is_explained_and_named_once_in_its_file) {
    std::set<std::pair<std::string, std::string>> seen;
    for (const ColumnRow &row : columns()) {
        BOOST_TEST(!row.file.empty());
        BOOST_TEST(!row.meaning.empty(), row.file << ' ' << row.column);
        BOOST_TEST(seen.insert({row.file, row.column}).second, row.file << ' ' << row.column);
    }
    BOOST_TEST(seen.size() > 150u);
}

BOOST_AUTO_TEST_CASE(headers_are_what_other_programs_expect) {
    BOOST_TEST(
        header_line<GenerationRow>() ==
        "generation,best_fitness,best_slot,best_x,best_y,mean_fitness,valid,fitness_low,fitness_median,"
        "fitness_high,moved,heading_x,heading_y,species,threshold,mean_links,mean_hidden,archive,"
        "archive_threshold,viable,died_out,too_small,overgrown,never_settled,exploded,overborn,"
        "shape_diversity,children,pairs,heredity_fitness,heredity_cells,kept_fitness,near_mother,"
        "cells_change,near_best,cyclic\n");
    BOOST_TEST(header_line<SizeRow>() == "generation,cells,individuals\n");
    BOOST_TEST(header_line<FitnessClassRow>() == "generation,percent,individuals\n");
    BOOST_TEST(header_line<ChainRow>() == "generation,content,link\n");
    BOOST_TEST(header_line<IdentityRow>() == "key,value,place,standard\n");
    BOOST_TEST(
        header_line<IndividualRow>() ==
        "generation,slot,genome,mother,father,origin,species,fitness,score,penalty,outcome,cells,births,"
        "finish_x,finish_y,rest_x,rest_y,activity,elongation,links,hidden\n");
    BOOST_TEST(header_line<ClaimRow>() ==
               "id,statement,section,paper,test,setting_a,setting_b,generation,at_generation,runs_a,runs_b,"
               "effect_name,effect,low,high,p,method,p_holm,p_equivalence,p_equivalence_holm,verdict,"
               "verdict_reached,decided_by,calibrated,note,note_reached\n");
    BOOST_TEST(header_line<CurveRow>() == "setting,generation,runs,mean,low,high\n");
    BOOST_TEST(header_line<LedgerRow>() == "section,name,value,standard,unit,origin,meaning\n");
}

BOOST_AUTO_TEST_CASE(a_row_is_visited_in_the_order_of_its_header) {
    const auto header = header_of<EndpointRow>();
    std::size_t column = 0;
    const EndpointRow row;
    each_column(row, [&](std::string_view name, const auto &) { BOOST_TEST(name == header.at(column++)); });
    BOOST_TEST(column == header.size());
}
