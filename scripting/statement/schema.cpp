// SPDX-License-Identifier: MIT
#include "statement/schema.h"

#include "base/error.h"
#include "base/text.h"
#include "evolution/search.h"
#include "physics/engine.h"
#include "statement/meaning.h"
#include "statement/reader.h"
#include "statement/schema_aims.h"
#include "statement/schema_course.h"
#include "statement/schema_environment.h"
#include "statement/schema_statistics.h"

#include <algorithm>
#include <set>

namespace planula {

namespace {

constexpr std::string_view actuation_names[] = {"oscillator", "grn"};
constexpr std::string_view record_names[] = {"full", "sample"};
constexpr std::string_view function_names[] = {"fitness", "penalty", "behaviour"};

// New judging functions of a setting, and the judge that calls them.
std::shared_ptr<JudgingFunctions> functions_of(const std::shared_ptr<Sources> &sources, std::size_t setting,
                                               const Parameters &parameters, Stage stage, Judge &judge) {
    auto functions =
        std::make_shared<JudgingFunctions>(sources, static_cast<int>(setting), parameters, stage);
    judge = [functions](const Life &life) { return functions->judge(life); };
    return functions;
}

class Schema {
  public:
    Schema(std::shared_ptr<Sources> sources, const Overrides &overrides, Part part)
        : lua_(sources, sources->script()), overrides_(overrides), part_(part), problems_(*sources) {
        experiment_.sources = std::move(sources);
        experiment_.overrides = overrides;
    }

    Experiment read() {
        const Value &result = lua_.result();
        const Place root = problems_.root(result, lua_.main());
        const bool several = result.find("settings") != nullptr;
        Reader reader(result, root, keys_of(several ? "experiment" : "single"), problems_);
        const std::size_t problems_before = problems_.count();
        experiment_.name = reader.text("name", true);
        // It names a folder; a single setting has the same name, which is checked with the setting.
        if (several && problems_.count() == problems_before)
            check_at(reader.at("name"), problems_, [&] { check_name("an experiment", experiment_.name); });
        experiment_.title = reader.text("title");
        if (several) {
            record_ = recording(reader, full_record);
            read_settings(reader);
        } else
            read_setting(reader, nullptr);
        if (!several && experiment_.title.empty() && !experiment_.settings.empty())
            experiment_.title = experiment_.settings.front().title;
        if (part_ == Part::all) read_statistics_of(reader);
        if (const Value *plan = reader.field("sensitivity", Value::Kind::table, false))
            experiment_.sensitivity = read_sensitivity(*plan, reader.at("sensitivity"), problems_);

        // The functions can be tried out once everything that they are given is right.
        problems_.raise();
        read_meanings();
        for (const auto *all : {&experiment_.functions, &start_functions_})
            for (const auto &functions : *all) {
                try {
                    const auto setting = static_cast<std::size_t>(functions->setting());
                    functions->try_out(experiment_.settings[setting].observed);
                } catch (const InputError &error) {
                    problems_.add(error.what());
                }
            }
        if (part_ == Part::all) try_out(statistics_, experiment_.analysis, experiment_.settings, problems_);
        problems_.raise();
        return std::move(experiment_);
    }

  private:
    void read_settings(Reader &reader) {
        const Value *list = reader.field("settings", Value::Kind::table, false);
        if (!list) return;
        const Place place = reader.at("settings");
        Reader of_list(*list, place, {}, problems_, true);
        if (list->list.empty()) problems_.add(place, "settings is empty: state at least one setting");
        const Value *shared = reader.field("parameters", Value::Kind::table, false);
        std::set<std::string> names;
        for (std::size_t i = 0; i < list->list.size(); ++i) {
            const Value &entry = list->list[i];
            const Place here = place.at(static_cast<int>(i + 1), &entry);
            if (!entry.is(Value::Kind::table)) {
                problems_.add(here, here.words + " must be a table");
                continue;
            }
            Reader of_entry(entry, here, keys_of("setting"), problems_);
            read_setting(of_entry, shared);
            const std::string &name = experiment_.settings.back().name;
            if (!names.insert(name).second) problems_.add(here, "two settings are called '" + name + "'");
        }
    }

