// SPDX-License-Identifier: MIT
#include "statement/judging_functions.h"

#include "base/check.h"
#include "base/error.h"
#include "base/state.h"
#include "base/text.h"
#include "evaluation/example_life.h"
#include "experiment/deciding.h"
#include "language/captures.h"
#include "language/lua_state.h"
#include "language/wrap.h"
#include "statement/wrap_life.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <optional>
#include <vector>

namespace planula {

namespace {

constexpr std::size_t longest_behaviour = 16;
constexpr double largest = 1e100; // fitness and behaviour beyond this would overflow sums and squares
// A life is judged twice if the number of the call is a power of two or a multiple of this one.
constexpr std::int64_t calls_between_samples = 1024;
// What the functions close over is checked after every life, and up to this many values after every call, so that a
// message can name the function. To check a value takes 40 ns, to simulate a life milliseconds (decision 0028).
constexpr int values_for_each_call = 127;
constexpr const char *independence_rule = ": how a life is judged must not depend on other lives";
constexpr Limits limits_of_a_call{
    .memory = 64u << 20, .allocated = 256u << 20, .instructions = 5'000'000, .seconds = 3};

bool is_sample(std::int64_t call) {
    return std::has_single_bit(static_cast<std::uint64_t>(call)) || call % calls_between_samples == 0;
}

} // namespace

// The result of the functions for one life.
struct JudgingFunctions::Verdict {
    Evaluation evaluation;
    std::string problem;     // of the functions; empty without a problem
    bool wrong_kind = false; // the problem is an error or a value of another kind
    Exhausted exhausted = Exhausted::no;
};

// The functions in a Lua state of their own.
class JudgingFunctions::Functions {
  public:
    Functions(std::shared_ptr<Sources> sources, int index, const Parameters &parameters, Stage stage)
        : lua_(sources, sources->script()), parameters_(parameters), stage_(stage) {
        const Value &result = lua_.result();
        const Value *settings = result.find("settings");
        const Value &setting = settings ? settings->list.at(static_cast<std::size_t>(index)) : result;
        const bool grown = stage == Stage::growth;
        add("penalty", setting.find("penalty"));
        add("fitness", setting.find("fitness"));
        add("behaviour", grown ? setting.find("start")->find("behaviour") : setting.find("behaviour"));
        if (const Value *objectives = setting.find("objectives"); objectives && !grown)
            for (const Value &objective : objectives->list)
                if (objective.is(Value::Kind::table))
                    add("objective " + objective.find("name")->text, objective.find("value"));
        if (const Value *descriptor = setting.find("descriptor"); descriptor && !grown)
            numbers_ = descriptor->list.size();
        if (const auto message = lua_.inspect(gate<prepare>, this, limits_of_a_call))
            throw InputError(*message);
        captures_.emplace(lua_, references_);
    }

    /// From now on, checks what the functions close over after every call, however much that is.
    void blame() { blames_ = true; }

    /// "file:line: " of the function of that name.
    std::string where(std::string_view name) {
        lua_Debug function;
        const auto place = std::find(names_.begin(), names_.end(), name) - names_.begin();
        lua_rawgeti(lua_.raw(), LUA_REGISTRYINDEX, references_.at(static_cast<std::size_t>(place)));
        lua_getinfo(lua_.raw(), ">S", &function);
        return std::string(function.short_src) + ":" + to_text(function.linedefined) + ": ";
    }

    const std::string &name_of_objective(std::size_t index) const {
        return names_.at(first_objective + index);
    }

    /// The length of the run's behaviours; 0 until one is seen.
    std::size_t &length() { return length_; }

    void check_unchanged() {
        const auto changed = captures_->changed();
        if (!changed) return;
        const bool is_module = *changed == names_.size();
        const std::string name = names_[is_module ? 0 : *changed];
        throw InputError(where(name) + "what " + (is_module ? "modules hold" : name + " closes over") +
                         " was changed by a judgement" + independence_rule);
    }

    Verdict judge(const Life &life) {
        slot_->life = &life;
        Verdict verdict;
        ask(verdict);
        slot_->life = nullptr;
        check_unchanged();
        if (!verdict.problem.empty()) verdict.evaluation = {};
        return verdict;
    }

  private:
    // Makes the two values that are passed to every call.
    static int prepare(lua_State *L) {
        Functions &self = *static_cast<Functions *>(lua_touserdata(L, 1));
        wrap_life(L);
        self.slot_ = &push_life(L);
        self.slot_->only_grown = self.stage_ == Stage::growth;
        self.life_ = luaL_ref(L, LUA_REGISTRYINDEX);
        lua_newtable(L);
        for (const ParameterRow &row : parameter_rows()) {
            if (!decides_lives(row)) continue;
            lua_pushlstring(L, row.name.data(), row.name.size());
            push_value(L, row, parameter(self.parameters_, row.name));
            lua_rawset(L, -3);
        }
        freeze(L, "parameters", why_not_shown);
        self.shown_parameters_ = luaL_ref(L, LUA_REGISTRYINDEX);
        return 0;
    }

