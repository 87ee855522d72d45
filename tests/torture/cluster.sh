#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Runs experiments/slurm.sh under a Slurm that this script starts: two nodes and their controller on this machine, in a
# temporary folder, with ports of their own. 8 settings × 2 seeds run as a job array and are interrupted in every way
# that a cluster has: the time limit, `scancel`, a process killed by the system, a node that goes down and comes back, a
# process that outlives its node, and two tasks that ask for one run. The results must be those of one process, to the
# byte.
#
#   cluster.sh PROGRAM
#
# So that nothing depends on the speed of this machine, planula is held (SIGSTOP) while it works, until the event that
# the test waits for. The time limit is a real one, the shortest that Slurm has: one minute. The signal that is due a
# minute before it therefore comes when the controller next looks at its jobs, which is every 30 seconds.
set -euo pipefail
cd "$(dirname "$0")/../.."
export LC_ALL=C
PATH=$PATH:/usr/sbin
unset "${!SLURM_@}" "${!SBATCH_@}" # of another cluster
skip() { # skip WHY
    echo "cluster: skipped, $1"
    echo 'cluster: 0 passed, 0 failed'
    exit 0
}
for tool in slurmctld slurmd sbatch munged; do
    command -v "$tool" > /dev/null || skip 'slurmctld, slurmd, slurm-client or munge is not installed'
done
getent ahostsv4 127.0.0.1 > /dev/null || skip 'without a network Slurm finds no address, not even that of the loopback'
program=$(realpath "$1")
folder=$(mktemp -d)
export SLURM_CONF=$folder/slurm.conf TMPDIR=$folder/tmp
design=(experiments/paper/replication.lua --population 8 --set development_steps=200 --set locomotion_steps=200)
generations=1000
mkdir "$folder"/{state,n1,n2,log,held,tmp}

