// SPDX-License-Identifier: MIT
// What the native engine alone promises: the same bits at any width of lanes and any spacing of knots.
#include "physics/native/native_engine.h"

#include "base/math.h"
#include "physics/embody.h"
#include "physics/laws/contact.h"
#include "support/motion.h"
#include "support/print.h"
#include "support/specimens.h"

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <cmath>
#include <string_view>

using namespace planula;
using namespace planula::specimens;

namespace {

/// How a body that swings has moved.
struct Swing {
    std::vector<double> speeds; // of the fastest node, after each step
    std::vector<Vec2d> positions, velocities;
    int contacts = 0;   // of every tenth step, those at which it touches itself
    double closest = 1; // how near a cell comes to a link in one of these
};

/// The least distance of a cell from a link that may collide with it.
double closest(const SoftBodyModel &model, const std::vector<Vec2d> &positions) {
    double least = 1e9;
    for (std::size_t cell = 0; cell < model.contact_cells.size(); ++cell)
        for (std::size_t link = 0; link < model.outline.size(); ++link) {
            if (model.is_masked(cell, link)) continue;
            const Vec2d p = positions[model.contact_cells[cell]];
            const auto [a, b, solid] = model.outline[link];
            least = std::min(least, length(p - foot_on_segment(p, positions[a], positions[b]).point));
        }
    return least;
}

Swing swung(const native::Kernel &kernel, const Body &body, const Environment &environment, int steps) {
    const auto model = soft_body(body, environment);
    NativeEngine engine(kernel);
    engine.load(model, environment);
    Swing swing;
    for (int t = 0; t < steps; ++t) {
        std::vector<double> extensions;
        for (int i = 0; i < model.nodes(); ++i)
            extensions.push_back(std::min(1.0, 0.005 * t) *
                                 ((i % 2 == 1 ? 0.125 : -0.125) + 0.1 * math::sin(0.06 * t + 0.7 * i)));
        if (t % 10 == 0) engine.actuate(extensions, 10);
        swing.speeds.push_back(engine.step(t < 50 ? 1 : 0).fastest);
        if (t % 10 > 0) continue;
        swing.closest = std::min(swing.closest, closest(model, engine.positions()));
        swing.contacts += is_touching(model, engine.positions());
    }
    swing.positions = engine.positions(), swing.velocities = engine.velocities();
    return swing;
}

} // namespace

BOOST_AUTO_TEST_CASE(every_width_of_lanes_gives_the_same_bits) {
    Environment hills = land(), stream = water();
    hills.ground = {{-5, 0}, {-1, 0.5}, {0, 0}, {0.8, -0.4}, {0.8 + 1e-6, 0.1}, {2, -1}, {6, 1}};
    stream.flow = {0.5, -0.25};
    int contacts = 0;
    for (const Environment &environment : {empty_space(), stream, land(), hills}) {
        // A ring closes until its ends collide.
        const Swing scalar = swung(native::kernels().front(), hook(), environment, 1500);
        contacts += scalar.contacts;
        BOOST_TEST(scalar.closest > 0.2); // ends push each other away
        for (const native::Kernel &kernel : native::kernels()) {
            const Swing wide = swung(kernel, hook(), environment, 1500);
            BOOST_TEST((wide.speeds == scalar.speeds), kernel.name);
            BOOST_TEST((wide.positions == scalar.positions), kernel.name);
            BOOST_TEST((wide.velocities == scalar.velocities), kernel.name);
        }
    }
    BOOST_TEST(contacts > 20);
}

BOOST_AUTO_TEST_CASE(lanes_that_are_not_all_needed_change_no_bit) {
    // Full and partly filled groups, in odd and even numbers.
    for (const auto &[columns, rows] :
         {std::pair{1, 1}, {4, 2}, {3, 3}, {8, 2}, {17, 1}, {6, 4}, {5, 5}, {11, 3}}) {
        const Body body = lattice(columns, rows);
        const Swing scalar = swung(native::kernels().front(), body, land(), 200);
        for (const native::Kernel &kernel : native::kernels()) {
            const Swing wide = swung(kernel, body, land(), 200);
            BOOST_TEST((wide.speeds == scalar.speeds), kernel.name << ", " << body.cells() << " cells");
            BOOST_TEST((wide.positions == scalar.positions), kernel.name << ", " << body.cells() << " cells");
        }
    }
}

BOOST_AUTO_TEST_CASE(the_kernel_is_that_of_the_chosen_lanes) {
    const std::string_view widest = name_of(chosen_lanes());
    for (const LaneSet lanes : lane_sets()) {
        choose_lanes(name_of(lanes));
        BOOST_TEST(native::chosen_kernel().name == name_of(lanes));
    }
    choose_lanes(widest);
}

BOOST_AUTO_TEST_CASE(muscles_that_hold_still_need_no_knots) {
    const auto model = soft_body(hook(), empty_space());
    const auto positions_after = [&](int interval) {
        NativeEngine engine;
        engine.load(model, empty_space());
        std::vector<double> extensions(static_cast<std::size_t>(model.nodes()));
        const auto pull = [&](double share, int steps) {
            for (int i = 0; i < model.nodes(); ++i) extensions[i] = share * math::sin(0.7 * i);
            engine.actuate(extensions, steps);
            for (int i = 0; i < steps; ++i) engine.step(0);
        };
        // Each goes to its place in 10 steps and stays there for 60, in several knots or in one.
        for (const double share : {0.0, 0.2, -0.1, 0.0, 0.2}) {
            pull(share, 10);
            for (int i = 0; i < 60; i += interval) pull(share, interval);
        }
        return engine.positions();
    };
    const auto expected = positions_after(60);
    BOOST_TEST((positions_after(10) == expected));
    BOOST_TEST((positions_after(20) == expected));
}
