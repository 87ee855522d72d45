// SPDX-License-Identifier: MIT
// The resolved setting as a text that is also Lua: the same setting gives the same bytes on every machine.
#include "base/text.h"
#include "scripting/schema.h"

#include <algorithm>

namespace planula {

namespace {

std::string pair_of(const char *first, double x, const char *second, double y) {
    return "{ " + std::string(first) + to_text(x) + ", " + second + to_text(y) + " }";
}

std::string ground_text(const Environment &environment) {
    if (!environment.has_ground) return "\"none\"";
    if (environment.ground.empty()) return "\"flat\"";
    std::string text = "{";
    for (const Vec2d point : environment.ground)
        text.append(" ").append(pair_of("", point.x, "", point.y)).append(",");
    return text + " }";
}

std::string environment_text(const Spec &setting) {
    const Environment &e = setting.environment;
    return "  environment = {\n    gravity = " + to_text(e.gravity) + ",\n    ground = " + ground_text(e) +
           ",\n    friction = " + to_text(e.friction) +
           ",\n    drag = " + pair_of("normal = ", e.drag_normal, "tangential = ", e.drag_tangential) +
           ",\n    flow = " + pair_of("x = ", e.flow.x, "y = ", e.flow.y) +
           ",\n    actuation_range = " + to_text(setting.actuation_range) + ",\n  },\n";
}

// The sources that decide results, the script first, then its modules by name; never by path.
std::string sources_text(const Experiment &experiment) {
    std::vector<std::pair<std::string, std::string>> hashes;
    for (std::size_t i = 0; i < experiment.code_sources; ++i) {
        const Source &source = experiment.sources->all()[i];
        hashes.emplace_back(source.module, source.sha256);
    }
    std::sort(hashes.begin(), hashes.end());
    std::string text = "  sources = {\n";
    for (const auto &[module, hash] : hashes)
        text +=
            "    { name = \"" + (module.empty() ? "script" : module) + "\", sha256 = \"" + hash + "\" },\n";
    return text + "  },\n";
}

std::string start_text(const Spec &setting) {
    return setting.start ? "  start = { generations = " + to_text(setting.start->generations) + " },\n" : "";
}

} // namespace

std::string resolved_text(const Experiment &experiment, const Spec &setting) {
    std::string text =
        "-- SPDX-License-Identifier: MIT\n-- A setting with every value that decides its results.\n"
        "return {\n  setting = \"" +
        setting.name + "\",\n  actuation = \"" + name_of(setting.actuation) + "\",\n  search = \"" +
        setting.search + "\",\n  engine = \"" + setting.engine + "\",\n" + environment_text(setting) +
        "  parameters = {\n";
    for (const ParameterRow &row : parameter_rows())
        text +=
            "    " + std::string(row.name) + " = " + to_text(parameter(setting.parameters, row.name)) + ",\n";
    return text + "  },\n" + start_text(setting) + sources_text(experiment) + "}\n";
}

RunIdentity identity_of(const Experiment &experiment, const Spec &setting) {
    const Source &script = experiment.sources->script();
    return {script.name, script.text, resolved_text(experiment, setting)};
}

} // namespace planula
