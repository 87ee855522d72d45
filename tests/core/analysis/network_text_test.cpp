// SPDX-License-Identifier: MIT
#include "analysis/network_text.h"

#include "analysis/network_picture.h"
#include "cell/channels.h"
#include "support/specimens.h"

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <set>
#include <string>
#include <vector>

using namespace planula;

namespace {

/// An animat's genome with a hidden node, a loop, and a link back from it.
Genome sample(Actuation actuation) {
    Genome genome = specimens::bare_genome(actuation);
    genome.id = 42, genome.mother = 17, genome.father = 9, genome.origin = Origin::crossover_mutation;
    const int hidden = genome.nodes.back().id + 1;
    genome.nodes.push_back({hidden, NodeKind::hidden, 0.5});
    specimens::add_link(genome, input::maternal_east, hidden, -1.5);
    specimens::add_link(genome, hidden, genome.inputs + output::apoptosis, 0.25);
    specimens::add_link(genome, input::bias, genome.inputs + output::apoptosis, 2);
    specimens::add_link(genome, hidden, hidden, 0.75);
    genome.links.back().recurrent = true;
    specimens::add_link(genome, genome.inputs, hidden, 1);
    genome.links.back().recurrent = true;
    return genome;
}

bool contains(const std::string &text, const std::string &part) { return text.find(part) != text.npos; }

std::size_t count(const std::string &text, const std::string &part) {
    std::size_t found = 0;
    for (std::size_t at = text.find(part); at != text.npos; at = text.find(part, at + 1)) ++found;
    return found;
}

} // namespace

BOOST_AUTO_TEST_CASE(nodes_have_the_names_of_the_channels) {
    const Genome oscillator = sample(Actuation::oscillator), grn = sample(Actuation::grn);
    const auto name = [](const Genome &genome, int id) { return name_of(genome, *genome.find_node(id)); };
    BOOST_TEST(name(oscillator, input::maternal_south) == "maternal south");
    BOOST_TEST(name(oscillator, input::count + output::phase) == "phase");
    BOOST_TEST(name(grn, input::count + output::spring) == "spring");
    BOOST_TEST(name(grn, input::count + 5) == "hidden 14");
    const Genome other = specimens::bare_genome(3, 2);
    BOOST_TEST(name(other, 1) == "input 1");
    BOOST_TEST(name(other, 2) == "bias 2");
    BOOST_TEST(name(other, 4) == "output 1");
    for (const Actuation actuation : {Actuation::oscillator, Actuation::grn}) {
        std::set<std::string> names;
        for (int channel = 0; channel < output::count(actuation); ++channel)
            names.insert(output::name_of(actuation, channel));
        BOOST_TEST(static_cast<int>(names.size()) == output::count(actuation));
    }
}

BOOST_AUTO_TEST_CASE(a_description_lists_every_link_below_what_it_feeds_the_strongest_first) {
    const std::string text = description_of(sample(Actuation::grn));
    BOOST_TEST(text.starts_with("genome 42, crossover_mutation of 17 and 9\n"
                                "9 inputs, 5 outputs, 1 hidden node, 5 links\n"),
               text);
    BOOST_TEST(
        contains(text, "\napoptosis\n  bias                   2.000\n  hidden 14              0.250\n"),
        text);
    BOOST_TEST(contains(text, "\nhidden 14, depth 0.5\n  maternal east         -1.500\n"), text);
    BOOST_TEST(contains(text, "  hidden 14              0.750  recurrent\n"), text);
}

BOOST_AUTO_TEST_CASE(graphviz_and_picture_have_every_node_and_every_link) {
    const Genome genome = sample(Actuation::oscillator);
    const std::string dot = dot_of(genome);
    BOOST_TEST(count(dot, " [label=") == genome.nodes.size());
    BOOST_TEST(count(dot, " -> ") == genome.links.size());
    BOOST_TEST(count(dot, "style=dashed") == 2u);
    const std::string svg = svg_of(genome, "a < b & c");
    BOOST_TEST(svg.starts_with("<svg "));
    BOOST_TEST(svg.ends_with("</svg>\n"));
    BOOST_TEST(contains(svg, ">a &lt; b &amp; c<"));
    BOOST_TEST(count(svg, "<circle ") == genome.nodes.size());
    BOOST_TEST(count(svg, "<title>") == genome.links.size());
    BOOST_TEST(contains(svg, "<title>-1.5</title>"));
    BOOST_TEST(contains(svg, ">maternal east<"));
    BOOST_TEST(svg == svg_of(genome, "a < b & c"));
}

BOOST_AUTO_TEST_CASE(a_picture_stays_in_its_frame_and_hidden_nodes_do_not_lie_on_each_other) {
    Genome genome = specimens::bare_genome(Actuation::oscillator);
    for (int i = 0; i < 6; ++i) {
        genome.nodes.push_back({15 + i, NodeKind::hidden, 0.5});
        specimens::add_link(genome, input::x, 15 + i, 1);
    }
    const std::string svg = svg_of(genome, "");
    std::vector<double> heights;
    for (std::size_t at = svg.find("<circle "); at != svg.npos; at = svg.find("<circle ", at + 1))
        heights.push_back(std::stod(svg.substr(svg.find("cy=\"", at) + 4)));
    std::sort(heights.end() - 6, heights.end());
    for (auto height = heights.end() - 5; height != heights.end(); ++height)
        BOOST_TEST(*height - *(height - 1) > 24);
    BOOST_TEST(*std::max_element(heights.begin(), heights.end()) < 580);
    BOOST_TEST(*std::min_element(heights.begin(), heights.end()) > 80);
}

BOOST_AUTO_TEST_CASE(a_genome_without_links_can_be_shown) {
    const Genome genome = specimens::bare_genome(Actuation::grn);
    BOOST_TEST(!description_of(genome).empty());
    BOOST_TEST(contains(svg_of(genome, ""), "|weight| 0.00"));
}
