# Runs the experiments on scan matching. Needs common.sh and run_experiments.sh.

MATCHING_PROGRAM=$EXPERIMENTS_TREE/benchmark/matching_experiments
INTEL_LOG=${OMEGA_SLAM_DATA:-}/logs/intel/intel_5505_first1088s_rawodom.clf
declare -A MAPS=() # name -> map_server map

# map_of NAME: the path of its map; empty where there is none.
map_of() {
  case $1 in
    lab) say "$OMEGA_SLAM_ROOT/maps/lab.yaml" ;;
    swarmlab) [[ -z ${OMEGA_SLAM_DATA:-} ]] || say "$OMEGA_SLAM_DATA/maps/swarmlab_map.yaml" ;;
    *) die "There is no map $1, only lab and swarmlab." ;;
  esac
}

# choose_maps NAMES: fills MAPS; without names, with what there is.
choose_maps() {
  local name path names
  IFS=, read -ra names <<<"${1:-lab,swarmlab}"
  for name in "${names[@]}"; do
    path=$(map_of "$name")
    if [[ -f $path ]]; then
      MAPS[$name]=$path
    elif [[ -n $1 ]]; then
      die "The map of $name was not found: OMEGA_SLAM_DATA does not lead to maps/swarmlab_map.yaml."
    else
      say "Without $name: OMEGA_SLAM_DATA does not lead to its map."
    fi
  done
}

# A batch of runs of the program, some at once.
RUNS=0     # how many there will be
BATCH=()   # names of those begun
RUNNING=() # processes of those not yet ended

stop_batch() {
  trap - EXIT INT TERM HUP
  ((${#RUNNING[@]} == 0)) || kill "${RUNNING[@]}" 2>/dev/null || true
  wait
}

# How far the batch is, in thousandths of a run.
thousandths_done() {
  local name line sum=0
  for name in "${BATCH[@]}"; do
    line=$(grep -a '^progress' "$LOG_DIR/experiment_$name.log" | tail -n 1) || true
    if [[ $line =~ ^progress\ ([0-9]+)\ ([0-9]+)$ ]]; then
      sum=$((sum + BASH_REMATCH[1] * 1000 / BASH_REMATCH[2]))
    fi
  done
  say "$sum"
}

# begin NAME ARGUMENT...: a run of the program with these arguments.
begin() {
  local name=$1
  shift
  BATCH+=("$name")
  "$MATCHING_PROGRAM" "$@" --out "$TABLES" >"$LOG_DIR/experiment_$name.log" 2>&1 </dev/null &
  RUNNING+=($!)
}

# Forgets processes that have ended; dies where one has failed.
reap() {
  local process running=()
  for process in "${RUNNING[@]}"; do
    if kill -0 "$process" 2>/dev/null; then
      running+=("$process")
    elif ! wait "$process"; then
      die 'An experiment has failed:' \
        "$(grep -ahv '^progress' "$LOG_DIR"/experiment_*.log | tail -n 3)" \
        "All that was said is in $LOG_DIR/experiment_*.log."
    fi
  done
  RUNNING=("${running[@]}")
}

# wait_for_slots NUMBER: until fewer runs than NUMBER are under way.
wait_for_slots() {
  while ((${#RUNNING[@]} >= $1)); do
    sleep 0.2
    reap
    show_progress 'experiments' $(($(thousandths_done) / RUNS)) 1000 'thousandths'
  done
}

# begin_curves NAME SCANS LEVELS JOBS: all that is drawn against the noise, in one world.
begin_curves() {
  local name=$1 scans=$2 levels=$3 jobs=$4 noise
  local world=(--map "${MAPS[$name]}" --name "$name" --scans "$scans")
  wait_for_slots "$jobs"
  begin "errors_$name" errors "${world[@]}"
  for noise in translation rotation; do
    wait_for_slots "$jobs"
    begin "elimination_${name}_$noise" elimination "${world[@]}" --noise "$noise" --levels "$levels"
  done
}

# begin_consistency NAME PAIRS JOBS: in a world of ours.
begin_consistency() {
  wait_for_slots "$3"
  begin "consistency_$1" consistency --map "$OMEGA_SLAM_ROOT/maps/$1.yaml" --name "$1" --scans "$2"
}

# run_reliability PAIRS: alone on the machine, for its times count.
run_reliability() {
  wait_for_slots 1
  begin reliability_lab reliability --map "$OMEGA_SLAM_ROOT/maps/lab.yaml" --name lab --scans "$1"
  wait_for_slots 1
  if [[ -f $INTEL_LOG ]]; then
    begin reliability_intel reliability --log "$INTEL_LOG" --name intel
    wait_for_slots 1
  fi
}

# run_matching_experiments SCANS LEVELS JOBS
run_matching_experiments() {
  local scans=$1 levels=$2 jobs=$3 name
  new_tables
  RUNS=$((3 * ${#MAPS[@]} + 3))
  [[ ! -f $INTEL_LOG ]] || RUNS=$((RUNS + 1))
  trap stop_batch EXIT
  trap 'exit 130' INT TERM HUP
  for name in "${!MAPS[@]}"; do begin_curves "$name" "$scans" "$levels" "$jobs"; done
  for name in lab office; do begin_consistency "$name" $((10 * scans)) "$jobs"; done
  run_reliability $((5 * scans))
  finish_progress
  trap - EXIT INT TERM HUP
}