# ---- Processes of this test ------------------------------------------------------------------------------------------
# mine [NAME=VALUE]: all processes with this configuration, and NAME=VALUE, in their environment. Some daemons overwrite
# their environment; of those slurmstepd is the parent of a batch script.
mine() {
    local file files
    files=$(grep -lzxF -- "SLURM_CONF=$SLURM_CONF" /proc/[0-9]*/environ 2> /dev/null) || true
    for file in $files; do
        if (($#)) && ! grep -qzxF -- "$1" "$file" 2> /dev/null; then continue; fi
        file=${file#/proc/} file=${file%/environ}
        # Without the processes of this search, which have ended.
        if [[ $file != "$$" && -d /proc/$file ]]; then echo "$file"; fi
    done
}
name_of() { cat "/proc/$1/comm" 2> /dev/null || true; }
# stepds PID…: the slurmstepd processes that are parents of these.
stepds() {
    local pid parent
    for pid in "$@"; do
        parent=$(awk '$1 == "PPid:" { print $2 }' "/proc/$pid/status" 2> /dev/null || true)
        [[ $(name_of "${parent:-0}") != slurmstepd* ]] || echo "$parent"
    done | sort -u
}
# children PID…: the processes that these have started.
children() { awk -v parents=" $* " '$1 == "PPid:" && index(parents, " " $2 " ") { split(FILENAME, part, "/"); print part[3] }' \
    /proc/[0-9]*/status 2> /dev/null || true; }
# kill_all PID…: first the daemons that watch jobs, which would report how these ended.
kill_all() {
    local steps
    mapfile -t steps < <(stepds "$@")
    kill -KILL "${steps[@]}" "$@" 2> /dev/null || true
}
daemons=()
start() { # start WORD…: a daemon
    "$@" > /dev/null 2>> "$folder/log/daemons" &
    started=$!
    daemons+=("$started")
    disown "$started"
}
lives() { [[ $(awk '$1 == "State:" { print $2 }' "/proc/$1/status" 2> /dev/null || true) == [!Z] ]]; }
# stop_all: ends all processes of this test, and fails if one is left.
stop_all() {
    local pid pids ended=("${daemons[@]}") tries=0
    mapfile -t pids < <(children "${daemons[@]}" && mine)
    mapfile -t -O "${#pids[@]}" pids < <(stepds "${pids[@]}")
    ended+=("${pids[@]}")
    kill_all "${ended[@]}"
    for pid in "${ended[@]}"; do
        while lives "$pid"; do
            ((tries++ < 100)) || { echo "process $pid is left: $(name_of "$pid")" && return 1; }
            kill -KILL "$pid" 2> /dev/null || true
            sleep 0.1
        done
    done
    mapfile -t pids < <(mine)
    ((${#pids[@]} == 0)) || { echo "processes are left: ${pids[*]}" && return 1; }
}
end() {
    local code=$?
    trap - EXIT
    set +e
    [[ -n ${stopped-} ]] || stop_all > /dev/null || stop_all
    if ((code)) && [[ -n ${KEEP-} ]]; then echo "cluster: see $folder"; else rm -rf "$folder"; fi
    exit "$code"
}
trap end EXIT
trap 'exit 130' INT TERM

# ---- Checks ----------------------------------------------------------------------------------------------------------
passed=0 failed=0
began=$SECONDS
check() { # check WHAT WORD…: a command that must succeed
    local what=$1
    shift
    if "$@" > "$folder/said" 2>&1; then
        passed=$((passed + 1))
    else
        failed=$((failed + 1))
        echo "cluster: FAILED after $((SECONDS - began)) s: $what"
        tail -n 20 "$folder/said"
    fi
}
need() { # need WHAT WORD…: the same, without which the rest makes no sense
    local before=$failed
    check "$@"
    ((failed == before)) || { echo "cluster: $passed passed, $failed failed" && exit 1; }
}
within() { # within SECONDS WORD…: until a command succeeds
    local last=$((SECONDS + $1))
    shift
    until "$@" > "$folder/last"; do
        ((SECONDS < last)) || { cat "$folder/last" && echo "not within its time: $*" && return 1; }
        sleep 0.2
    done
}
is() { [[ $1 == "$2" ]] || { echo "'$1', not '$2'" && return 1; }; }
log_of() { echo "$folder/log/$1_$2.log"; } # log_of JOB TASK
says() { grep -q -- "$2" "$1" 2> /dev/null; } # says FILE WORDS
all_say() { # all_say WORDS FILE…
    local words=$1 file
    shift
    for file in "$@"; do says "$file" "$words" || { echo "${file##*/} does not say '$words'" && return 1; }; done
}
state_of() { scontrol show job "$1" | sed -nE 's/^ *JobState=([A-Z_]+) .*/\1/p'; }    # of one task
exit_of() { scontrol show job "$1" | sed -nE 's/.* ExitCode=([0-9:]+).*/\1/p'; }
has_state() { [[ $(state_of "$1") == "$2" ]]; }

# ---- Held processes --------------------------------------------------------------------------------------------------
# The program that the tasks run: planula, held in the first HOLD starts of the task as soon as it has worked for 200 ms.
# To read the script takes less, also on a busy machine; to end the run takes more.
# The number of its process is in the name of a file then.
cat > "$folder/planula" << END
#!/usr/bin/env bash
trap '' HUP # see below, where a node goes down
if ((\${SLURM_RESTART_COUNT:-0} < \${HOLD:-0})); then
    while read -ra stat < "/proc/\$\$/stat"; do
        if ((stat[13] + stat[14] >= 20)); then
            kill -STOP \$\$ && : > "$folder/held/\${SLURM_ARRAY_JOB_ID}_\$SLURM_ARRAY_TASK_ID.\$\$"
            break
        fi
        sleep 0.05
    done < /dev/null > /dev/null 2>&1 &
fi
exec "$program" "\$@"
END
chmod +x "$folder/planula"
held() { # held [START]: the processes that are held, of all tasks JOB_TASK or of those whose name begins so
    local file
    for file in "$folder"/held/"${1-}"*; do
        if [[ -e $file && -d /proc/${file##*.} ]]; then echo "${file##*.}"; fi
    done
}
are_held() { # are_held NUMBER
    local pids
    mapfile -t pids < <(held)
    is "${#pids[@]}" "$1"
}
# Processes to which USR1 was sent continue.
release_signalled() {
    local pid pending
    for pid in $(held); do
        pending=$(awk '$1 == "ShdPnd:" { print $2 }' "/proc/$pid/status" 2> /dev/null || true)
        if ((0x${pending:-0} & 0x200)); then release "$pid"; fi
    done
}
release() { # release PID…
    kill -CONT "$@"
    local pid
    for pid in "$@"; do rm -f "$folder"/held/*."$pid"; done
}

# ---- The cluster -----------------------------------------------------------------------------------------------------
# Slurm listens at the address of the machine's name, so that nothing leaves the machine; at any address if the name has
# none.
host=$(hostname -s) user=$(id -un)
address=$(getent ahostsv4 "$host" | awk 'NR == 1 { print $1 }') || true
listen=CommunicationParameters=NoCtldInAddrAny,NoInAddrAny
[[ -n $address ]] || address=127.0.0.1 listen=''
is_free() { ! (: < "/dev/tcp/$address/$1") 2> /dev/null; }
port=$((20000 + RANDOM % 10000))
until is_free "$port" && is_free $((port + 1)) && is_free $((port + 2)); do port=$((port + 3)); done
# A requeued job waits as long as a credential is valid: 5 seconds instead of 120. Nodes claim more processors than
# there are.
cat > "$SLURM_CONF" << END
ClusterName=planula
SlurmctldHost=$host($address)
SlurmctldPort=$port
SlurmUser=$user
SlurmdUser=$user
AuthType=auth/munge
CredType=cred/munge
AuthInfo=socket=$folder/munge.socket,cred_expire=5
$listen
StateSaveLocation=$folder/state
SlurmdSpoolDir=$folder/%n
SlurmctldPidFile=$folder/slurmctld.pid
SlurmdPidFile=$folder/%n.pid
SlurmctldLogFile=$folder/log/slurmctld
SlurmdLogFile=$folder/log/slurmd-%n
ProctrackType=proctrack/pgid
TaskPlugin=task/none
SwitchType=switch/none
MpiDefault=none
MailProg=/bin/true
JobAcctGatherType=jobacct_gather/none
AccountingStorageType=accounting_storage/none
SelectType=select/cons_tres
SelectTypeParameters=CR_Core_Memory
SchedulerParameters=sched_interval=1,sched_min_interval=0,batch_sched_delay=0
SlurmdParameters=config_overrides
OverTimeLimit=0
KillWait=5
NodeName=n1 NodeHostname=$host NodeAddr=$address Port=$((port + 1)) CPUs=20 RealMemory=20000 State=UNKNOWN
NodeName=n2 NodeHostname=$host NodeAddr=$address Port=$((port + 2)) CPUs=20 RealMemory=20000 State=UNKNOWN
PartitionName=main Nodes=n1,n2 Default=YES MaxTime=INFINITE State=UP LLN=YES
END
head -c 1024 /dev/urandom > "$folder/munge.key"
chmod 400 "$folder/munge.key"
start munged --foreground --force --socket="$folder/munge.socket" --key-file="$folder/munge.key" --log-file="$folder/munge.log" \
    --pid-file="$folder/munged.pid" --seed-file="$folder/munge.seed"
within 10 test -S "$folder/munge.socket" > "$folder/said" || skip 'munge does not start'
start slurmctld -D
start slurmd -D -N n1
start slurmd -D -N n2
second_node=$started
nodes_are_idle() { is "$(sinfo -h -N -o %t 2> /dev/null | sort -u)" idle > /dev/null; }
within 20 nodes_are_idle > "$folder/said" || { cat "$folder/log/daemons" && echo 'cluster: Slurm does not start' && exit 1; }

# submit OPTION… -- WORD…: prints the number of the job; options of sbatch, then of the script.
submit() {
    local options=()
    while [[ $1 != -- ]]; do options+=("$1") && shift; done
    shift
    PLANULA=$folder/planula sbatch --parsable --time=1 --output="$folder/log/%A_%a.log" "${options[@]}" \
        experiments/slurm.sh "${design[@]}" --levels "100,$generations" "$@"
}

# ---- Time limits, and two tasks that ask for one run -----------------------------------------------------------------
main=$(HOLD=2 submit --array=1-16 -- --seeds 1:2 --out "$folder/a")
one=$(HOLD=2 PATIENCE=5 submit --array=1 -- --seeds 3 --only osc-aq-ns --out "$folder/b")
two=$(HOLD=2 PATIENCE=5 submit --array=1 -- --seeds 3 --only osc-aq-ns --out "$folder/b")
main_logs=("$folder/log/${main}"_{1..16}.log)
need 'every task begins to work, and one of two that ask for the same run' within 30 are_held 17

# Meanwhile one process makes the same runs.
one_process() {
    "$program" run "${design[@]}" --generations "$generations" --seeds 1:2 --out "$folder/whole" &&
        "$program" run "${design[@]}" --generations "$generations" --seeds 3 --only osc-aq-ns --out "$folder/whole"
}
one_process > "$folder/log/whole" 2>&1 &
whole=$!

lost='another process has the run'
one_has_lost() { says "$(log_of "$one" 1)" "$lost" || says "$(log_of "$two" 1)" "$lost"; }
few=$(submit --array=3 -- --seeds 1:2 --out "$folder/a")
check 'the other task ends and says why' within 30 one_has_lost
loser=$one winner=$two
if says "$(log_of "$two" 1)" "$lost"; then loser=$two winner=$one; fi
check 'its state is FAILED' within 10 has_state "${loser}_1" FAILED
check 'its exit code is 73' is "$(exit_of "${loser}_1")" 73:0
check 'an array that is not 1 to N is refused without PARTS' within 10 has_state "${few}_3" FAILED
check 'with the exit code of a usage error' is "$(exit_of "${few}_3")" 2:0

kept='stopped before the time limit; its state is kept'
all_are_stopped() { release_signalled && all_say "$kept" "${main_logs[@]}" "$(log_of "$winner" 1)"; }
need 'the time limit interrupts every task, and its state is kept' within 60 all_are_stopped
need 'every task is requeued and continues' within 60 are_held 17
check 'it is the second start of every task' all_say ': start 2 on ' "${main_logs[@]}"
check 'the task that lost is not requeued' is "$(grep -c ': start ' "$(log_of "$loser" 1)")" 1

# ---- A cancelled task, and one whose process the system kills ---------------------------------------------------------
mapfile -t first < <(squeue -h -r -w n1 -o %i | grep "^${main}_" | head -n 2)
mapfile -t second < <(squeue -h -r -w n2 -o %i | grep "^${main}_")
need 'both nodes have tasks' test "${#first[@]}" -eq 2 -a "${#second[@]}" -ge 2
scancel "${first[0]}"
check 'scancel ends a task' within 20 has_state "${first[0]}" CANCELLED
check 'which keeps its state' within 10 says "$folder/log/${first[0]}.log" 'cancelled; its state is kept'
mapfile -t pids < <(held "${first[1]}.")
kill -KILL "${pids[@]}"
check 'a killed process ends its task' within 20 has_state "${first[1]}" FAILED
check 'with the exit code of its process' is "$(exit_of "${first[1]}")" 137:0
again=$(PARTS=16 submit --array="${first[0]#*_},${first[1]#*_}" -- --seeds 1:2 --out "$folder/a")

# ---- A node goes down; one of its processes does not die with it -----------------------------------------------------
mapfile -t stray < <(held "${second[0]}.")
mapfile -t pids < <(mine SLURMD_NODENAME=n2 | grep -vxF "${stray[0]}")
kill -KILL "$second_node"
kill_all "${pids[@]}"
# The kernel continues a stopped process when its parents are gone: HUP, then CONT.
for _ in {1..50}; do kill -STOP "${stray[0]}" && sleep 0.01; done
scontrol update nodename=n2 state=down reason=test
# The wait for that process must not end by the time limit.
scontrol update jobid="${second[0]}" timelimit=10
mapfile -t pids < <(held | grep -vxF "${stray[0]}")
release "${pids[@]}"
requeued=("${second[@]/%/.log}")
requeued=("${requeued[@]/#/$folder/log/}")
check 'all tasks of a node that goes down are started again' within 60 all_say ': start 3 on n1' "${requeued[@]}"
check 'the one whose old process still has the run waits' within 20 says "${requeued[0]}" 'in use by another process'
kill -KILL "${stray[@]}"
start slurmd -D -N n2
scontrol update nodename=n2 state=resume
node_is_up() { [[ $(sinfo -h -n n2 -o %t) =~ ^(idle|mix|alloc)$ ]]; }
check 'the node comes back' within 20 node_is_up

# ---- The end ---------------------------------------------------------------------------------------------------------
all_is_done() {
    if ! "$program" status "$folder/a" > "$folder/status" 2>&1 || says "$folder/status" 'cannot'; then
        cat "$folder/status" >> "$folder/log/status"
    fi
    [[ -z $(squeue -h -o %i) ]]
}
check 'all tasks end' within 120 all_is_done
check 'planula status worked at all times' test ! -e "$folder/log/status"
ends() { # ends TASK…: with a task that is done
    local task
    for task in "$@"; do
        if ! has_state "$task" COMPLETED || ! says "$folder/log/$task.log" ': done$'; then
            state_of "$task"
            cat "$folder/log/$task.log"
            return 1
        fi
    done
}
mapfile -t rest < <(printf "${main}_%d\n" {1..16} | grep -vxF -e "${first[0]}" -e "${first[1]}")
check 'every task is done' ends "${rest[@]}" "${winner}_1" "${again}_${first[0]#*_}" "${again}_${first[1]#*_}"
check 'one process is done' wait "$whole"
check 'the runs of two folders can be merged' "$program" merge "$folder/a" "$folder/b" --into "$folder/merged"
check 'they equal those of one process to the byte' diff -r "$folder/whole" "$folder/merged"
tables() { "$program" reduce "${design[@]}" --seeds 1:2 --generations "$generations" --runs "$folder/$1" --out "$folder/$1-tables"; }
check 'they are reduced to tables' tables merged
check 'those of one process are too' tables whole
check 'the tables are equal' diff -r "$folder/whole-tables" "$folder/merged-tables"
left=$(find "$folder/a" "$folder/b" -path '*/progress/*')
check 'no progress file is left' is "$left" ''
check 'nothing is left running' stop_all
stopped=yes

starts=$(cat "$folder"/log/*_*.log | grep -c ': start ')
echo "cluster: 17 runs in 21 tasks and $starts starts, $((SECONDS - began)) s"
echo "cluster: $passed passed, $failed failed"
((failed == 0))
