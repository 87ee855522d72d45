# SPDX-License-Identifier: MIT
# Everything that planula does, as targets: `make help` lists them. Each target makes or installs what it needs, on
# Debian 12 the system packages too; a second call with nothing to do takes seconds.

# ---- What the caller may set -----------------------------------------------------------------------------------------
SEEDS ?= 1:3
POPULATION ?= 40
GENERATIONS ?= 12
JOBS ?= $(shell nproc)
# The experiment that the paper reports, and where its intermediate results lie.
EXPERIMENT ?= experiments/paper/replication.lua
OUT ?= build
# The tables behind the paper: the tracked ones, unless a design is asked for; then those that `evolve` and `data` make.
asked = $(filter command environment,$(foreach name,SEEDS POPULATION GENERATIONS EXPERIMENT,$(firstword $(origin $(name)))))
DATA ?= $(if $(asked),$(OUT)/data,$(if $(wildcard data/manifest.csv),data,$(OUT)/data))
# The settings whose best individuals the README, and Figures 1 and 2 show.
PORTRAIT ?= osc-aq-ns
EXAMPLE ?= osc-te-ns

# ---- Places ----------------------------------------------------------------------------------------------------------
PLANULA = build/planula
# Runs of another population are other runs; those of another length are the same ones, which become longer.
RUNS = $(OUT)/runs/$(notdir $(basename $(EXPERIMENT)))-$(POPULATION)
FRAMES = $(OUT)/frames
FIGURES = $(OUT)/figures
DESIGN = --seeds $(SEEDS) --generations $(GENERATIONS) --population $(POPULATION)
SCRIPTS = $(wildcard experiments/*.lua experiments/paper/*.lua)

# One locale, one clock (the day on which the original appeared) and one time zone for every tool, so that the same data
# give the same bytes.
export LC_ALL := C.UTF-8
export TZ := UTC
export SOURCE_DATE_EPOCH := 1450310400
export FORCE_SOURCE_DATE := 1
# Asked when a recipe runs, since `deps` may have just installed it.
export CMAKE_GENERATOR = $(if $(shell command -v ninja),Ninja,Unix Makefiles)
SHELL := /bin/bash
.SHELLFLAGS := -euo pipefail -c
.DELETE_ON_ERROR:
.SUFFIXES:
.DEFAULT_GOAL := help
MAKEFLAGS += --no-print-directory --silent

##@ Start here
help: ## list the targets
	@awk 'BEGIN { FS = ":.*## " } \
	  /^##@ / { printf "\n%s\n", substr($$0, 5) } \
	  /^[a-z-]+:.*## / { printf "  make %-18s %s\n", $$1, $$2 }' Makefile
	@echo
	@echo 'Set on the command line: SEEDS=1:20 GENERATIONS=2000 POPULATION=300 (now $(SEEDS) $(GENERATIONS) $(POPULATION)), JOBS, DATA, OUT.'

paper: deps-paper program ## every table and figure, and the article: build/paper.pdf
	@if [ '$(DATA)' = '$(OUT)/data' ]; then $(MAKE) evolve data; fi
	@$(MAKE) $(OUT)/paper.pdf
	@echo 'paper: $(OUT)/paper.pdf'

test: deps build ## build everything and run all tests
	@echo 'test: running …'
	@ctest --test-dir build -j $(JOBS) --output-on-failure --no-tests=error > build/test.log 2>&1 || true
	@awk -f tests/support/summary.awk build/test.log

smoke: ## go all the way from evolution to the article with a tiny design, in build/smoke
	@$(MAKE) OUT=build/smoke DATA=build/smoke/data SEEDS=1:2 POPULATION=16 GENERATIONS=3 paper
	@echo 'smoke: PASS'

##@ Steps of the paper
evolve: program ## run what is missing of SEEDS, GENERATIONS and POPULATION; may be interrupted, the same command resumes
	@$(PLANULA) run $(EXPERIMENT) $(DESIGN) --out $(RUNS)

data: program ## reduce the runs to the tables in build/data, and simulate every champion again (witness)
	@$(MAKE) $(OUT)/data/manifest.csv

frames: program ## simulate the best individuals of each setting again and write its frames
	@$(MAKE) $(FRAMES)/frames.csv

figures: deps-paper program ## draw the article's figures from the tables; RUNS=DIR draws those of your own runs, EXPERIMENT=FILE runs a script first: build/figures/<name>, as FORMATS="pdf svg png"
	@$(if $(own),$(MAKE) own-figures,$(MAKE) figure-files; echo 'figures: $(FIGURES)')

# What the caller names may hold spaces and quotation marks, so the shell takes it from the environment.
own-figures: export EXPERIMENT := $(EXPERIMENT)
own-figures: export RUNS := $(if $(given_runs),$(RUNS))
own-figures:
	@name=$$(basename "$$EXPERIMENT" .lua); runs=$${RUNS:-$(OUT)/runs/$$name-$(POPULATION)}; \
	  [ -n "$$RUNS" ] || $(PLANULA) run "$$EXPERIMENT" $(DESIGN) --out "$$runs"; \
	  [ -n '$(given_script)' ] || name=$$(basename "$$runs"); \
	  bash paper/figures/plot.sh $(PLANULA) "$$runs" "$(FIGURES)/$$name" '$(FORMATS)' $(if $(given_script),"$$EXPERIMENT")
FORMATS ?= pdf svg png
given_runs = $(filter command environment,$(firstword $(origin RUNS)))
given_script = $(filter command environment,$(firstword $(origin EXPERIMENT)))
own = $(given_runs)$(filter-out experiments/paper/replication.lua,$(EXPERIMENT))

gallery: deps-paper program ## run every file of experiments/variants/ a little, and draw its best body for the README: paper/variants/, some 20 minutes
	@bash paper/figures/gallery.sh $(PLANULA) $(OUT)/gallery paper/variants

picture: deps-paper program ## draw the animat of the README, paper/animat.png
	@$(MAKE) paper/animat.png

reproduce: program ## evolve the design of the tracked tables again, from the start, and compare every table and run with the tracked ones; may be interrupted, the same command resumes
	@[ -f data/manifest.csv ] || { echo 'reproduce: there are no tracked tables in data/'; exit 1; }
	@! [ -e $(OUT)/reproduce/compared ] || rm -rf $(OUT)/reproduce
	@$(MAKE) evolve data OUT=$(OUT)/reproduce SEEDS=1:$(call stated,seeds) POPULATION=$(call stated,population) GENERATIONS=$(call stated,generations)
	@touch $(OUT)/reproduce/compared
	@$(call last_states_only,$(OUT)/reproduce/runs)
	@diff -r -x manifest.csv -x script $(OUT)/reproduce/runs/* data/runs/replication || { echo 'reproduce: the runs differ'; exit 1; }
	@different=0; for table in $(OUT)/reproduce/data/*.csv; do \
	  cmp -s "$$table" "data/$${table##*/}" || { echo "reproduce: $${table##*/} differs"; different=$$((different + 1)); }; done; \
	  echo "reproduce: $$(ls $(OUT)/reproduce/data/*.csv | wc -l) tables made again, $$different of them differ from those in data/"; ((different == 0))
# What runs keep of their scripts may differ in what decides no result; identity.csv has what does.
# $(call last_states_only,FOLDER): removes from the runs below a folder the kept states before the last. They only shorten
# what `planula verify` simulates at a time, and would be a fifth of the tracked runs.
last_states_only = rm -rf $(1)/*/progress; find $(1) -type d -name states | while read -r states; do ls "$$states"/*.state | sed '$$d' | xargs -r rm; done
# A number of the design of the tracked tables.
stated = $(shell awk -F, '$$1 == "$(1)" { print $$2 }' data/manifest.csv)

verify: program ## check the tracked data: all files and tables, and in at most MINUTES (10) as much as fits simulated again
	@bash paper/verify.sh $(PLANULA) $(OUT)/verify $(MINUTES)
MINUTES ?= 10

keep-data: ## copy the tables in build/data and their runs, without those of readings, to data/, whose tables `make paper` uses
	@cp $(OUT)/data/*.csv data/
	@rm -rf data/runs; mkdir -p data/runs; cp -r $(RUNS) data/runs/replication; cp -r $(OUT)/runs/searches data/runs/searches
	@$(call last_states_only,data/runs)
	@echo 'data: $(words $(wildcard $(OUT)/data/*.csv)) tables and their runs copied from $(OUT); commit them with the design that made them'

release: paper ## pack the committed sources, the data and the article with their checksums: build/release/, the same bytes for the same commit
	@bash tests/support/packages.sh git xz-utils
	@bash paper/release.sh $(OUT)/paper.pdf $(OUT)/release

sensitivity: program ## halve and double every assumed value for evolved animats: build/data/sensitivity.csv
	@$(PLANULA) run experiments/sensitivity.lua --out $(REPLICATION_RUNS)
	@rm -rf $(OUT)/data.new
	@$(PLANULA) sensitivity experiments/sensitivity.lua --runs $(REPLICATION_RUNS) --out $(OUT)/data.new > /dev/null
	@$(call replace_if_changed,$(OUT)/data.new,$(OUT)/data)
	@echo 'sensitivity: $(OUT)/data/sensitivity.csv; the next `make paper` has its table'

# The replication at the paper's population; the study of sensitivity takes its first seed.
REPLICATION_RUNS = $(OUT)/runs/replication-300

# Gene networks and oscillators, water and land, both searches; small bodies of generation 0 and evolved ones.
specimens: ## take the specimens of `planula check` from the tracked runs: experiments/specimens.csv
	@bash data/specimens.sh > experiments/specimens.csv.new; mv experiments/specimens.csv.new experiments/specimens.csv
	@echo 'specimens: experiments/specimens.csv'

searches: program ## compare five searches at equal numbers of evaluations: build/data/searches.csv
	@$(PLANULA) run experiments/searches.lua --out $(OUT)/runs/searches
	@rm -rf $(OUT)/searches $(OUT)/data.new
	@$(PLANULA) reduce experiments/searches.lua --runs $(OUT)/runs/searches --out $(OUT)/searches > /dev/null
	@mkdir -p $(OUT)/data.new; cp $(OUT)/searches/runs.csv $(OUT)/data.new/searches.csv
	@$(call replace_if_changed,$(OUT)/data.new,$(OUT)/data)
	@echo 'searches: $(OUT)/data/searches.csv; the next `make paper` has its table'

readings: program ## evolve the settings under every reading of the article: build/data/readings.csv; READINGS_GENERATIONS=30 stops earlier
	@levels=; for level in $(READINGS_LEVELS); do if ((level < $(READINGS_GENERATIONS))); then levels+=$$level,; fi; done; \
	  $(PLANULA) run experiments/readings.lua --levels "$${levels}$(READINGS_GENERATIONS)" --out $(READINGS_RUNS)
	@$(MAKE) readings-tables
	@echo 'readings: $(OUT)/data/readings.csv and readings_heredity.csv; the next `make paper` has their tables'

# All readings reach a level before any continues; the tables show the last one, READINGS_GENERATIONS.
READINGS_LEVELS = 15 30
READINGS_GENERATIONS ?= 60
READINGS_RUNS ?= $(OUT)/runs/readings
# Of heredity only every tenth generation and the last, and only the columns that the article shows.
readings-tables:
	@rm -rf $(OUT)/readings $(OUT)/data.new
	@$(PLANULA) reduce experiments/readings.lua --generations $(READINGS_GENERATIONS) --runs $(READINGS_RUNS) --out $(OUT)/readings > /dev/null
	@mkdir -p $(OUT)/data.new; cp $(OUT)/readings/runs.csv $(OUT)/data.new/readings.csv
	@awk -F, -v OFS=, -v last=$$(($(READINGS_GENERATIONS) - 1)) 'NR == 1 { for (i = 1; i <= NF; ++i) at[$$i] = i } \
	  NR == 1 || $$at["generation"] % 10 == 9 || $$at["generation"] == last { print $$at["setting"], $$at["generation"], $$at["runs"], \
	    $$at["heredity_fitness"], $$at["near_mother"], $$at["near_best"], $$at["cyclic"] }' $(OUT)/readings/heredity.csv > $(OUT)/data.new/readings_heredity.csv
	@$(call replace_if_changed,$(OUT)/data.new,$(OUT)/data)

# The claims under the standard reading and two others. The standard's runs are those of the replication, which may be longer.
robustness: program ## evolve the replication under two other readings and judge its claims: build/data/robustness.csv, about an hour
	@rm -rf $(OUT)/robustness; for reading in $(ROBUSTNESS_READINGS); do \
	  case $$reading in standard) set=(); runs=$(REPLICATION_RUNS) ;; *) set=(--set $$reading); runs=$(OUT)/runs/$$reading ;; esac; \
	  $(PLANULA) run experiments/paper/replication.lua $(ROBUSTNESS_DESIGN) "$${set[@]}" --out "$$runs"; \
	  $(PLANULA) reduce experiments/paper/replication.lua $(ROBUSTNESS_DESIGN) "$${set[@]}" --runs "$$runs" --out $(OUT)/robustness/$$reading > /dev/null; done
	@rm -rf $(OUT)/data.new; mkdir -p $(OUT)/data.new
	@cd $(OUT)/robustness; { sed 's/^/reading,/;q' standard/claims.csv; for reading in $(ROBUSTNESS_READINGS); do \
	  sed "1d; s/^/$$reading,/" $$reading/claims.csv; done; } > ../data.new/robustness.csv
	@$(call replace_if_changed,$(OUT)/data.new,$(OUT)/data)
	@echo 'robustness: $(OUT)/data/robustness.csv; the next `make paper` has its table'

ROBUSTNESS_READINGS = standard division_angle_range=0.25 weight_power=1
ROBUSTNESS_DESIGN = --seeds 1:10 --generations 25 --population 300

with_module = $(filter-out 0,$(WASM))
report: program build/page/report.js $(if $(with_module),wasm) ## make a page of the tracked runs, or of the runs in REPORT=DIR, for a browser: build/report/<experiment>/report.html; WASM=1: one that simulates champions again, too
	@page=$$($(PLANULA) report "$$REPORT" $(if $(with_module),--module build/wasm/planula.js) $(if $(filter data/runs/replication,$(REPORT)),--script '$(EXPERIMENT)')); echo "report: $$page"
REPORT ?= data/runs/replication
report: export REPORT := $(REPORT)

# The scripts of reports with the packages that they use, where planula report finds them.
WEB = $(wildcard scripting/report/web/*)
build/page/report.js: $(WEB)
	@command -v npm > /dev/null || bash tests/support/packages.sh npm
	@echo 'report: installing the packages of its page and bundling its scripts …'
	@mkdir -p build/page/web; cp $(WEB) build/page/web
	@cd build/page/web && { npm ci --ignore-scripts --no-audit --no-fund && node build.mjs ..; } > ../web.log 2>&1 || { cat ../web.log; exit 1; }

##@ Building and checking
build: deps build/CMakeCache.txt ## build the program and all tests
	@$(configure_gpu)
	@echo 'build: compiling the program and all tests, minutes the first time …'
	@cmake --build build --parallel $(JOBS) > build/build.log 2>&1 || { cat build/build.log; exit 1; }

program: deps build/CMakeCache.txt ## build the program alone: build/planula
	@$(configure_gpu)
	@echo 'program: compiling, minutes the first time …'
	@cmake --build build --parallel $(JOBS) --target planula > build/program.log 2>&1 || { cat build/program.log; exit 1; }

signature: program ## compare the hash of the runs of experiments/signature.lua with tests/golden/signature and with the one compiled in
	@bash tests/torture/signature.sh $(PLANULA)

verify-signature: deps ## the same for a build by another compiler or at another optimisation level
	@bash tests/torture/signature.sh --alternative

torture: deps build/CMakeCache.txt ## the long tests: compilers, optimisation, threads, processors; 10^5 hostile genomes and cases of each rule; 200 kills; each file operation failing once; 100 altered records; the signature depends on every parameter; a cluster
	@bash tests/torture/signature.sh --all
	@cmake --build build --parallel $(JOBS) --target planula $(TORTURE) > build/torture.log 2>&1 || { cat build/torture.log; exit 1; }
	@build/tests/random_genomes 200000
	@build/tests/passive_bodies 50000
	@build/tests/random_cases 100000
	@bash tests/torture/kills.sh $(PLANULA)
	@bash tests/torture/faults.sh $(PLANULA)
	@bash tests/torture/audit.sh $(PLANULA)
	@bash tests/torture/parameters.sh $(PLANULA)
	@$(MAKE) test-cluster
TORTURE = random_genomes passive_bodies random_cases

test-cluster: program ## run a design as a Slurm job array, on a Slurm that the test starts: time limits, cancelled tasks, a failing node, two tasks for one run; 1 to 2 minutes
	@bash tests/support/packages.sh slurmctld slurmd slurm-client munge || true
	@bash tests/torture/cluster.sh $(PLANULA)

BENCHMARK_RUNS ?= 50
benchmarks: deps build/CMakeCache.txt ## run the searches on XOR, pole balancing and mazes, and compare with MultiNEAT: tests/benchmarks/*.csv; may be interrupted, the same command resumes
	@cmake --build build --parallel $(JOBS) --target benchmarks multineat > build/benchmarks.log 2>&1 || { cat build/benchmarks.log; exit 1; }
	@bash tests/benchmarks/tables.sh build/tests $(BENCHMARK_RUNS) build/benchmarks

REPETITIONS ?= 10000
power: deps build/CMakeCache.txt ## simulate how often the tests of the claims are wrong, and how often they find an effect: tests/power/*.csv, the same on every machine
	@cmake --build build --parallel $(JOBS) --target power > build/power.log 2>&1 || { cat build/power.log; exit 1; }
	@build/tests/power tests/power $(REPETITIONS)
	@echo 'power: tests/power/power.csv and tests/power/coverage.csv'

# The last generation that `bench` measures in evolving populations of all settings.
UNTIL ?= 10
bench: deps build/CMakeCache.txt ## measure the time of steps, growth, queries and evaluations, native and in Bullet, the pace of evolving populations and the time of a full replication: tests/bench/*.csv
	@bash tests/support/packages.sh libbenchmark-dev
	@cmake -S . -B build > build/configure.log 2>&1 || { cat build/configure.log; exit 1; }
	@cmake --build build --parallel $(JOBS) --target planula bench > build/bench.log 2>&1 || { cat build/bench.log; exit 1; }
	@build/tests/bench build/bench.csv 2> build/bench.log
	@$(PLANULA) pace experiments/paper/replication.lua --until $(UNTIL) > build/pace.csv
	@machine=$$(build/tests/bench --machine); \
	  cp build/bench.csv "tests/bench/$$machine.csv"; \
	  cp build/pace.csv "tests/bench/$$machine-pace.csv"; \
	  echo "bench: tests/bench/$$machine.csv and tests/bench/$$machine-pace.csv"

instructions: deps build/CMakeCache.txt ## count the instructions of fixed pieces of work and compare with tests/bench/instructions.csv; KEEP=1 replaces these
	@bash tests/support/packages.sh valgrind
	@cmake --build build --parallel $(JOBS) --target work > build/work.log 2>&1 || { cat build/work.log; exit 1; }
	@bash tests/bench/instructions.sh build/tests/work $(if $(KEEP),--keep)

test-pages: program build/page/report.js ## open reports and replays of the tracked runs in headless Chromium and use them; installs chromium
	@bash tests/support/packages.sh chromium chromium-driver $$(command -v node > /dev/null || echo nodejs)
	@node tests/browser/run.mjs $(PLANULA) build/pages report replay

wasm: ## build the module with which pages simulate individuals again in a browser: build/wasm/planula.js; installs emscripten
	@bash tests/support/packages.sh cmake make ninja-build libcgal-dev libeigen3-dev emscripten
	@echo 'wasm: compiling the core for browsers …'
	@mkdir -p build
	@export NODE_PATH=/usr/share/nodejs; { emcmake cmake -S scripting/wasm -B build/wasm && cmake --build build/wasm --parallel $(JOBS); } > build/wasm.log 2>&1 || \
	  { cat build/wasm.log; exit 1; }
	@echo "wasm: build/wasm/planula.js, $$(($$(wc -c < build/wasm/planula.js) / 1024)) KiB"

# What is simulated again in node: champions of all tracked runs, specimens in all variants, and this many random genomes.
WASM_CASES ?= 4000
test-wasm: program wasm build/page/report.js ## compare lives that the module simulates, in node and in headless Chromium, with those of the program, to the bit
	@bash tests/support/packages.sh chromium chromium-driver $$(command -v node > /dev/null || echo nodejs)
	@cmake --build build --parallel $(JOBS) --target module_cases > build/module_cases.log 2>&1 || { cat build/module_cases.log; exit 1; }
	@build/tests/module_cases experiments data/runs/replication $(WASM_CASES) > build/wasm/cases
	@node tests/browser/module_test.mjs build/wasm/planula.js < build/wasm/cases
	@node tests/browser/run.mjs $(PLANULA) build/pages wasm wasm_report

device-files: ## build for NVIDIA's graphics processors, as program GPU=1 does, and collect what tests/device/check.sh needs on a machine with one: build/device
	@$(MAKE) program GPU=1
	@cmake --build build --parallel $(JOBS) --target device_bench > build/device.log 2>&1 || { cat build/device.log; exit 1; }
	@rm -rf build/device; mkdir -p build/device/bin build/device/lib/compiler
	@cp build/planula build/tests/device_bench build/device/bin
	@cp -r experiments build/device
	@for run in data/runs/replication/*/seed-001; do mkdir -p build/device/$${run#data/} && cp -r $$run/. build/device/$${run#data/}; done
	@ldd $(PLANULA) | awk '$$3 ~ /^\// && $$1 !~ /^lib(c|m|dl|rt|pthread)\.so/ { print $$3 }' | xargs -I{} cp -L {} build/device/lib
	@mv build/device/lib/libstdc++.* build/device/lib/libgcc_s.* build/device/lib/compiler
	@echo "device: $$(du -sh build/device | cut -f1) in build/device; there, run tests/device/check.sh"

lint: ## check layering, forbidden constructs, licences, paths, format, names in the documentation, and that the lint itself can fail
	@passed=0 failed=0; for check in layering sources format documents rooms lint_test; do \
	  if bash tests/lint/$$check.sh; then passed=$$((passed + 1)); else failed=$$((failed + 1)); fi; done; \
	  echo "lint: $$passed passed, $$failed failed"; ((failed == 0))

reference: program ## write REFERENCE.md, which lists everything that an experiment file may state and read
	@$(PLANULA) reference > REFERENCE.md

architecture: ## draw the rooms of core/CMakeLists.txt and scripting/CMakeLists.txt: paper/rooms.svg
	@bash tests/lint/rooms.sh --draw

format: ## clang-format every C++ source in place
	@find core scripting tests -name '*.h' -o -name '*.cpp' -o -name '*.cu' -o -name '*.cuh' | xargs -d '\n' clang-format -i

clean: ## remove build/, runs included
	@rm -rf build

##@ System packages (Debian 12; the other targets install what they need)
BUILD_PACKAGES = g++ cmake make ninja-build pkg-config libeigen3-dev libcgal-dev libbullet-dev libluajit-5.1-dev libboost-test-dev libfccp-dev zlib1g-dev liblzma-dev
PAPER_PACKAGES = gnuplot-nox texlive-latex-base texlive-latex-recommended texlive-luatex lmodern

deps: ## install the packages to build and test
	@bash tests/support/packages.sh $(BUILD_PACKAGES)

deps-paper: ## install the packages to build and to make the paper
	@bash tests/support/packages.sh $(BUILD_PACKAGES) $(PAPER_PACKAGES)

.PHONY: help paper test smoke evolve data frames figures own-figures figure-files gallery picture keep-data reproduce verify release sensitivity specimens searches readings readings-tables robustness report \
        build program device-files wasm test-wasm signature verify-signature test-pages torture test-cluster benchmarks power bench instructions lint reference architecture format clean deps deps-paper always

# ---- Files -----------------------------------------------------------------------------------------------------------
build/CMakeCache.txt:
	@mkdir -p build
	@cmake -S . -B build > build/configure.log 2>&1 || { cat build/configure.log; rm -f $@; exit 1; }

# GPU=1 builds for graphics processors, too, GPU=0 no longer; without either a build stays as it is.
configure_gpu = $(if $(GPU),cmake -S . -B build -DPLANULA_GPU=$(if $(filter 0,$(GPU)),OFF,ON) > build/configure.log 2>&1 || { cat build/configure.log; exit 1; },true)

# $(call replace_if_changed,NEW,OLD): moves every file of folder NEW to OLD whose content differs, so that what depends
# on an unchanged table is not made again.
replace_if_changed = mkdir -p $(2); for file in $(1)/*; do \
  cmp -s "$$file" "$(2)/$${file\#\#*/}" || mv "$$file" "$(2)/$${file\#\#*/}"; done; rm -rf $(1)

# The design that the tables in build/data show.
$(OUT)/design: always
	@mkdir -p $(OUT)
	@echo '$(EXPERIMENT) $(DESIGN)' | cmp -s - $@ || echo '$(EXPERIMENT) $(DESIGN)' > $@

TABLES = manifest settings worlds runs curves endpoints endpoint_paths endpoint_density archives shape_diversity heredity fitness_shares fitness_history entropy outcomes claims best_genomes columns parameters
WITNESS = witness engines
$(OUT)/reduced: $(PLANULA) $(OUT)/design $(SCRIPTS) $(wildcard $(RUNS)/*/*/manifest.csv)
	@echo 'data: reducing …'
	@rm -rf $(OUT)/data.new
	@$(PLANULA) reduce $(EXPERIMENT) $(DESIGN) --runs $(RUNS) --out $(OUT)/data.new > /dev/null
	@echo 'data: simulating every champion again, at finer time steps and in Bullet …'
	@$(PLANULA) witness $(EXPERIMENT) $(DESIGN) --runs $(RUNS) --out $(OUT)/data.new > /dev/null
	@$(call replace_if_changed,$(OUT)/data.new,$(OUT)/data)
	@touch $@
$(TABLES:%=$(OUT)/data/%.csv) $(WITNESS:%=$(OUT)/data/%.csv) &: $(OUT)/reduced ;

FRAME_TABLES = frames frame_cells frame_links frame_paths frame_terrain morphologies
$(OUT)/framed: $(PLANULA) $(SCRIPTS) $(DATA)/best_genomes.csv
	@echo 'frames: simulating the best again …'
	@rm -rf $(FRAMES).new
	@$(PLANULA) frames $(EXPERIMENT) --data $(DATA) --out $(FRAMES).new > /dev/null
	@$(call replace_if_changed,$(FRAMES).new,$(FRAMES))
	@touch $@
$(FRAME_TABLES:%=$(FRAMES)/%.csv) &: $(OUT)/framed ;

# Figures. Those of animats are pages that a script lays out (PAGES), the others plots of the tables. Cairo writes the date
# of the day; it is replaced by one of equal length.
PAGES = fig01_development fig02_model fig03_oscillator_swimmers fig04_oscillator_walkers fig05_grn_animats
# Those of witness and of readings are drawn where the data have them. Tables that are made here will have the witness's,
# even if they do not exist yet.
WITNESS_TABLES = $(if $(filter $(OUT)/data,$(DATA))$(wildcard $(DATA)/witness.csv),$(WITNESS:%=$(DATA)/%.csv))
PLOTS = $(filter-out $(if $(WITNESS_TABLES),,figR2_witness) $(if $(wildcard $(DATA)/readings.csv),,figR3_readings),$(basename $(notdir $(wildcard paper/figures/fig*.gp))))
FIGURE_FILES = $(PAGES:%=$(FIGURES)/%.pdf) $(PLOTS:%=$(FIGURES)/%.pdf)
STYLE = $(filter-out $(wildcard paper/figures/fig*.gp),$(wildcard paper/figures/*.gp))
# gnuplot's warnings, as of a setting without data, stay in a log unless it fails.
draw = gnuplot -e "$(1); out='$@.new'" $(2) 2> $@.log || { cat $@.log; exit 1; }; \
  LC_ALL=C sed -i 's/^\( *\/CreationDate (D:\)[0-9]*[^)]*/\120151217000000Z/' $@.new; mv $@.new $@
figure-files: $(FIGURE_FILES)

$(PLOTS:%=$(FIGURES)/%.pdf): $(FIGURES)/%.pdf: paper/figures/%.gp $(STYLE) $(TABLES:%=$(DATA)/%.csv) $(WITNESS_TABLES) $(wildcard $(DATA)/readings.csv)
	@mkdir -p $(FIGURES)
	@$(call draw,data='$(DATA)',$<)

$(PAGES:%=$(FIGURES)/%.pdf): $(FIGURES)/%.pdf: $(FIGURES)/%/page.gp $(STYLE)
	@$(call draw,layout='$(FIGURES)/$*',paper/figures/page.gp)

paper/animat.png: $(FIGURES)/portrait/page.gp $(STYLE)
	@gnuplot -e "layout='$(FIGURES)/portrait'; out='$@'; words = 0" paper/figures/page.gp 2> $(FIGURES)/portrait/log
	@echo 'picture: $@'

$(PAGES:%=$(FIGURES)/%/page.gp) $(FIGURES)/portrait/page.gp: $(FIGURES)/%/page.gp: $(wildcard paper/figures/*.lua) \
    paper/csv.lua $(FRAME_TABLES:%=$(FRAMES)/%.csv) $(DATA)/settings.csv $(DATA)/parameters.csv
	@mkdir -p $(FIGURES)/$*
	@texlua paper/figures/$(if $(findstring fig02,$*),scheme.lua,individuals.lua $*) $(FRAMES) $(DATA) $(FIGURES)/$* $(if $(findstring portrait,$*),$(PORTRAIT),$(EXAMPLE))

# The article: typeset twice, for its references. TeX gets the folders of data and figures as two macros. The tables of the
# witness, of sensitivity, of searches, of readings and of robustness are left out where the data have none.
PAPER_SOURCES = $(wildcard paper/*.tex paper/*.lua paper/sections/*.tex paper/decisions/*.md)
$(OUT)/paper.pdf: $(PAPER_SOURCES) $(FIGURE_FILES) $(TABLES:%=$(DATA)/%.csv) \
    $(WITNESS_TABLES) $(wildcard $(DATA)/sensitivity.csv $(DATA)/searches.csv $(DATA)/readings.csv $(DATA)/readings_heredity.csv $(DATA)/robustness.csv tests/power/*.csv)
	@echo 'paper: typesetting …'
	@bash paper/typeset.sh $(OUT) $(DATA) $(FIGURES)