    enum Place { penalty, fitness, behaviour, first_objective }; // among the functions

    void add(const std::string &name, const Value *function) {
        CHECK(function && function->is(Value::Kind::function), name);
        names_.push_back(name);
        references_.push_back(function->function);
    }

    void ask(Verdict &verdict) {
        Evaluation &evaluation = verdict.evaluation;
        if (!number(penalty, nullptr, evaluation.penalty, verdict)) return;
        if (evaluation.penalty > 1) return fail("penalty", "returned a number above 1", verdict);
        if (!evaluation.valid()) return;
        if (stage_ == Stage::life && !number(fitness, &evaluation.penalty, evaluation.fitness, verdict))
            return;
        list(evaluation.behaviour, verdict);
        for (std::size_t i = first_objective; i < names_.size() && verdict.problem.empty(); ++i)
            number(i, &evaluation.penalty, evaluation.objectives.emplace_back(), verdict);
    }

    void fail(const std::string &name, const std::string &what, Verdict &verdict) {
        verdict.problem = where(name) + name + " " + what;
    }
    void fail_kind(const std::string &name, const std::string &wanted, int type, Verdict &verdict) {
        fail(name, "returned " + std::string(lua_typename(lua_.raw(), type)) + ", not " + wanted, verdict);
        verdict.wrong_kind = true;
    }

    // Leaves one value on the stack; false if an error was raised.
    bool call(std::size_t function, const double *factor, Verdict &verdict) {
        lua_State *L = lua_.raw();
        const std::string &name = names_[function];
        lua_rawgeti(L, LUA_REGISTRYINDEX, references_[function]);
        lua_rawgeti(L, LUA_REGISTRYINDEX, life_);
        lua_rawgeti(L, LUA_REGISTRYINDEX, shown_parameters_);
        if (factor) lua_pushnumber(L, *factor);
        const auto message = lua_.call(factor ? 3 : 2, limits_of_a_call);
        if ((blames_ || captures_->values() <= values_for_each_call) && captures_->changed())
            throw InputError(where(name) + name + " changes what it closes over" + independence_rule);
        if (!message) return true;
        verdict.problem = *message + " (in " + name + ")";
        verdict.wrong_kind = true;
        verdict.exhausted = lua_.exhausted();
        return false;
    }

    // A finite number, 0 or more unless it is an objective's.
    bool number(std::size_t function, const double *factor, double &result, Verdict &verdict) {
        if (!call(function, factor, verdict)) return false;
        lua_State *L = lua_.raw();
        const std::string &name = names_[function];
        const int type = lua_type(L, -1);
        result = unsigned_zero(lua_tonumber(L, -1));
        lua_pop(L, 1);
        if (type != LUA_TNUMBER)
            fail_kind(name, "a number", type, verdict);
        else if (!(std::abs(result) <= largest))
            fail(name, "returned " + to_text(result), verdict);
        else if (result < 0 && function < first_objective)
            fail(name, "returned a number below 0", verdict);
        return verdict.problem.empty();
    }

    void list(std::vector<double> &result, Verdict &verdict) {
        if (!call(behaviour, nullptr, verdict)) return;
        lua_State *L = lua_.raw();
        const int type = lua_type(L, -1);
        const std::size_t size = type == LUA_TTABLE ? lua_objlen(L, -1) : 0;
        if (type != LUA_TTABLE)
            fail_kind("behaviour", "a list of numbers", type, verdict);
        else if (size < 1 || size > longest_behaviour) {
            fail("behaviour", "must return a list of 1 … 16 numbers", verdict);
            verdict.wrong_kind = true;
        }
        for (std::size_t i = 1; i <= size && verdict.problem.empty(); ++i) {
            lua_rawgeti(L, -1, static_cast<int>(i));
            result.push_back(unsigned_zero(lua_tonumber(L, -1)));
            if (lua_type(L, -1) != LUA_TNUMBER)
                fail_kind("behaviour", "numbers", lua_type(L, -1), verdict);
            else if (!(std::abs(result.back()) <= largest))
                fail("behaviour", "returned " + to_text(result.back()), verdict);
            lua_pop(L, 1);
        }
        lua_pop(L, 1);
        if (verdict.problem.empty() && numbers_ != 0 && numbers_ != size) {
            fail("behaviour",
                 "returned " + to_text(static_cast<int>(size)) + " numbers, and descriptor names " +
                     to_text(static_cast<int>(numbers_)),
                 verdict);
            verdict.wrong_kind = true;
        }
        // All descriptors of a run have one length: that of the first.
        if (verdict.problem.empty() && length_ == 0) length_ = size;
        if (verdict.problem.empty() && length_ != size)
            fail("behaviour",
                 "returned " + to_text(static_cast<int>(size)) + " numbers, and " +
                     to_text(static_cast<int>(length_)) + " before",
                 verdict);
    }

