// SPDX-License-Identifier: MIT
// What a setting states of the way of its bodies (decision 0025): `phases`, a list of {at, environment, settle}, and
// `damage`, {at, share, side} or {at, within = {from, to, bottom, top}}.
#pragma once

#include "experiment/spec.h"
#include "language/lua_state.h"
#include "statement/reader.h"
#include "statement/schema_environment.h"

namespace planula {

/// `places`: of the numbers of environments.
void read_phases(Reader &setting, LuaState &lua, Spec &spec, Places &places, Problems &problems);
void read_damage(Reader &setting, Spec &spec, Problems &problems);

} // namespace planula
