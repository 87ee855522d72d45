#!/bin/bash
# SPDX-License-Identifier: MIT
# Prints the specimens of `planula check` in the columns of champion_genomes.csv.gz: of each setting of the tracked runs
# the champion of generation 0 and that of the first 30 generations, however long the runs are. NEAT's come from seed 1,
# novelty search's from seed 3, since both searches begin with the same generation 0.
set -euo pipefail
runs=data/runs/replication

genome_of() { # genome_of RUN GENERATION
    zcat "$1/champion_genomes.csv.gz" | awk -F, -v generation="$2" 'NR > 1 && $1 == generation'
}

header=
for setting in {osc,grn}-{aq,te}-{neat,ns}; do
    case $setting in *-neat) seed=001 ;; *) seed=003 ;; esac
    run=$runs/$setting/seed-$seed
    [[ $header ]] || { header=$(zcat "$run/champion_genomes.csv.gz" | sed -n 1p); echo "$header"; }
    genome_of "$run" 0
    genome_of "$run" "$(awk -F, 'NR > 1 && $1 < 30 { last = $1 } END { print last }' "$run/champions.csv")"
done