    LuaState lua_;
    const Parameters parameters_;
    const Stage stage_;
    LifeSlot *slot_ = nullptr;
    std::vector<std::string> names_; // of the functions, as in Place; then of objectives
    std::vector<int> references_;    // of lua_, of the same
    std::size_t numbers_ = 0;        // that the descriptor names; 0: it names none
    int life_ = 0, shown_parameters_ = 0;
    std::optional<Captures> captures_;
    bool blames_ = false;
    std::size_t length_ = 0;
};

JudgingFunctions::JudgingFunctions(std::shared_ptr<Sources> sources, int index, const Parameters &parameters,
                                   Stage stage)
    : sources_(std::move(sources)), index_(index), parameters_(parameters), stage_(stage) {}

JudgingFunctions::~JudgingFunctions() = default;

JudgingFunctions::Functions &JudgingFunctions::functions() const {
    if (!functions_) functions_ = fresh_functions();
    return *functions_;
}

std::unique_ptr<JudgingFunctions::Functions> JudgingFunctions::fresh_functions() const {
    return std::make_unique<Functions>(sources_, index_, parameters_, stage_);
}

void JudgingFunctions::begin_run() {
    functions_.reset();
    calls_ = invalid_ = 0;
    first_problem_.clear();
}

void JudgingFunctions::continue_run(const std::string &memory) {
    begin_run();
    StateReader reader(memory);
    reader.group("judge");
    constexpr std::int64_t most = std::int64_t{1} << 53;
    functions().length() = static_cast<std::size_t>(reader.integer(0, longest_behaviour));
    calls_ = reader.integer(0, most);
    invalid_ = reader.integer(0, calls_);
    first_problem_ = reader.text();
    reader.done();
}

void JudgingFunctions::check_unchanged() const {
    if (functions_) functions_->check_unchanged();
}

std::string JudgingFunctions::memory() const {
    check_unchanged();
    StateWriter writer;
    writer.group("judge").integer(static_cast<std::int64_t>(functions().length()));
    writer.integer(calls_).integer(invalid_).text(first_problem_);
    return writer.bytes();
}

JudgingFunctions::Verdict JudgingFunctions::judge_twice(const Life &life) {
    const auto others = fresh_functions();
    others->length() = functions().length();
    const Verdict verdict = functions().judge(life);
    check_equal(verdict, others->judge(life));
    return verdict;
}

void JudgingFunctions::check_equal(const Verdict &verdict, const Verdict &fresh) const {
    const auto differ = [&](const char *name) {
        throw InputError(functions().where(name) + name + " depends on earlier calls" +
                         std::string(independence_rule));
    };
    const Evaluation &a = verdict.evaluation, &b = fresh.evaluation;
    if (a.penalty != b.penalty || verdict.problem.empty() != fresh.problem.empty()) differ("penalty");
    if (a.fitness != b.fitness) differ("fitness");
    if (a.behaviour != b.behaviour) differ("behaviour");
    for (std::size_t i = 0; i < a.objectives.size(); ++i)
        if (a.objectives[i] != b.objectives[i]) differ(functions().name_of_objective(i).c_str());
}

void JudgingFunctions::try_out(const ObservationSet &observed) {
    begin_run();
    functions().blame();
    const KnownAfter known = stage_ == Stage::growth ? KnownAfter::growth : KnownAfter::locomotion;
    std::vector<Life> lives;
    std::vector<Verdict> verdicts;
    for (std::size_t i = 0; i < outcome_names.size(); ++i) {
        lives.push_back(example_life(static_cast<Outcome>(i), known, parameters_, observed));
        verdicts.push_back(functions().judge(lives.back()));
        if (verdicts.back().wrong_kind)
            throw InputError(verdicts.back().problem + " for an example life with outcome '" +
                             outcome_names[i] + "'");
    }
    // In the opposite order, what depends on earlier calls differs.
    const auto others = fresh_functions();
    others->length() = functions().length();
    for (std::size_t i = lives.size(); i-- > 0;) check_equal(verdicts[i], others->judge(lives[i]));
    begin_run();
}

JudgingFunctions::Tried JudgingFunctions::try_on(const Life &life) {
    Verdict verdict = is_sample(++calls_) ? judge_twice(life) : functions().judge(life);
    if (verdict.exhausted == Exhausted::memory || verdict.exhausted == Exhausted::seconds)
        throw InputError(verdict.problem);
    return {std::move(verdict.evaluation), std::move(verdict.problem), verdict.wrong_kind};
}

Evaluation JudgingFunctions::judge(const Life &life) {
    Tried tried = try_on(life);
    if (!tried.problem.empty() && invalid_++ == 0) first_problem_ = std::move(tried.problem);
    return std::move(tried.evaluation);
}

} // namespace planula