    // One setting; `shared` parameters come before its own, those from outside after.
    void read_setting(Reader &reader, const Value *shared) {
        const std::size_t problems_before = problems_.count();
        Spec &spec = experiment_.settings.emplace_back();
        experiment_.functions.emplace_back();
        Places &world_places = experiment_.world_places.emplace_back();
        if (!problems_.is_full()) note_places(reader, shared);
        spec.name = reader.text("name", true);
        spec.title = reader.text("title");
        if (spec.title.empty()) spec.title = spec.name;
        read_actuation(reader, spec);
        spec.search = choice(reader, "search", true, search_names());
        if (const std::string engine = choice(reader, "engine", false, engine_names()); !engine.empty())
            spec.engine = engine;
        if (shared)
            set_parameters(*shared, problems_.root(lua_.result(), lua_.main()).at("parameters", shared),
                           spec);
        if (const Value *own = reader.field("parameters", Value::Kind::table, false))
            set_parameters(*own, reader.at("parameters"), spec);
        if (experiment_.settings.size() == 1) design_ = spec.parameters;
        for (const auto &[name, value] : overrides_) set_parameter(spec.parameters, name, value);
        if (const Value *environment = reader.field("environment", Value::Kind::table, true)) {
            World world =
                read_environment(*environment, reader.at("environment"), spec.parameters, lua_, problems_);
            spec.environment = std::move(world.environment);
            spec.actuation_range = world.actuation_range;
            spec.world_sources = std::move(world.sources);
            world_places = std::move(world.places);
        }
        read_phases(reader, lua_, spec, world_places, problems_);
        read_damage(reader, spec, problems_);
        const std::size_t problems_of_others = problems_.count();
        spec.aims = read_aims(reader, problems_);
        read_judgement(reader, problems_.count() == problems_of_others, spec);
        read_start(reader, spec);
        spec.record = recording(reader, record_);
        // Rules between the parts, once each part is right.
        if (problems_.count() == problems_before)
            check_at(reader.place(), problems_, [&] { check_spec(spec); });
    }

    // Where the setting's keys and parameters are stated.
    void note_places(const Reader &reader, const Value *shared) {
        Places &places = experiment_.places.emplace_back();
        places[""] = problems_.line_of(reader.place());
        for (const auto &[key, value] : reader.table().fields)
            places[key] = problems_.line_of(reader.at(key));
        const auto note = [&](const Value &parameters, const Place &place, Places &into,
                              const std::string &before) {
            if (parameters.fields.size() > parameter_rows().size())
                return; // unknown names, reported elsewhere
            for (const auto &[name, value] : parameters.fields)
                into[before + name] = problems_.line_of(place.at(name, &value));
        };
        if (shared)
            for (Places *into : {&places, &experiment_.shared_parameters})
                note(*shared, problems_.root(lua_.result(), lua_.main()).at("parameters", shared), *into,
                     into == &places ? "parameters." : "");
        if (const Value *own = reader.table().find("parameters"))
            note(*own, reader.at("parameters"), places, "parameters.");
    }

    /// A text that must be one of some names; empty if it is missing.
    static std::string choice(Reader &reader, const std::string &key, bool needed,
                              std::span<const std::string_view> names) {
        const std::string name = reader.text(key, needed);
        if (!name.empty() && std::find(names.begin(), names.end(), name) == names.end())
            reader.report(key, reader.at(key).words + ": " + not_one_of(name, names));
        return name;
    }

    /// What a `record` says, or else the fallback.
    static Recording recording(Reader &reader, Recording fallback) {
        const Value *stated = reader.table().find("record");
        if (!stated) return fallback;
        if (!stated->is(Value::Kind::number))
            return record_of(choice(reader, "record", false, record_names)).value_or(fallback);
        const int least = reader.whole("record");
        if (least >= 1 && least <= recorded_most) return {.full = false, .least = least};
        reader.report("record", reader.at("record").words + ": a sample has 1 to " + to_text(recorded_most) +
                                    " individuals, not " + to_text(least));
        return fallback;
    }

    void read_actuation(Reader &reader, Spec &spec) {
        const std::string name = reader.text("actuation", true);
        const auto found = std::find(std::begin(actuation_names), std::end(actuation_names), name);
        if (found != std::end(actuation_names))
            spec.actuation = found == actuation_names ? Actuation::oscillator : Actuation::grn;
        else if (!name.empty())
            reader.report("actuation",
                          reader.at("actuation").words + ": " + not_one_of(name, actuation_names));
    }

    void set_parameters(const Value &table, const Place &place, Spec &spec) {
        if (!table.list.empty()) problems_.add(place, "parameters are stated by name: name = value");
        for (const auto &[name, value] : table.fields) {
            const Place here = place.at(name, &value);
            check_at(here, problems_, [&, &key = name, &stated = value] {
                const std::string elsewhere = where_it_belongs(key, stated, {"parameters"});
                if (!elsewhere.empty())
                    throw InputError("no parameter is called '" + key + "'; " + elsewhere);
                const ParameterRow &row = parameter_row(key);
                const Value::Kind kind = row.is_choice() ? Value::Kind::text : Value::Kind::number;
                if (!stated.is(kind))
                    throw InputError(here.words + " must be " + name_of(kind) + ", not " +
                                     name_of(stated.kind));
                set_parameter(spec.parameters, key,
                              row.is_choice() ? value_of(row, stated.text) : stated.number);
            });
        }
    }

    // The judge of a setting that has all its functions; `complete`: those of its objectives.
    void read_judgement(Reader &reader, bool complete, Spec &spec) {
        for (const std::string_view name : function_names)
            if (!reader.field(std::string(name), Value::Kind::function, true)) complete = false;
        spec.judge = [](const Life &) { return Evaluation{}; };
        if (!complete) return;
        const std::size_t index = experiment_.settings.size() - 1;
        experiment_.functions.back() =
            functions_of(experiment_.sources, index, spec.parameters, Stage::life, spec.judge);
    }

