// SPDX-License-Identifier: MIT
#include "statement/unread.h"

#include "base/text.h"
#include "experiment/deciding.h"
#include "statement/meaning.h"

#include <algorithm>
#include <map>
#include <optional>

namespace planula {

namespace {

constexpr std::string_view parameter_before = "parameters.";

/// A value of a parameter that settings state; settings that one reads it in may share it with others. `place` is the
/// first.
struct Stated {
    const ParameterRow *row;
    double value;
    std::string place;
    std::vector<std::size_t> settings;
};

std::vector<Stated> stated_parameters(const Experiment &experiment) {
    std::vector<Stated> all;
    for (std::size_t i = 0; i < experiment.settings.size(); ++i)
        for (const auto &[key, place] : experiment.places[i]) {
            if (!key.starts_with(parameter_before)) continue;
            const ParameterRow *row = &parameter_row(key.substr(parameter_before.size()));
            const double value = parameter(experiment.settings[i].parameters, row->name);
            const auto known = std::find_if(all.begin(), all.end(), [&](const Stated &each) {
                return each.row == row && each.value == value;
            });
            if (known == all.end())
                all.push_back({row, value, place, {i}});
            else
                known->settings.push_back(i);
        }
    return all;
}

std::string text_of(const Stated &stated) {
    return "parameters." + std::string(stated.row->name) + " = " + value_text(*stated.row, stated.value);
}

/// "its search is …" as "the setting's search is …".
std::string of_setting(const std::string &why) {
    return why.starts_with("its ") ? "the setting's " + why.substr(4) : why;
}

class Unread {
  public:
    Unread(const Experiment &experiment, const Experiment &paper, Findings &findings)
        : experiment_(experiment), paper_(paper), findings_(findings), meanings_(*experiment.sources) {}

    void find() {
        for (const Stated &stated : stated_parameters(experiment_)) find_unread_parameter(stated);
        find_overridden();
        find_seeds();
        for (std::size_t i = 0; i < experiment_.settings.size(); ++i) find_unread_behaviour(i);
        find_unused_names();
    }

  private:
    void warn(const std::string &place, const std::string &text, std::vector<std::string> settings) {
        findings_.add({false, place, text, std::move(settings)});
    }

    void find_unread_parameter(const Stated &stated) {
        std::vector<std::string> reasons;
        for (const std::size_t i : stated.settings) {
            const std::string why = why_unread_by(experiment_, i, *stated.row);
            if (why.empty() || meanings_.mentions(i, stated.row->name)) return;
            reasons.push_back(why);
        }
        for (std::size_t k = 0; k < reasons.size(); ++k)
            warn(stated.place, text_of(stated) + " changes nothing: " + of_setting(reasons[k]),
                 {experiment_.settings[stated.settings[k]].name});
    }

    void find_overridden() {
        for (const auto &[name, place] : experiment_.shared_parameters) {
            const std::string key = std::string(parameter_before) + name;
            if (std::none_of(experiment_.places.begin(), experiment_.places.end(),
                             [&, &shared = place](const Places &own) { return own.at(key) == shared; }))
                warn(place, key + " is overridden in every setting", {});
        }
    }

    void find_seeds() {
        const int seeds = experiment_.settings.front().parameters.design.seeds;
        for (std::size_t i = 1; i < experiment_.settings.size(); ++i) {
            const Spec &spec = experiment_.settings[i];
            const auto place = experiment_.places[i].find("parameters.seeds");
            if (spec.parameters.design.seeds == seeds || place == experiment_.places[i].end()) continue;
            warn(place->second,
                 "parameters.seeds = " + to_text(spec.parameters.design.seeds) +
                     " is not read: every setting has as many seeds as the first, " + to_text(seeds) +
                     "; state it beside settings",
                 {spec.name});
        }
    }

    // A behaviour that is not the paper's was stated for a purpose.
    void find_unread_behaviour(std::size_t index) {
        const Spec &spec = experiment_.settings[index];
        if (reads_behaviour(spec)) return;
        const auto own = std::find_if(spec.judgement.begin(), spec.judgement.end(),
                                      [](const FunctionMeaning &f) { return f.name == "behaviour"; });
        if (own == spec.judgement.end()) return;
        for (const Spec &setting : paper_.settings)
            for (const FunctionMeaning &known : setting.judgement)
                if (known.sha256 == own->sha256) return;
        warn(own->place, "behaviour is not read: the search '" + spec.search + "' rewards fitness alone",
             {spec.name});
    }

    // local NAME, or local function NAME, with a name that the script has nowhere else.
    void find_unused_names() {
        const Source &script = experiment_.sources->script();
        std::map<std::string_view, int> uses;
        for (const Token &token : script.tokens)
            if (token.kind == Token::Kind::name) ++uses[token.word];
        for (std::size_t i = 0; i + 1 < script.tokens.size(); ++i) {
            if (script.tokens[i].kind != Token::Kind::name || script.tokens[i].word != "local") continue;
            const bool is_function = script.tokens[i + 1].word == "function" && i + 2 < script.tokens.size();
            const Token &name = script.tokens[i + (is_function ? 2 : 1)];
            if (name.kind == Token::Kind::name && uses[name.word] == 1 && !name.word.starts_with("_"))
                warn(script.name + ":" + to_text(name.line),
                     "'" + std::string(name.word) + "' is defined and used nowhere", {});
        }
    }

    const Experiment &experiment_, &paper_;
    Findings &findings_;
    Meanings meanings_;
};

} // namespace

void find_unread(const Experiment &experiment, const Experiment &paper, Findings &findings) {
    Unread(experiment, paper, findings).find();
}

} // namespace planula
