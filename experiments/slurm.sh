#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# A design as a Slurm job array: task I of N runs every Nth run of the design, beginning with the Ith.
#
#   sbatch --array=1-N experiments/slurm.sh FILE.lua [OPTION]...
#
# from the folder of planula; the options are those of `planula run` except --part and --threads. All tasks may share
# one --out on a file system that all nodes see, or have one on each node: `planula merge` gathers them. In the second
# case a task that is requeued to another node starts its run again there, unless --nodelist holds it where it was.
#
# - Time limit: Slurm signals this script a minute before, planula stops and keeps its state, and the task is requeued.
# - A node that fails: Slurm requeues the task, and planula resumes from the last checkpoint.
# - `scancel`: planula keeps its state, and the task ends. The same sbatch line resumes it; to submit single
#   tasks again, say how many there are in all: PARTS=16 sbatch --array=3,7 …
# - A run that another process works on: the task waits up to PATIENCE seconds (120), because a process of a task
#   that was requeued may be about to end. Then it ends with exit code 73, without requeueing: the other process has
#   the run.
#
# PLANULA names another program than build/planula. What follows can be set otherwise on the sbatch line. A run takes
# one core and some 60 MB at a population of 300; with more cores than runs a task is faster, but not by as much.
#SBATCH --job-name=planula
#SBATCH --time=04:00:00
#SBATCH --signal=B:USR1@60
#SBATCH --requeue
#SBATCH --open-mode=append
#SBATCH --cpus-per-task=1
#SBATCH --mem-per-cpu=500M
set -uo pipefail

child='' stopped='' cancelled=''
# stop SIGNAL: asks planula to stop, once: it would die of a second signal of the same kind. Slurm sends USR1 to this
# script alone, and TERM to all processes of a task that it cancels, so that TERM is passed on as USR1.
stop() {
    [[ $1 != TERM ]] || cancelled=yes
    [[ -n $stopped || -z $child ]] || kill -USR1 "$child" 2> /dev/null
    stopped=yes
}
trap 'stop USR1' USR1
trap 'stop TERM' TERM

task=${SLURM_ARRAY_TASK_ID:-1}
tasks=${PARTS:-${SLURM_ARRAY_TASK_MAX:-1}}
say() { echo "slurm: task $task of $tasks: $*" >&2; }
# The number of the last task is that of all tasks only if they are 1 to N.
if [[ -z ${PARTS:-} && ${SLURM_ARRAY_TASK_MIN:-1}-${SLURM_ARRAY_TASK_COUNT:-1} != 1-$tasks ]]; then
    say "the tasks of this array are not 1 to N: set PARTS to how many there are in all, as PARTS=16 sbatch --array=3,7 …"
    exit 2
fi
# Of an array the number of the job alone would mean all tasks.
job=${SLURM_ARRAY_JOB_ID:+${SLURM_ARRAY_JOB_ID}_}${SLURM_ARRAY_TASK_ID:-${SLURM_JOB_ID:-}}
command=("${PLANULA:-build/planula}" run "$@" --part "$task:$tasks" --threads "${SLURM_CPUS_PER_TASK:-1}")
said=$(mktemp) || exit 73
trap 'rm -f "$said"' EXIT

# run_planula: sets `code`; what planula says goes to the log of the task and to the file $said.
run_planula() {
    local tee
    exec 3> >(trap '' USR1 TERM && exec tee "$said" >&2)
    tee=$!
    "${command[@]}" 2>&3 3>&- &
    child=$!
    exec 3>&-
    [[ -z $stopped ]] || kill -USR1 "$child" 2> /dev/null
    # A signal ends `wait` before the process has ended.
    while kill -0 "$child" 2> /dev/null; do wait "$child"; done
    wait "$child"
    code=$?
    child=''
    while kill -0 "$tee" 2> /dev/null; do wait "$tee"; done
}

say "start $((${SLURM_RESTART_COUNT:-0} + 1)) on ${SLURMD_NODENAME:-$HOSTNAME}"
in_use() { ((code == 73)) && grep -q 'is in use by another process' "$said"; }
code=75 since=''
[[ -n $stopped ]] || run_planula
while in_use; do
    since=${since:-$SECONDS}
    if [[ -n $stopped ]] || ((SECONDS - since >= ${PATIENCE:-120})); then
        say "another process has the run, and goes on with it; nothing is lost, and this task ends"
        exit 73
    fi
    sleep 5 &
    wait $!
    [[ -n $stopped ]] || run_planula
done

case $code in
    0) say "done" ;;
    75 | 138) # 138: died of USR1, before it could listen
        if [[ -n $cancelled ]]; then
            say "cancelled; its state is kept, and the same sbatch line resumes it"
            exit 75
        fi
        say "stopped before the time limit; its state is kept, and it is requeued"
        rm -f "$said"
        # Slurm may end this script before scontrol does.
        if ! scontrol requeue "$job" && [[ -z $cancelled ]]; then
            say "could not be requeued; the same sbatch line resumes it"
            exit 75
        fi
        ;;
    *)
        say "planula ended with exit code $code"
        exit "$code"
        ;;
esac
