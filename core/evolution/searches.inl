// SPDX-License-Identifier: MIT
// Every search that an experiment may name, one line each:
//
//   SEARCH(name, function, score)
//
// name      as the experiment states it
// function  std::unique_ptr<Search> function(const Parameters &), defined in core/evolution/<function>.cpp
// score     what the search rewards, for messages and help
SEARCH("neat", fitness_search, "fitness")
SEARCH("novelty", novelty_search, "novelty (Eq. 7) times penalty")
SEARCH("nsga2", nsga2_search, "individuals outranked by fitness and novelty")
SEARCH("nslc", local_competition_search, "individuals outranked by novelty, fitness among neighbours and genotypic diversity")
SEARCH("map-elites", map_elites_search, "fitness added to the map of elites")
#undef SEARCH