    // How generation 0 is evolved before the run, if the setting says so.
    void read_start(Reader &reader, Spec &spec) {
        const Value *table = reader.field("start", Value::Kind::table, false);
        if (!table) return;
        Reader of_start(*table, reader.at("start"), keys_of("start"), problems_);
        spec.start.emplace();
        spec.start->generations = of_start.whole("generations", true);
        spec.start->judge = [](const Life &) { return Evaluation{}; };
        if (!of_start.field("behaviour", Value::Kind::function, true) || !experiment_.functions.back())
            return;
        const std::size_t index = experiment_.settings.size() - 1;
        start_functions_.push_back(
            functions_of(experiment_.sources, index, spec.parameters, Stage::growth, spec.start->judge));
    }

    // What the functions of each setting mean.
    void read_meanings() {
        Meanings meanings(*experiment_.sources);
        for (std::size_t i = 0; i < experiment_.settings.size(); ++i) {
            try {
                experiment_.settings[i].judgement = meanings.of_setting(i);
                experiment_.settings[i].observed = observed_in(experiment_.settings[i], meanings.observed(i));
                check_activity(experiment_.settings[i],
                               meanings.reads_without(i, "activity", "activity_bonus"));
            } catch (const InputError &error) {
                problems_.add(error.what());
            }
        }
    }

    // Of what the functions read, what this setting has.
    static ObservationSet observed_in(const Spec &spec, const ObservationSet &read) {
        ObservationSet observed;
        int number = 0;
        for (const ObservationRow &row : observation_rows()) {
            const auto one = static_cast<Observation>(number++);
            if (read.has(one) && (!row.exists.holds || row.exists.holds(spec))) observed.add(one);
        }
        return observed;
    }

    // With oscillators Eq. (4) has no bonus, so that activity is 0 there and means no effort (decision 0026).
    void check_activity(const Spec &spec, const std::string &reader) {
        if (spec.actuation == Actuation::oscillator && !reader.empty())
            problems_.add(
                reader + " reads life.activity, which is 0 with oscillators: it counts the changes of " +
                "gene networks, for the bonus of Eq. 4 alone; life.work is the work that muscles did");
    }

    void read_statistics_of(Reader &reader) {
        // Claims name settings: they are read once these are right.
        if (problems_.count() > 0) return;
        const Value *stated = reader.table().find("statistics");
        if (!stated || !stated->is(Value::Kind::text)) {
            if (reader.field("statistics", Value::Kind::table, true))
                read_statistics_at(*stated, reader.at("statistics"), "");
            return;
        }
        // A module of statistics runs in a state of its own, so that it can decide no result of a run.
        check_at(reader.at("statistics"), problems_, [&] {
            const Source &source = experiment_.sources->module(stated->text);
            const LuaState statistics(experiment_.sources, source);
            read_statistics_at(statistics.result(), problems_.root(statistics.result(), source),
                               stated->text);
        });
    }

    void read_statistics_at(const Value &table, const Place &place, const std::string &module) {
        statistics_ = {experiment_.sources, module};
        experiment_.analysis = read_statistics(table, place, statistics_, experiment_.name, design_,
                                               experiment_.settings, problems_);
    }

    LuaState lua_;
    const Overrides &overrides_;
    const Part part_;
    Problems problems_;
    Experiment experiment_;
    std::vector<std::shared_ptr<JudgingFunctions>> start_functions_;
    StatisticSource statistics_;
    Recording record_;  // of settings that state none
    Parameters design_; // of the first setting, as the script states them
};

// While a script is checked, the instructions of all its states are limited together.
class LimitedCheck {
  public:
    explicit LimitedCheck(std::shared_ptr<Sources> sources) : sources_(std::move(sources)) {
        sources_->limit_instructions(true);
    }
    LimitedCheck(const LimitedCheck &) = delete;
    LimitedCheck &operator=(const LimitedCheck &) = delete;
    ~LimitedCheck() { sources_->limit_instructions(false); }

  private:
    std::shared_ptr<Sources> sources_;
};

} // namespace

const Spec *Experiment::find(std::string_view setting) const {
    for (const Spec &spec : settings)
        if (spec.name == setting) return &spec;
    return nullptr;
}

SettingForRun setting_for_run(const Experiment &experiment, std::size_t index) {
    SettingForRun own{experiment.settings.at(index), nullptr, experiment.name};
    Spec &spec = own.spec;
    own.functions = functions_of(experiment.sources, index, spec.parameters, Stage::life, spec.judge);
    if (spec.start)
        functions_of(experiment.sources, index, spec.parameters, Stage::growth, spec.start->judge);
    return own;
}

Experiment load_experiment(const std::filesystem::path &script, const std::filesystem::path &library,
                           const Overrides &overrides, Part part) {
    return load_experiment(std::make_shared<Sources>(script, library), overrides, part);
}

Experiment load_experiment(std::shared_ptr<Sources> sources, const Overrides &overrides, Part part) {
    const LimitedCheck limited(sources);
    return Schema(std::move(sources), overrides, part).read();
}

} // namespace planula
