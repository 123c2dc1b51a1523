#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# slurm.sh SOURCES PROGRAM: 200 samples of 96x96, by one process and by a Slurm array. In the array one worker
# is killed, and its task requeues itself; one job script is killed, and `missing` finds its shards. All tars
# are equal.
. "$(dirname "$0")/../tools/expect.sh"
dermis=$2 cluster=$scratch/cluster set=$scratch/array

status=0
"$root/tools/one_machine_slurm.sh" start "$cluster" || status=$?
[[ $status == 0 ]] || exit "$status"
trap '"$root/tools/one_machine_slurm.sh" stop "$cluster"; rm -rf "$scratch"' EXIT
export SLURM_CONF=$cluster/slurm.conf

cat > "$scratch/recipe.json" << 'END'
{"schema": 1, "name": "faces", "seed": 1, "samples": 200, "samples_per_shard": 10, "views_per_identity": 4,
 "size": [96, 96], "labels": ["depth", "normal", "instance", "region", "matte"],
 "identities": [{"asset": "built-in:light"}, {"asset": "built-in:dark"}],
 "settings": {
  "quality": {"map_size": 256, "shadow_size": 256},
  "camera": {"orbit_deg": [{"normal": [0, 25], "within": [-70, 70]}, {"uniform": [-15, 15]}]},
  "lighting": {"placed_lights": [
    {"azimuth_deg": {"uniform": [-80, 80]}, "irradiance": {"log_uniform": [1, 4]}}]},
  "output": {"exposure_ev": 0}}}
END
hashes() { (cd "$1" && sha256sum ./*.tar); }
# await SECONDS COMMAND...: until the command succeeds
await() {
  local end=$((SECONDS + $1))
  until "${@:2}"; do
    [[ $SECONDS -lt $end ]] || return 1
    sleep 0.3
  done
}

call "$dermis" dataset prepare "$scratch/recipe.json" -o "$scratch/alone"
check "the recipe is prepared" status_is 0
call "$dermis" dataset write "$scratch/alone"
check "one process draws it" status_is 0

call "$dermis" dataset prepare "$scratch/recipe.json" -o "$set"
call "$dermis" dataset slurm "$set" --tasks 4 --minutes 20 -o "$scratch/job.sh"
check "there is a job script" status_is 0
job=$(sbatch --parsable "$scratch/job.sh")

# Processes of the array alone: their command line holds the folder.
worker_of() { pgrep -f "dataset write $set --shard $1" | head -1; }
is_drawing() { [[ -n $(worker_of "$1") ]] && compgen -G "$set/train-$2.tar.*" > /dev/null; }
check "the first task draws" await 400 is_drawing 0-4 000000
check "the second task draws" await 400 is_drawing 5-9 000005
kill -9 "$(worker_of 0-4)"
# Without control groups the worker of a dead script would go on: here both end, as where there are some.
second=$(worker_of 5-9)
kill -9 "$(ps -o ppid= -p "$second" | tr -d ' ')" "$second"

is_over() { [[ -z $(squeue -h -j "$job" 2> /dev/null) ]]; }
check "the array ends" await 1300 is_over
check "the task of the killed worker was requeued" grep -q "ended with 137; requeued" "$set"/slurm-*_0.log
call scontrol show job "${job}_1"
check "the task of the killed script was not" says "Restarts=0"

call "$dermis" dataset missing "$set"
check "missing names shards of the killed script alone" grep -qxE '[5-9](-9)?' "$scratch/output"
call "$dermis" dataset write "$set" --shard "$(cat "$scratch/output")"
check "they are drawn" status_is 0
call "$dermis" dataset missing "$set"
check "nothing is missing" says_nothing

hashes "$scratch/alone" > "$scratch/wanted"
check "20 shards" test "$(wc -l < "$scratch/wanted")" = 20
hashes "$set" > "$scratch/found"
check "all tars are equal" cmp "$scratch/wanted" "$scratch/found"
call "$dermis" dataset verify "$set" --redraw 0.02
check "verify finds nothing" status_is 0
check "verify has drawn four again" says "4 drawn again, 0 faults"

# stub NAME TEXT: a worker of bash, and the job that runs it
stub() {
  printf '#!/bin/bash\n%s\n' "$2" > "$scratch/$1"
  chmod +x "$scratch/$1"
  "$dermis" dataset prepare "$scratch/recipe.json" -o "$scratch/set-$1" > "$scratch/output" 2>&1
  "$dermis" dataset slurm "$scratch/set-$1" --tasks 1 --program "$scratch/$1" -o "$scratch/$1.sh"
  job=$(sbatch --parsable "$scratch/$1.sh")
}
stub full 'exit 75'
is_held() { squeue -h -j "$job" -o %r | grep -q "held state"; }
check "a worker that never can is held" await 400 is_held
check "after three times" test "$(grep -c '75; requeued' "$scratch"/set-full/slurm-*.log)" = 3
check "with a line that says why" grep -q "with 75 for the fourth time; held" "$scratch"/set-full/slurm-*.log
scancel "$job"

# As a minute before the limit.
stub told 'trap "echo ended in order; exit 75" TERM; sleep 60 & wait'
is_running() { [[ $(squeue -h -j "$job" -o %t) == R ]]; }
check "a worker runs" await 200 is_running
sleep 1
scancel --batch --signal=USR1 "$job"
was_requeued() { grep -q '75; requeued' "$scratch"/set-told/slurm-*.log; }
check "one that is told to end is requeued" await 200 was_requeued
check "after it has ended in order" grep -q "ended in order" "$scratch"/set-told/slurm-*.log
scancel "$job"
finish
